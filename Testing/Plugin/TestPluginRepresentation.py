# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation "Pellucid" draws stream lines, and its view is exact while it is visible."""

import os
import unittest

from paraview import simple

import pellucid
from pictures import picture
from plugin import stream_lines


class TestPluginRepresentation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ["PELLUCID_PLUGIN"], remote=False, ns=vars(simple))

    def setUp(self):
        self.view = simple.CreateView("RenderView", ViewSize=[200, 200], OrientationAxesVisibility=0)
        self.renderer = self.view.GetClientSideObject().GetRenderer()
        self.empty = self.picture()

    def tearDown(self):
        simple.Delete(self.view)

    def show(self, source):
        display = simple.Show(source, self.view)
        simple.ResetCamera(self.view)
        self.assertIn("Pellucid", display.GetProperty("Representation").Available)
        display.Representation = "Pellucid"
        display.Opacity = 0.5
        return display

    def statistics(self):
        transparency = pellucid.vtkTransparencyInstaller.GetPass(self.renderer)
        self.assertIsNotNone(transparency)
        return transparency.GetStatistics()

    def fragments(self):
        return self.statistics().GetFragments()

    def picture(self):
        simple.Render(self.view)
        return picture(self.view.GetRenderWindow())

    def covered(self):
        """Pixels that something was drawn in."""
        return int((self.picture() != self.empty).any(axis=2).sum())

    def test_stream_lines_are_tubes(self):
        display = self.show(stream_lines())
        display.TubeRadius = 0.05
        thin = self.covered()
        self.assertGreater(thin, 100)
        self.assertGreater(self.fragments(), 0)
        display.TubeRadius = 0.5
        self.assertGreater(self.covered(), 2 * thin)

    def test_both_layers_of_a_sphere_are_drawn(self):
        self.show(simple.Sphere(ThetaResolution=64, PhiResolution=64))
        covered = self.covered()
        self.assertAlmostEqual(self.fragments() / covered, 2.0, delta=0.1)

    def test_blocks(self):
        """Visibility, colours and opacities of blocks, as the inspector of blocks sets them."""
        left = simple.Sphere(Center=[-1.0, 0.0, 0.0], ThetaResolution=32, PhiResolution=32)
        right = simple.Sphere(Center=[1.0, 0.0, 0.0], ThetaResolution=32, PhiResolution=32)
        group = simple.GroupDatasets(Input=[left, right])
        group.BlockNames = ["left", "right"]
        display = self.show(group)
        display.ColorArrayName = ["POINTS", ""]
        both = self.covered()
        display.BlockSelectors = ["/Root/left"]
        self.assertAlmostEqual(self.covered() / both, 0.5, delta=0.02)
        fragments = self.fragments()
        display.BlockSelectors = ["/Root"]
        self.assertEqual(self.covered(), both)
        self.assertAlmostEqual(self.fragments() / fragments, 2.0, delta=0.02)
        display.BlockColors = ["/Root/left", "1.0", "0.0", "0.0"]
        display.BlockOpacities = ["/Root/right", "1.0"]
        picture = self.picture()
        middle = picture.shape[1] // 2
        for half, is_red in ((picture[:, :middle], True), (picture[:, middle:], False)):
            shown = half[(half != self.empty[:, :middle]).any(axis=2)].mean(axis=0)
            self.assertEqual(bool(shown[0] > 1.5 * shown[1]), is_red)

    def test_an_unchanged_view_is_not_gathered_again(self):
        self.show(simple.Sphere(ThetaResolution=64, PhiResolution=64))
        self.view.LODThreshold = 0.0
        picture_of_all = self.picture()

        def gathers(render):
            render()
            return self.statistics().GetStageMilliseconds("gather") > 0.0

        interact = self.view.SMProxy.InteractiveRender
        self.assertFalse(gathers(self.picture))
        self.assertTrue(gathers(interact))  # another level of detail
        self.assertFalse(gathers(interact))
        self.assertTrue(gathers(self.picture))
        self.assertTrue((self.picture() == picture_of_all).all())

    def test_the_view_is_exact_while_one_is_visible(self):
        first = self.show(simple.Sphere())
        second = self.show(simple.Cone())
        self.assertGreater(self.fragments(), 0)
        first.Representation = "Surface"
        simple.Render(self.view)
        self.assertGreater(self.fragments(), 0)
        second.Visibility = 0
        simple.Render(self.view)
        self.assertIsNone(pellucid.vtkTransparencyInstaller.GetPass(self.renderer))


if __name__ == "__main__":
    unittest.main()
