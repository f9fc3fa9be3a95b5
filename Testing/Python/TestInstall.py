# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid.install makes a renderer exact, pellucid.uninstall gives it back to VTK."""

import types
import unittest

from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

import pellucid
from pictures import picture


def plane(depth, color):
    """A square of opacity 0.5 that fills the picture."""
    source = vtkPlaneSource()
    source.SetOrigin(-9, -9, depth)
    source.SetPoint1(9, -9, depth)
    source.SetPoint2(-9, 9, depth)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(0.5)
    actor.GetProperty().LightingOff()
    return actor


class TestInstall(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(33, 17)
        self.window.AddRenderer(self.renderer)
        # The farther plane comes last: a wrong order shows.
        self.renderer.AddActor(plane(0.5, (1.0, 0.0, 0.0)))
        self.renderer.AddActor(plane(0.0, (0.0, 1.0, 0.0)))
        self.renderer.GetActiveCamera().SetPosition(0.0, 0.0, 5.0)

    def middle(self):
        self.window.Render()
        return picture(self.window)[8, 16].tolist()

    def test_installed_renderer_blends_in_depth_order(self):
        transparency = pellucid.install(self.renderer)
        red, green, blue = self.middle()
        self.assertAlmostEqual(red, 127.5, delta=1)
        self.assertAlmostEqual(green, 63.75, delta=1)
        self.assertEqual(blue, 0)
        self.assertEqual(transparency.GetStatistics().GetFragments(), 2 * 33 * 17)
        self.assertEqual(transparency.GetStatistics().GetLongestList(), 2)

    def test_second_install_returns_the_same_pass(self):
        self.assertIs(pellucid.install(self.renderer), pellucid.install(self.renderer))

    def test_uninstall_gives_the_renderer_back(self):
        before = self.middle()
        pellucid.install(self.renderer)
        self.middle()
        pellucid.uninstall(self.renderer)
        self.assertEqual(self.middle(), before)
        self.assertIsNone(self.renderer.GetPass())

    def test_windows_and_plotters_have_a_pass_for_each_renderer(self):
        other = vtkRenderer()
        self.window.AddRenderer(other)
        pellucid.install(self.window)
        first, second = map(pellucid.vtkTransparencyInstaller.GetPass, (self.renderer, other))
        self.assertIsNot(first, second)
        self.assertIs(pellucid.install(self.window), first)
        plotter = types.SimpleNamespace(renderers=[self.renderer, other], renderer=other)
        self.assertIs(pellucid.install(plotter), second)
        self.assertIs(pellucid.install(self.renderer), first)
        pellucid.uninstall(plotter)
        self.window.Render()
        self.assertIsNone(self.renderer.GetPass())
        self.assertIsNone(other.GetPass())

    def test_anything_else_is_refused(self):
        for wrong in (plane(0.0, (1.0, 0.0, 0.0)), None, "renderer", types.SimpleNamespace(renderers=[1])):
            with self.assertRaisesRegex(TypeError, "vtkRenderer"):
                pellucid.install(wrong)
        empty = vtkRenderWindow()
        with self.assertRaisesRegex(ValueError, "expected a window with a renderer, found none"):
            pellucid.install(empty)
        pellucid.uninstall(empty)


if __name__ == "__main__":
    unittest.main()
