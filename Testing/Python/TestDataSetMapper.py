# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The surface of any data set that vtkDataSetMapper draws is exact."""

import unittest

from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper, vtkRenderer, vtkRenderWindow

import pellucid
from pictures import picture, reference_picture


class TestDataSetMapper(unittest.TestCase):
    def test_pictures(self):
        image = vtkRTAnalyticSource()
        image.SetWholeExtent(-5, 5, -5, 5, -5, 5)
        sphere = vtkSphereSource()
        sphere.SetRadius(8)
        grid = vtkAppendFilter()
        grid.AddInputConnection(sphere.GetOutputPort())
        for source in (image, sphere, grid):
            elevation = vtkElevationFilter()
            elevation.SetInputConnection(source.GetOutputPort())
            elevation.SetLowPoint(0, -8, 0)
            elevation.SetHighPoint(0, 8, 0)
            mapper = vtkDataSetMapper()
            mapper.SetInputConnection(elevation.GetOutputPort())
            mapper.SelectColorArray("Elevation")
            mapper.SetScalarModeToUsePointFieldData()
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetOpacity(0.4)
            renderer = vtkRenderer()
            renderer.AddActor(actor)
            renderer.GetActiveCamera().Azimuth(20)
            renderer.ResetCamera()
            window = vtkRenderWindow()
            window.OffScreenRenderingOn()
            window.SetMultiSamples(0)
            window.SetSize(120, 100)
            window.AddRenderer(renderer)
            transparency = pellucid.install(renderer)
            window.Render()
            self.assertGreaterEqual(transparency.GetStatistics().GetLongestList(), 2)
            error = abs(picture(window) - reference_picture(renderer, 120, 100)).max(axis=2)
            self.assertLess((error > 1).mean(), 0.005, source.GetClassName())


if __name__ == "__main__":
    unittest.main()
