# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Run a file of unit tests with VTK's testing options: run.py TestX.py -D ... -T ... -V ... -B ...

The options are read by vtkmodules.test.Testing, whose compareImage() and VTK_TEMP_DIR the tests use.
"""

import importlib
import pathlib
import sys
import unittest

from vtkmodules.test import Testing

path = pathlib.Path(sys.argv.pop(1))
Testing.processCmdLine()
sys.path.insert(0, str(path.parent))
unittest.main(importlib.import_module(path.stem), argv=[path.name])
