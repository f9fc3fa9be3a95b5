# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the wheel needs: the very VTK whose SDK it is built with. See pyproject.toml."""

from importlib import metadata


def dynamic_metadata(_settings, _project):
    return {"dependencies": ["numpy", f"vtk=={metadata.version('vtk-sdk')}"]}
