# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command pellucid-render of a wheel."""

import pathlib
import subprocess
import sys


def main():
    """Run the program of the wheel with the arguments of this one, and end as it does."""
    program = pathlib.Path(__file__).parent / "bin" / "pellucid-render"
    sys.exit(subprocess.call([program, *sys.argv[1:]]))
