# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation "Pellucid" fades what hides more important things, live, as its properties say."""

import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

import numpy
from paraview import servermanager, simple
from vtkmodules.test import Testing
from vtkmodules.util.numpy_support import vtk_to_numpy

import pellucid
import plugin
from pictures import picture, reference_picture

XML = (pathlib.Path(Testing.VTK_DATA_ROOT).parent / "Plugin" / "Representations" /
       "PellucidRepresentation.xml")


# Tubes of many lines behind each other.
TUBES = {"TubeRadius": 0.7, "AutomaticImportanceRange": 0, "ImportanceRange": [150.0, 260.0]}


def definitions():
    """The properties of the representation in its XML, by name."""
    proxy = ElementTree.parse(XML).getroot().find(".//PellucidRepresentationProxy")
    return {element.get("name"): element for element in proxy if element.tag.endswith("Property")}


def stream_lines():
    """Lines through the gradient of ParaView's wavelet, many behind each other."""
    gradient = simple.Gradient(Input=simple.Wavelet(), ScalarArray=["POINTS", "RTData"])
    gradient.UpdatePipeline()
    tracer = simple.StreamTracer(Input=gradient, SeedType="Point Cloud")
    tracer.Vectors = ["POINTS", "Gradient"]
    tracer.SeedType.NumberOfPoints = 60
    tracer.SeedType.Radius = 8.0
    tracer.MaximumStepLength = 1.0
    tracer.InitialStepLength = 1.0
    tracer.UpdatePipeline()
    return tracer


class TestPluginImportance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        plugin.load_plugin()

    def setUp(self):
        self.view = simple.CreateView("RenderView", ViewSize=[200, 150], OrientationAxesVisibility=0,
                                      UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0],
                                      UseFXAA=0)
        self.renderer = self.view.GetClientSideObject().GetRenderer()

    def tearDown(self):
        simple.Delete(self.view)

    def show(self, source, array=None, **properties):
        display = simple.Show(source, self.view)
        simple.ResetCamera(self.view)
        display.Representation = "Pellucid"
        for name, value in properties.items():
            setattr(display, name, value)
        if array:
            display.ImportanceArray = ["POINTS", array]
        return display

    def draw(self):
        simple.Render(self.view)
        return picture(self.view.GetRenderWindow()).astype(float)

    def info(self, display, name):
        display.SMProxy.UpdatePropertyInformation()
        return display.GetPropertyValue(name)

    def drawn(self, display):
        """The data that the mapper has got."""
        return display.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(0)

    def assert_exact(self):
        """The picture is that of double precision, but for outlines."""
        found = self.draw()
        expected = numpy.round(reference_picture(self.renderer, *self.view.ViewSize))
        difference = numpy.abs(found - expected).max(axis=2)
        self.assertLess((difference > 1.0).mean(), 2e-3)

    def test_definitions_are_complete(self):
        default_panel = 0
        exposed = {element.get("name") for element in
                   ElementTree.parse(XML).getroot().iterfind(".//ExposedProperties//Property")}
        for name, element in definitions().items():
            with self.subTest(name=name):
                self.assertTrue(" ".join(element.findtext("Documentation").split()).endswith("."))
                self.assertIn(name, exposed)
                if element.get("information_only") != "1":
                    self.assertTrue(element.get("label"))
                    default_panel += element.get("panel_visibility", "default") == "default"
        self.assertLessEqual(default_panel, 7)

    def test_defaults_are_those_of_the_class(self):
        pxm = servermanager.ProxyManager().SMProxyManager
        proxy = pxm.NewProxy("representations", "PellucidRepresentation")
        before = str(proxy.GetClientSideObject()).split("Radius: ", 1)[1]
        for name in definitions():
            proxy.UpdateProperty(name, True)
        self.assertEqual(str(proxy.GetClientSideObject()).split("Radius: ", 1)[1], before)

    def test_entries_are_those_of_the_classes(self):
        entries = {name: [entry.get("text") for entry in element.iter("Entry")]
                   for name, element in definitions().items()}
        presets = [name.title().replace("-", " ") for name in pellucid.presets()]
        self.assertEqual(entries["OpacityPreset"], presets + ["Custom"])
        views = pellucid.vtkExactTransparencyPass
        self.assertEqual(len(entries["PictureView"]), views.VIEW_LAYER + 1)

    def test_important_lines_show_behind_others(self):
        display = self.show(stream_lines(), **TUBES)
        simple.ColorBy(display, None)
        display.DiffuseColor = [0.0, 0.0, 0.0]
        even = self.draw()
        self.assertEqual(self.info(display, "SolvedFragments"), 0)
        display.ImportanceArray = ["POINTS", "RTData"]
        faded = self.draw()
        self.assertGreater(faded.mean(), even.mean() + 1.0)
        self.assertGreater(self.info(display, "SolvedFragments"), 1000)
        self.assertGreater(self.info(display, "LongestList"), 1)
        self.assertIn("solve ", self.info(display, "StageTimes"))
        self.assertEqual(self.info(display, "SeesAllFragments"), 1)
        self.assert_exact()
        display.ImportanceArray = ["POINTS", "None"]
        self.assertTrue((self.draw() == even).all())

    def test_parameters_are_live(self):
        display = self.show(stream_lines(), "RTData", **TUBES)
        last = self.draw()
        data, time = self.drawn(display), self.drawn(display).GetMTime()
        for name, value in (
                ("OpacityPreset", "Focus"), ("OpacityStrength", 0.1), ("SelfOcclusion", 1),
                ("OpacityPreset", "Custom"), ("OcclusionWeight", 1.0), ("ClutterWeight", 5000.0),
                ("Emphasis", 0.5), ("SmoothingIterations", 40), ("ImportanceRange", [100.0, 200.0]),
                ("ImportanceRange", [200.0, 100.0]), ("AutomaticImportanceRange", 1),
                ("GatherScale", 2), ("OpacityMethod", "Penalty"), ("AvoidancePenalty", 0.8),
                ("AvoidanceGlobalOpacity", 0.5), ("AvoidanceSmoothAttributes", 1),
                ("OpacityMethod", "Weighting"), ("AvoidanceImportanceWeight", 5.0),
                ("AvoidanceCoverageWeight", 1.0), ("AvoidanceDirectionalVarianceWeight", 50.0),
                ("AvoidanceDepthWeight", 0.0), ("AvoidanceImportanceExponent", 5.0),
                ("PictureView", "One Layer"), ("PictureLayer", 2)):
            with self.subTest(name=name, value=value):
                setattr(display, name, value)
                now = self.draw()
                self.assertTrue((now != last).any())
                last = now
        self.assertIs(self.drawn(display), data)
        self.assertEqual(data.GetMTime(), time)

    def test_no_strength_fades_nothing(self):
        display = self.show(stream_lines(), **TUBES)
        even = self.draw()
        display.ImportanceArray = ["POINTS", "RTData"]
        display.OpacityStrength = 0.0
        self.assertLessEqual(numpy.abs(self.draw() - even).max(), 1.0)

    def test_automatic_range(self):
        lines = stream_lines()
        display = self.show(lines, "RTData")
        self.draw()
        values = vtk_to_numpy(servermanager.Fetch(lines).GetPointData().GetArray("RTData"))
        for found, share in zip(self.info(display, "UsedImportanceRange"), (50.0, 99.0)):
            expected = numpy.percentile(values.astype(float), share, method="nearest")
            self.assertAlmostEqual(found, expected, delta=0.01)
        calculator = simple.Calculator(Input=lines, ResultArrayName="Importance", Function="RTData/300")
        display = self.show(calculator, "Importance")
        self.draw()
        self.assertEqual(list(self.info(display, "UsedImportanceRange")), [0.0, 1.0])

    def test_surfaces_points_and_groups(self):
        sphere = simple.Elevation(Input=simple.Sphere(ThetaResolution=24, PhiResolution=24),
                                  LowPoint=[0.0, 0.0, -0.5], HighPoint=[0.0, 0.0, 0.5])
        cloud = simple.Elevation(Input=simple.PointSource(NumberOfPoints=300, Radius=0.4),
                                 LowPoint=[0.0, 0.0, -0.5], HighPoint=[0.0, 0.0, 0.5])
        group = simple.GroupDatasets(Input=[sphere, cloud])
        for source in (sphere, cloud, group):
            with self.subTest(source=source):
                display = self.show(source, "Elevation", Opacity=0.9, TubeRadius=0.02)
                self.draw()
                self.assertGreater(self.info(display, "SolvedFragments"), 100)
                self.assert_exact()
                simple.Hide(source, self.view)

    def test_the_view_keeps_what_was_set(self):
        sphere = simple.Sphere()
        display = self.show(sphere, Opacity=0.5, MemoryLimit=77)
        self.draw()
        simple.Hide(sphere, self.view)
        self.draw()
        simple.Show(sphere, self.view)
        self.draw()
        transparency = pellucid.vtkTransparencyInstaller.GetPass(self.renderer)
        self.assertEqual(transparency.GetMemoryLimit(), 77)
        self.assertEqual(display.MemoryLimit, 77)

    def test_settings_of_the_view(self):
        """What is not the default in one of the visible displays holds for the view."""
        first, second = simple.Sphere(), simple.Sphere(Center=[1.0, 0.0, 0.0])
        display = self.show(first, Opacity=0.5)
        other = self.show(second, Opacity=0.5)
        plain = self.draw()
        other.PictureView = "Number of Layers"
        display.GatherScale = 2
        self.assertTrue((self.draw() != plain).any())
        transparency = pellucid.vtkTransparencyInstaller.GetPass(self.renderer)
        self.assertEqual(transparency.GetGatherScale(), 2)
        other.Representation = "Surface"
        self.draw()
        self.assertEqual(transparency.GetView(), transparency.VIEW_PICTURE)
        other.Representation = "Pellucid"
        self.draw()
        self.assertEqual(transparency.GetView(), transparency.VIEW_LENGTH)
        simple.Hide(second, self.view)
        self.draw()
        self.assertEqual(transparency.GetView(), transparency.VIEW_PICTURE)

    def test_unimportant_data(self):
        """An array that is missing in the data, or has no finite value, harms nothing."""
        lines = stream_lines()
        display = self.show(lines, "no such array")
        self.assertTrue(numpy.isfinite(self.draw()).all())
        nothing = simple.ProgrammableFilter(Input=lines, Script=(
            "output.ShallowCopy(inputs[0].VTKObject)\n"
            "output.PointData.append(inputs[0].PointData['RTData'] * numpy.nan, 'nothing')"))
        display = self.show(nothing, "nothing")
        self.draw()
        self.assertEqual(self.info(display, "SolvedFragments"), 0)


if __name__ == "__main__":
    unittest.main()
