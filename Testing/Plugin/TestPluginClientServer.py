# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A server draws the picture that ParaView draws without one, and so does the client of a server."""

import pathlib
import unittest

from vtkmodules.test import Testing

from pictures import read_png
from processes import HERE, program, run, server

TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)


def draw(name, *options):
    """Draw the scene; its pictures, and how many fragments the program itself has drawn."""
    # pvbatch cannot connect to a server.
    said = run(program("pvpython"), HERE / "draw.py", TEMPORARY / name, *options)
    pictures = [read_png(TEMPORARY / name / f"{each}.png") for each in ("opaque", "transparent")]
    return pictures, int(said.rsplit("fragments:", 1)[1])


class TestPluginClientServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected, cls.fragments = draw("builtin")

    def assert_expected(self, pictures):
        for found, expected in zip(pictures, self.expected):
            self.assertEqual(found.shape, expected.shape)
            self.assertEqual((found != expected).any(axis=2).sum(), 0)

    def test_the_scene_is_worth_comparing(self):
        opaque, transparent = self.expected
        self.assertGreater(self.fragments, 20000)
        self.assertEqual((opaque.shape, transparent.shape), ((200, 200, 3), (200, 200, 4)))
        self.assertGreater(len(set(transparent[:, :, 3].ravel())), 50)

    def test_remote_rendering(self):
        with server() as port:
            pictures, fragments = draw("remote", "--port", port, "--threshold", 0)
        self.assertEqual(fragments, 0)
        self.assert_expected(pictures)

    def test_local_rendering(self):
        with server() as port:
            pictures, fragments = draw("local", "--port", port, "--threshold", 1e9)
        self.assertEqual(fragments, self.fragments)
        self.assert_expected(pictures)


if __name__ == "__main__":
    unittest.main()
