# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Save Screenshot, Save Animation and the interactive level of detail draw what the view shows."""

import pathlib
import unittest

import numpy
from paraview import simple
from vtkmodules.test import Testing

from pictures import read_png
from plugin import create_view, draw_scene, fragments, load_plugin, picture, save, show

TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)


class TestPluginPictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load_plugin()

    def setUp(self):
        self.view = create_view()

    def tearDown(self):
        simple.Delete(self.view)
        del self.view

    def assert_same(self, found, expected):
        self.assertEqual(found.shape, expected.shape)
        self.assertEqual(int((found != expected).any(axis=2).sum()), 0)

    def show_ball(self):
        display = show(simple.Sphere(ThetaResolution=32, PhiResolution=32), self.view)
        simple.ResetCamera(self.view)
        return display

    def test_a_screenshot_is_the_view(self):
        draw_scene(self.view)
        self.assert_same(save(TEMPORARY / "view.png", self.view), picture(self.view))

    def test_a_screenshot_of_another_size_leaves_the_view_as_it_is(self):
        draw_scene(self.view)
        before = picture(self.view)
        smaller = save(TEMPORARY / "smaller.png", self.view, ImageResolution=[150, 120])
        self.assertEqual(smaller.shape, (120, 150, 3))
        self.assert_same(picture(self.view), before)

    def test_a_larger_screenshot_is_that_of_a_larger_view(self):
        """It is put together from four tiles."""
        larger = create_view(400)
        for view in (self.view, larger):
            view.UseFXAA = 0  # it does not look across the edges of tiles
            draw_scene(view)
        expected = picture(larger)
        total = fragments(larger)
        simple.Delete(larger)
        tiled = save(TEMPORARY / "tiled.png", self.view, ImageResolution=[400, 400])
        self.assertLess(fragments(self.view), total / 2)
        self.assertEqual(tiled.shape, expected.shape)
        # Coordinates of fragments are rounded differently: some lie in the next pixel.
        different = abs(tiled - expected).max(axis=2)
        self.assertLess((different > 0).mean(), 0.0005)

    def test_a_transparent_background_keeps_the_coverage(self):
        self.show_ball()
        colors = save(TEMPORARY / "alpha.png", self.view, TransparentBackground=1)
        alpha = colors[:, :, 3]
        self.assertEqual(colors[0, 0].tolist()[3], 0)
        # Two layers of opacity 0.5.
        self.assertAlmostEqual(alpha[100, 100], 255 * 0.75, delta=1)
        inside = (alpha > 180).sum()
        self.assertGreater(inside, 5000)
        # Files hold colours that are not multiplied by alpha: white light on a white ball.
        self.assertGreater(colors[100, 100, 0], 180)

    def test_properties_are_animated(self):
        display = self.show_ball()
        scene = simple.GetAnimationScene()
        scene.PlayMode = "Sequence"
        scene.NumberOfFrames = 2
        # ParaView animates the opacity of all displays of a source.
        for name, proxy, values in (
            ("Opacity", display.Input, (0.2, 0.8)),
            ("TubeRadius", display, (0.1, 0.3)),
        ):
            track = simple.GetAnimationTrack(name, proxy=proxy)
            track.KeyFrames = [
                simple.CompositeKeyFrame(KeyTime=time, KeyValues=[value]) for time, value in enumerate(values)
            ]
        simple.SaveAnimation(str(TEMPORARY / "frame.png"), self.view, scene)
        frames = [read_png(path) for path in sorted(TEMPORARY.glob("frame.*.png"))]
        self.assertEqual(len(frames), 2)
        for time, (frame, opacity, radius) in enumerate(zip(frames, (0.2, 0.8), (0.1, 0.3))):
            scene.AnimationTime = time
            self.assertAlmostEqual(display.Opacity, opacity)
            self.assertAlmostEqual(display.TubeRadius, radius)
            self.assert_same(frame, picture(self.view))
        self.assertGreater(numpy.abs(frames[0] - frames[1]).max(), 50)

    def test_the_level_of_detail_shows_something(self):
        self.show_ball()
        still = picture(self.view)
        self.view.LODThreshold = 0.0
        self.view.SMProxy.InteractiveRender()
        self.assertTrue(self.view.GetClientSideObject().GetUseLODForInteractiveRender())
        interactive = fragments(self.view)
        self.assertGreater(interactive, 1000)
        self.assert_same(picture(self.view), still)
        self.assertGreater(fragments(self.view), interactive / 2)


if __name__ == "__main__":
    unittest.main()
