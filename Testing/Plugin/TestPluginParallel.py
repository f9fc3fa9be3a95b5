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


MPIRUN = shutil.which("mpirun")


def draw(processes, sees_all, *options):
    """Draw; the picture, and the number of fragments of the first process."""
    path = TEMPORARY / f"parallel{processes}{''.join(options)}.png"
    launcher = []
    if processes > 1:
        launcher = [MPIRUN, "--oversubscribe", "-n", processes]
    if processes > 1 and os.geteuid() == 0:
        launcher.append("--allow-run-as-root")
    said = run(*launcher, program("pvbatch"), HERE / "draw_distributed.py", path, *options)
    assert f"partitions: {processes}" in said, said
    assert f"sees all fragments: {sees_all}" in said, said
    return read_png(path), int(said.rsplit("fragments:", 1)[1])


@unittest.skipUnless(MPIRUN, "mpirun is not installed: parallel rendering is not tested")
class TestPluginParallel(unittest.TestCase):
    def test_one_of_several_processes_draws_all(self):
        expected, all_fragments = draw(1, 1)
        found, fragments = draw(2, 1)
        self.assertEqual(fragments, all_fragments)
        self.assertLessEqual(abs(found - expected).max(), 1)

    def test_two_processes_draw_their_parts(self):
        expected, all_fragments = draw(1, 1, "--in-parts")
        found, fragments = draw(2, 0, "--in-parts")
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
