# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin loads from where it was built, from where it is installed, and by PV_PLUGIN_PATH."""

import os
import pathlib
import unittest

from vtkmodules.test import Testing

from pictures import read_png
from processes import HERE, PLUGIN, program, run

TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)
INSTALLED = pathlib.Path(os.environ["PELLUCID_INSTALLED_PLUGIN"])
INSTALLED_PYTHON = os.environ["PELLUCID_INSTALLED_PYTHON"]


class TestPluginLoading(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected = cls.draw("built")

    @classmethod
    def draw(cls, name, *options, **environment):
        run(program("pvbatch"), HERE / "draw.py", TEMPORARY / name, *options, environment=environment)
        return read_png(TEMPORARY / name / "opaque.png")

    def assert_draws(self, name, *options, **environment):
        found = self.draw(name, *options, **environment)
        self.assertEqual(found.shape, self.expected.shape)
        self.assertEqual(int((found != self.expected).sum()), 0)

    def installed_python(self):
        """The search path of Python with the installed package in place of the built one."""
        _, *others = os.environ["PYTHONPATH"].split(os.pathsep)
        return os.pathsep.join([INSTALLED_PYTHON, *others])

    def test_the_installed_plugin_draws_the_same(self):
        self.assertTrue(INSTALLED.is_file(), INSTALLED)
        self.assert_draws(
            "installed", PELLUCID_PLUGIN=str(INSTALLED), PYTHONPATH=self.installed_python()
        )

    def test_the_built_plugin_loads_from_the_search_path(self):
        self.assert_draws("searched", "--loaded", PV_PLUGIN_PATH=str(PLUGIN.parent))

    def test_the_installed_plugin_loads_from_the_search_path(self):
        self.assert_draws(
            "installed_searched",
            "--loaded",
            PV_PLUGIN_PATH=str(INSTALLED.parent),
            PYTHONPATH=self.installed_python(),
        )


if __name__ == "__main__":
    unittest.main()
