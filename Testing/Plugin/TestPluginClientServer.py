# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A server draws the picture that ParaView draws without one, and so does the client of a server."""

import json
import pathlib
import re
import unittest

from vtkmodules.test import Testing

from pictures import read_png
from processes import HERE, program, run, server

TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)


def draw(name, *options):
    """Draw the scene; its pictures, how many fragments the program itself has drawn, and the statistics."""
    # pvbatch cannot connect to a server.
    said = run(program("pvpython"), HERE / "draw.py", TEMPORARY / name, *options)
    pictures = [read_png(TEMPORARY / name / f"{each}.png") for each in ("opaque", "transparent")]
    statistics = json.loads(re.search("^statistics: (.*)$", said, re.MULTILINE)[1])
    return pictures, int(said.rsplit("fragments:", 1)[1]), statistics


class TestPluginClientServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected, cls.fragments, cls.statistics = draw("builtin")

    def assert_expected(self, pictures, statistics):
        self.assertEqual(statistics, self.statistics)
        for found, expected in zip(pictures, self.expected):
            self.assertEqual(found.shape, expected.shape)
            self.assertEqual((found != expected).any(axis=2).sum(), 0)

    def test_the_scene_is_worth_comparing(self):
        opaque, transparent = self.expected
        self.assertGreater(self.fragments, 20000)
        self.assertEqual(self.statistics["Fragments"], self.fragments)
        self.assertGreater(self.statistics["SolvedFragments"], 1000)
        self.assertEqual(self.statistics["UsedImportanceRange"], [150.0, 260.0])
        self.assertIn("solve", self.statistics["Stages"])
        self.assertEqual((opaque.shape, transparent.shape), ((200, 200, 3), (200, 200, 4)))
        self.assertGreater(len(set(transparent[:, :, 3].ravel())), 50)

    def test_remote_rendering(self):
        with server() as port:
            pictures, fragments, statistics = draw("remote", "--port", port, "--threshold", 0)
        self.assertEqual(fragments, 0)
        self.assert_expected(pictures, statistics)

    def test_local_rendering(self):
        with server() as port:
            pictures, fragments, statistics = draw("local", "--port", port, "--threshold", 1e9)
        self.assertEqual(fragments, self.fragments)
        self.assert_expected(pictures, statistics)


if __name__ == "__main__":
    unittest.main()
