# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines drawn as tubes are selected on the surface of the tubes."""

import unittest

from paraview import selection, servermanager, simple

from plugin import create_view, load_plugin, picture, show


class TestPluginSelection(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load_plugin()

    def setUp(self):
        """Two horizontal lines of ten segments."""
        self.view = create_view()
        lines = [simple.Line(Point1=[-1.0, y, 0.0], Point2=[1.0, y, 0.0], Resolution=10) for y in (-0.5, 0.5)]
        self.source = simple.AppendGeometry(Input=lines)
        show(self.source, self.view).TubeRadius = 0.2
        simple.ResetCamera(self.view)
        self.before = picture(self.view)

    def tearDown(self):
        simple.Delete(self.view)
        del self.view

    def selected(self, select, attribute):
        """The ids that are selected in the lower half of the view."""
        select(Rectangle=[0, 0, 199, 99], View=self.view)
        extracted = simple.ExtractSelection(Input=self.source)
        extracted.UpdatePipeline()
        data = servermanager.Fetch(extracted)
        ids = getattr(data, f"Get{attribute}Data")().GetArray(f"vtkOriginal{attribute}Ids")
        found = sorted(int(ids.GetValue(i)) for i in range(ids.GetNumberOfValues()))
        simple.Delete(extracted)
        return found

    def test_cells_are_the_lines(self):
        self.assertEqual(self.selected(selection.SelectSurfaceCells, "Cell"), [0])

    def test_points_are_those_of_the_lines(self):
        self.assertEqual(self.selected(selection.SelectSurfacePoints, "Point"), list(range(11)))

    def test_the_picture_shows_the_selection_and_is_as_before_without(self):
        selection.SelectSurfaceCells(Rectangle=[0, 0, 199, 99], View=self.view)
        different = (picture(self.view) != self.before).any(axis=2)
        self.assertGreater(int(different[:100].sum()), 50)
        self.assertEqual(int(different[100:].sum()), 0)
        selection.ClearSelection(self.source)
        self.assertEqual(int((picture(self.view) != self.before).sum()), 0)


if __name__ == "__main__":
    unittest.main()
