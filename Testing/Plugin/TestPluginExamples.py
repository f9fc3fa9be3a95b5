# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each example draws the same picture by its script and by its state file, bit for bit."""

import pathlib
import unittest

from vtkmodules.test import Testing

from pictures import assert_same_picture
from processes import PLUGIN, program, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "Plugin" / "Examples"
BASELINES = ROOT / "Testing" / "Data" / "Baseline"
TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)

# In another folder than the one that the state's files are relative to.
LOAD_STATE = """
import sys
from paraview import simple
simple.LoadState(sys.argv[1], data_directory=sys.argv[2], restrict_to_data_directory=True)
view = simple.GetRenderViews()[0]
simple.SaveScreenshot(sys.argv[3], view, ImageResolution=list(view.ViewSize))
"""


def pvpython(*arguments, folder):
    """Run a script as a user does who has the plugin in PV_PLUGIN_PATH."""
    run(
        program("pvpython"),
        *arguments,
        environment={"PV_PLUGIN_PATH": str(PLUGIN.parent)},
        folder=folder,
    )


class TestPluginExamples(unittest.TestCase):
    def check(self, name):
        by_script, by_state = TEMPORARY / f"{name}.png", TEMPORARY / f"{name}-state.png"
        load = TEMPORARY / "load_state.py"
        load.write_text(LOAD_STATE)
        pvpython(EXAMPLES / f"{name}.py", by_script, folder=ROOT)
        pvpython(load, EXAMPLES / f"{name}.pvsm", ROOT / "Data", by_state, folder=TEMPORARY)
        assert_same_picture(str(by_script), str(by_state), tolerance=1e-9)
        baseline = BASELINES / f"TestPluginExamples-{name}.png"
        assert_same_picture(str(baseline), str(by_script), tolerance=5.0)

    def test_states_name_files_of_the_repository(self):
        for state in EXAMPLES.glob("*.pvsm"):
            self.assertIn('value="Data/', state.read_text())
            self.assertNotIn(str(ROOT), state.read_text())

    def test_air_rises(self):
        self.check("rising_air")

    def test_vortices_show_through(self):
        self.check("vortices")

    def test_a_surface_shows_its_inside(self):
        self.check("lines_in_surface")


if __name__ == "__main__":
    unittest.main()
