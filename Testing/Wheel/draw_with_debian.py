# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Run an example with the last PyVista that takes Debian's VTK 9.2: draw_with_debian.py EXAMPLE PICTURE"""

import functools
import runpy
import sys

import pyvista

# Today's PyVista ends streamlines by their length; that one by a time, which is too short here.
pyvista.DataSetFilters.streamlines_from_source = functools.partialmethod(
    pyvista.DataSetFilters.streamlines_from_source, max_time=1000.0)

sys.argv.pop(0)
runpy.run_path(sys.argv[0], run_name="__main__")
