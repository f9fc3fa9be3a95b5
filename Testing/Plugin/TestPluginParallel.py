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


class TestPluginParallel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        mpirun = shutil.which("mpirun")
        if not mpirun:
            raise unittest.SkipTest("mpirun is not installed: parallel rendering is not tested")
        cls.launcher = [mpirun, "--oversubscribe", "-n", "2"]
        if os.geteuid() == 0:
            cls.launcher.append("--allow-run-as-root")
        cls.expected, cls.fragments = cls.draw("one", 1, [], 1)

    @staticmethod
    def draw(name, partitions, launcher, on_one_process):
        """Draw; the picture, and the number of fragments of the first process."""
        path = TEMPORARY / f"{name}.png"
        said = run(*launcher, program("pvbatch"), HERE / "draw_distributed.py", path, on_one_process)
        assert f"partitions: {partitions}" in said, said
        return read_png(path), int(said.rsplit("fragments:", 1)[1])

    def differences(self, found):
        self.assertEqual(found.shape, self.expected.shape)
        return abs(found - self.expected).max(axis=2)

    def test_the_first_process_draws_the_picture_of_one(self):
        found, fragments = self.draw("first", 2, self.launcher, 1)
        self.assertEqual(fragments, self.fragments)
        self.assertLessEqual(self.differences(found).max(), 1)

    def test_distributed_data_give_the_picture_of_one(self):
        found, fragments = self.draw("distributed", 2, self.launcher, 0)
        self.assertGreater(fragments, 0.2 * self.fragments)
        self.assertLess(fragments, 0.8 * self.fragments)
        # A tube that ends in one part reaches into the other by its radius, where the parts are in the
        # wrong order.
        different = self.differences(found)
        self.assertLess((different > 2).mean(), 0.003)
        self.assertLess(different.max(), 60)


if __name__ == "__main__":
    unittest.main()
