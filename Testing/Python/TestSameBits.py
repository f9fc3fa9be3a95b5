#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-render writes the same picture on every run, with any number of threads."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["PELLUCID_RENDER"]
LINES = pathlib.Path(__file__).resolve().parents[2] / "Data" / "combustor-lines.vtk"


def render(threads, *options):
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.png"
        # Threads of Mesa's software renderer, 0 for the calling one alone, and of VTK.
        environment = dict(os.environ, LP_NUM_THREADS=str(threads - 1), VTK_SMP_MAX_THREADS=str(threads))
        subprocess.run([PROGRAM, str(LINES), "-o", str(picture), "--size", "320x240", *options],
                       check=True, env=environment)
        return picture.read_bytes()


class TestSameBits(unittest.TestCase):
    def test_threads(self):
        first = render(2)
        for threads in (1, 2, 3):
            self.assertEqual(render(threads), first, f"{threads} threads")

    def test_memory_limit(self):
        self.assertEqual(render(2, "--memory-limit", "1"), render(2))

    def test_reference(self):
        self.assertEqual(render(1, "--reference"), render(2, "--reference"))


if __name__ == "__main__":
    unittest.main()
