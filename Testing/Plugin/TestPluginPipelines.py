# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own pipelines look as before, bit for bit, when the plugin is loaded and has been used."""

import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkDataObject

from plugin import create_view, fragments, gradient, load_plugin, picture, show, silence, stream_lines


def contour():
    return simple.Contour(Input=simple.Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[130.0, 200.0])


def threshold():
    return simple.Threshold(
        Input=simple.Wavelet(), Scalars=["POINTS", "RTData"], LowerThreshold=180.0, UpperThreshold=300.0
    )


def interpolated():
    growing = simple.ExtractSurface(Input=simple.TimeSource(XAmplitude=2.0, Growing=1))
    return simple.TemporalInterpolator(Input=growing, DiscreteTimeStepInterval=0.5)


def extracted():
    cells = servermanager.sources.SelectionQuerySource(QueryString="(id < 900)")
    cells.ElementType = vtkDataObject.CELL
    return simple.ExtractSelection(Input=contour(), Selection=cells)


PIPELINES = {
    "Stream Tracer": stream_lines,
    "Tube": lambda: simple.Tube(Input=stream_lines(), Radius=0.2),
    "Glyph": lambda: simple.Glyph(Input=gradient(), GlyphType="Arrow", OrientationArray=["POINTS", "Gradient"]),
    "Contour": contour,
    "Slice": lambda: simple.Slice(Input=simple.Wavelet()),
    "Clip": lambda: simple.Clip(Input=simple.Wavelet(), ClipType="Sphere"),
    "Threshold": threshold,
    "Group Datasets": lambda: simple.GroupDatasets(Input=[stream_lines(), contour()]),
    "Temporal Interpolator": interpolated,
    "Extract Selection": extracted,
}


def view_of(source):
    """A view that shows the source as ParaView does, and its display."""
    view = create_view(150)
    view.ViewTime = 0.3
    view.CameraPosition = [3.0, 2.0, 1.5]
    display = simple.Show(source, view)
    display.Representation = "Surface"
    simple.ResetCamera(view)
    return view, display


class TestPluginPipelines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Draw all pipelines in a ParaView that does not know the plugin."""
        cls.sources = {name: make() for name, make in PIPELINES.items()}
        for source in cls.sources.values():
            simple.Delete(view_of(source)[0])  # the range of the colours grows with each
        cls.before = {}
        for name, source in cls.sources.items():
            view, _ = view_of(source)
            cls.before[name] = picture(view)
            simple.Delete(view)
        load_plugin()

    def assert_as_before(self, view, name):
        self.assertEqual(int((picture(view) != self.before[name]).sum()), 0)

    def check(self, name):
        source = self.sources[name]
        view, display = view_of(source)
        self.assert_as_before(view, name)
        self.assertIsNone(fragments(view))
        # Data that is not made of polygons and lines keeps its own representation, and takes part
        # in the exact transparency that another source brings into the view.
        kind = source.GetDataInformation().GetDataSetTypeAsString()
        companion = None
        if kind in ("vtkPolyData", "vtkMultiBlockDataSet"):
            display.Representation = "Pellucid"
        else:
            self.assertEqual(kind, "vtkUnstructuredGrid")
            companion = show(simple.Sphere(Radius=0.1), view)
        display.Opacity = 0.5
        colors = picture(view)
        self.assertGreater(len({tuple(color) for color in colors.reshape(-1, 3)}), 50)
        self.assertGreater(int((colors != self.before[name]).sum()), 100)
        pixels = int((colors != colors[0, 0]).any(axis=2).sum())
        self.assertGreater(fragments(view), 0.8 * pixels)  # smooth edges are wider
        self.assertLess(fragments(view), 100 * pixels)
        # And back.
        display.Opacity = 1.0
        display.Representation = "Surface"
        if companion:
            companion.Visibility = 0
        self.assert_as_before(view, name)
        self.assertIsNone(fragments(view))
        simple.Delete(view)


def case(name):
    def test(self):
        with silence(self):
            self.check(name)

    return test


for each in PIPELINES:
    setattr(TestPluginPipelines, "test_" + each.lower().replace(" ", "_"), case(each))


if __name__ == "__main__":
    unittest.main()
