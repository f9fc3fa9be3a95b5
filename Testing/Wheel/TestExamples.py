# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel's examples and program draw what the build for Debian's VTK has drawn, bit by bit.

The examples draw the pictures of README.md.

PELLUCID_EXPECTED is the folder with those pictures; `TestExamples.py draw PROGRAM` makes the program's.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "Rendering/Python/Examples").glob("*.py"))
VIEWS = {
    "lines": "combustor-lines.vtk --opacity 0.4 --color-by Velocity",
    "optimised": "combustor-lines.vtk --optimize --color-by Velocity",
    "field": "combustor.vtk --seeds 200",
    "tracts": "fornix.trk --opacity 0.3",
    "weather": "pacific-streams.nc --vertical-scale 20 --importance TotalPressureDifference:0:550",
}


def render_command(program, view, picture):
    file, *options = VIEWS[view].split()
    return [program, str(ROOT / "Data" / file), "-o", str(picture), "--size", "320x240", *options]


class TestExamples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.expected = pathlib.Path(os.environ["PELLUCID_EXPECTED"])

    def assert_draws(self, command, name):
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotRegex(done.stderr, r"ERR\||WARN\||Traceback|Mesa: ")
        found = (self.folder / name).read_bytes()
        if found != (self.expected / name).read_bytes():
            from pictures import read_png
            difference = abs(read_png(self.folder / name) - read_png(self.expected / name))
            # Writers of PNG differ; what they write does not.
            self.assertEqual(difference.max(), 0, f"{name}: {(difference > 0).mean():.2%} differ")

    def test_examples(self):
        from pictures import assert_same_picture
        self.assertGreaterEqual(len(EXAMPLES), 6)
        for example in EXAMPLES:
            with self.subTest(example=example.name):
                name = example.with_suffix(".png").name
                self.assert_draws([sys.executable, str(example), str(self.folder / name)], name)
                assert_same_picture(ROOT / "Data/Pictures" / f"example-{name}", self.folder / name)

    def test_program(self):
        program = str(pathlib.Path(sys.executable).with_name("pellucid-render"))
        for view in VIEWS:
            with self.subTest(view=view):
                name = f"program-{view}.png"
                self.assert_draws(render_command(program, view, self.folder / name), name)


if __name__ == "__main__":
    if sys.argv[1:2] == ["draw"]:
        # draw PROGRAM: the program's pictures into PELLUCID_EXPECTED.
        for view in VIEWS:
            picture = pathlib.Path(os.environ["PELLUCID_EXPECTED"], f"program-{view}.png")
            subprocess.run(render_command(sys.argv[2], view, picture), check=True)
    else:
        unittest.main()
