# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two processes that each hold a part of the data draw the picture that one draws."""

import os
import pathlib
import shutil
import unittest

from vtkmodules.test import Testing

from pictures import read_png
from processes import HERE, program, run

TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)


def draw(name, partitions, *launcher):
    """Draw; the picture, and the number of fragments of the first process."""
    path = TEMPORARY / f"{name}.png"
    said = run(*launcher, program("pvbatch"), HERE / "draw_distributed.py", path)
    assert f"partitions: {partitions}" in said, said
    return read_png(path), int(said.rsplit("fragments:", 1)[1])


class TestPluginParallel(unittest.TestCase):
    def test_two_processes_draw_the_picture_of_one(self):
        mpirun = shutil.which("mpirun")
        if not mpirun:
            self.skipTest("mpirun is not installed: parallel rendering is not tested")
        launcher = [mpirun, "--oversubscribe", "-n", "2"]
        if os.geteuid() == 0:
            launcher.append("--allow-run-as-root")
        expected, all_fragments = draw("one", 1)
        found, fragments = draw("two", 2, *launcher)
        self.assertGreater(fragments, 0.2 * all_fragments)
        self.assertLess(fragments, 0.8 * all_fragments)
        self.assertEqual(found.shape, expected.shape)
        different = abs(found - expected).max(axis=2)
        # Each process rounds its part to 8 bits. A tube that ends in one part reaches into the other by its
        # radius, where the parts are in the wrong order.
        self.assertLess((different > 2).mean(), 0.003)
        self.assertLess(different.max(), 60)


if __name__ == "__main__":
    unittest.main()
