# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent glyphs of VTK's own mapper: the picture is the reference's, and the baseline."""

import unittest

from vtkmodules.test import Testing
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPointSource
from vtkmodules.vtkCommonCore import vtkMinimalStandardRandomSequence
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkRenderer, vtkRenderWindow

import pellucid
from pictures import picture, reference_picture


class TestGlyphsPicture(unittest.TestCase):
    def test_picture(self):
        random = vtkMinimalStandardRandomSequence()
        random.SetSeed(1)
        points = vtkPointSource()
        points.SetNumberOfPoints(200)
        points.SetRandomSequence(random)
        cone = vtkConeSource()
        cone.SetResolution(16)
        mapper = vtkGlyph3DMapper()
        mapper.SetInputConnection(points.GetOutputPort())
        mapper.SetSourceConnection(cone.GetOutputPort())
        mapper.SetScaleFactor(0.2)
        mapper.SetScaleModeToNoDataScaling()
        mapper.OrientOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(0.3)
        actor.GetProperty().SetColor(1.0, 0.7, 0.2)

        renderer = vtkRenderer()
        renderer.AddActor(actor)
        window = vtkRenderWindow()
        window.OffScreenRenderingOn()
        window.SetMultiSamples(0)
        window.SetSize(300, 300)
        window.AddRenderer(renderer)
        transparency = pellucid.install(renderer)
        window.Render()

        self.assertGreater(transparency.GetStatistics().GetLongestList(), 10)
        error = picture(window) - reference_picture(renderer, 300, 300)
        print(f"RMSE {(error ** 2).mean() ** 0.5:.3f}, maximum {abs(error).max():.2f} of 255")
        self.assertLess((error ** 2).mean() ** 0.5, 1.0)
        Testing.compareImage(window, Testing.getAbsImagePath("TestGlyphsPicture.png"), 1.0)


if __name__ == "__main__":
    unittest.main()
