# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of add_lines() and its like share."""

import unittest

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

import pellucid
from pictures import picture

FRONT = [(-1, 0, 0.3), (0, 0, 0.3), (1, 0, 0.3)]
BACK = [(0, -1, -0.3), (0, 0, -0.3), (0, 1, -0.3)]
HEIGHTS = [0.3, 0.3, 0.3, -0.3, -0.3, -0.3]


class ViewTest(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        self.renderer.GetActiveCamera().SetPosition(0, 0, 5)
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(60, 40)
        self.window.AddRenderer(self.renderer)

    def draw(self):
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        return picture(self.window)

    def assert_reference(self):
        """The picture, and what the reference renderer says, differ on outlines at most."""
        drawn = self.draw()
        reference = 255 * pellucid.reference_picture(self.renderer)[::-1, :, :3]
        self.assertLess((abs(drawn - reference).max(axis=2) > 1).mean(), 0.01)
        self.assertGreater(reference.max(), 30)
