# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView opens trajectory files with the right reader, and the filters do what they are told."""

import os
import pathlib
import sys
import unittest
import xml.etree.ElementTree as ElementTree

from paraview import servermanager, simple
from vtkmodules.test import Testing

import pellucid
from geographic import lagranto_netcdf, lagranto_text, met3d
from tractograms import tck, trx, trx_entries

DATA = pathlib.Path(Testing.VTK_DATA_ROOT)
TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)
XML = DATA.parent / "Plugin" / "ServerManager"

LINE = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 2.0, 0.0)]
# Longitude, latitude and pressure of two trajectories at two times.
TRACKS = [[0.0, 1.0], [2.0, 3.0]], [[40.0, 41.0], [42.0, 43.0]], [[900.0, 800.0], [700.0, 600.0]]
ROWS = [[(0.0, 0.0, 40.0, 900.0), (1.0, 1.0, 41.0, 800.0)]] * 2

# Values of properties that are not the defaults.
READER_PROPERTIES = {
    "EnsembleMember": 0,
    "VerticalAxis": "Height",
    "VerticalScale": 2.5,
    "HeightArray": "geopotential_height",
    "LongitudeMode": "Cut",
    "CentralLongitude": -30.0,
    "TimeSelection": "Until Requested Time",
}
CRITERIA = ["temperature", "90", "10", "1", "1", "1", "TotalPressureDifference", "300", "600", "-0.5", "0", "0"]


def proxies():
    """The definitions of the plugin that can be created: (group, name, class)."""
    for file in sorted(XML.glob("*.xml")):
        for group in ElementTree.parse(file).getroot():
            for proxy in group:
                if proxy.get("class"):
                    yield group.get("name"), proxy.get("name"), proxy.get("class")


def state(algorithm):
    """What PrintSelf() tells of a class of the plugin; an infinite bound is the largest number here."""
    text = str(algorithm).split("Progress Text:", 1)[1].split("\n", 1)[1]
    return text.replace("(none)", "").replace("inf\n", f"{sys.float_info.max:g}\n")


def number_of_cells(source):
    return source.GetDataInformation().GetNumberOfCells()


class TestPluginReaders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ["PELLUCID_PLUGIN"], remote=False, ns=vars(simple))

    def tearDown(self):
        simple.ResetSession()

    def pacific(self, **properties):
        reader = simple.OpenDataFile(str(DATA / "pacific.nc"), **properties)
        reader.UpdatePipeline()
        return reader

    def test_defaults_are_those_of_the_classes(self):
        names = []
        for group, name, class_name in proxies():
            with self.subTest(name):
                proxy = servermanager.CreateProxy(group, name)
                proxy.UpdateVTKObjects()
                expected = getattr(pellucid, class_name)()
                self.assertEqual(proxy.GetVTKClassName(), class_name)
                self.assertIn(":", state(expected))
                self.assertEqual(state(proxy.GetClientSideObject()), state(expected))
                names.append(name)
        self.assertEqual(len(names), 10)

    def test_few_properties_are_shown_at_first(self):
        for group, name, _ in proxies():
            proxy = servermanager.CreateProxy(group, name)
            shown = []
            iterator = proxy.NewPropertyIterator()
            iterator.Begin()
            while not iterator.IsAtEnd():
                each = iterator.GetProperty()
                if each.GetPanelVisibility() == "default" and not each.GetInformationOnly():
                    shown.append(iterator.GetKey())
                self.assertTrue(each.GetDocumentation().GetDescription().strip())
                iterator.Next()
            iterator.UnRegister(None)
            self.assertLessEqual(len(set(shown) - {"Input"}), 7, (name, shown))

    def test_files_choose_their_reader(self):
        for name, content in [
            ("track.nc", met3d(*TRACKS)),
            ("lagranto.nc", lagranto_netcdf(*TRACKS, time=[0.0, 6.0])),
            ("track.4", lagranto_netcdf(*TRACKS, time=[0.0, 6.0])),
            ("lsl_20110123_10", lagranto_text(ROWS)),
            ("track.lsl", lagranto_text(ROWS)),
            ("track.1", lagranto_text(ROWS)),
            ("track.tck", tck([LINE, LINE])),
            ("track.trx", trx([LINE, LINE])),
        ]:
            (TEMPORARY / name).write_bytes(content)
        for name, content in trx_entries([LINE, LINE]).items():
            path = TEMPORARY / "folder.trx" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        for path, reader, lines in [
            (DATA / "pacific.nc", "Met3DReader", 88),
            (DATA / "fornix.trk", "TrackVisReader", 60),
            (TEMPORARY / "track.nc", "Met3DReader", 2),
            (TEMPORARY / "lagranto.nc", "LagrantoNetCDFReader", 2),
            (TEMPORARY / "track.4", "LagrantoNetCDFReader", 2),
            (TEMPORARY / "lsl_20110123_10", "LagrantoReader", 2),
            (TEMPORARY / "track.lsl", "LagrantoReader", 2),
            (TEMPORARY / "track.1", "LagrantoReader", 2),
            (TEMPORARY / "track.tck", "MRtrixTracksReader", 2),
            (TEMPORARY / "track.trx", "TRXReader", 2),
            (TEMPORARY / "folder.trx", "TRXReader", 2),
        ]:
            with self.subTest(path.name):
                source = simple.OpenDataFile(str(path))
                source.UpdatePipeline()
                self.assertEqual(source.GetXMLName(), reader)
                self.assertEqual(number_of_cells(source), lines)

    def test_other_files_keep_their_reader(self):
        grid = simple.OpenDataFile(str(DATA / "combustor.vtk"))
        self.assertEqual(grid.GetXMLName(), "LegacyVTKFileReader")

    def test_times_are_steps_of_the_animation(self):
        reader = self.pacific(TimeSelection="Until Requested Time")
        self.assertEqual(list(reader.TimestepValues), list(range(49)))
        self.assertEqual(reader.NumberOfEnsembleMembers, 1)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        self.assertEqual(list(scene.TimeKeeper.TimestepValues), list(range(49)))
        reader.UpdatePipeline(12.0)
        self.assertEqual(reader.PointData["time"].GetRange(), (0.0, 12.0))

    def test_properties_of_readers_change_the_lines(self):
        reader = self.pacific(**READER_PROPERTIES)
        x_min, x_max, *_, z_max = reader.GetDataInformation().GetBounds()
        self.assertEqual((x_min, x_max), (-210.0, 150.0))
        self.assertAlmostEqual(z_max, 2.5 * 7.475996, 4)

    def test_attributes_are_chosen_one_by_one(self):
        attributes = simple.TrajectoryAttributes(Input=self.pacific())
        own = attributes.GetClientSideObject()
        for index in range(own.GetNumberOfAttributes()):
            setattr(attributes, own.GetAttributeName(index), "Off")
            attributes.UpdateVTKObjects()
            statuses = [own.GetAttributeStatus(i) for i in range(own.GetNumberOfAttributes())]
            self.assertEqual(statuses, [0] * (index + 1) + [2] * (7 - index))

    def test_attributes_are_those_of_the_arrays_and_axes(self):
        attributes = simple.TrajectoryAttributes(Input=self.pacific())
        self.assertEqual(attributes.PressureArray, "")
        self.assertIn("pressure", attributes.GetProperty("PressureArray").Available)
        attributes.HeightArray = "geopotential_height"
        attributes.UpAxis = "Y"
        attributes.TimeWindow = 1.0
        attributes.TurningAngle = "Off"
        attributes.Curvature = "Off"
        attributes.UpdatePipeline()
        self.assertNotIn("TurningAngle", attributes.PointData.keys())
        self.assertNotIn("Curvature", attributes.PointData.keys())
        self.assertIn("Velocity", attributes.PointData.keys())
        data = servermanager.Fetch(attributes)
        height = data.GetPointData().GetArray("geopotential_height")
        ascent = data.GetPointData().GetArray("SegmentHeightDifference")
        self.assertAlmostEqual(ascent.GetValue(0), height.GetValue(1) - height.GetValue(0), 2)
        # Within an hour, the greatest difference is that of a segment.
        segments = attributes.PointData["SegmentPressureDifference"].GetRange()
        total = attributes.CellData["TotalPressureDifference"].GetRange()
        self.assertAlmostEqual(total[1], max(segments[1], -segments[0]), 3)

    def test_selection_keeps_the_strong_ascents(self):
        attributes = simple.TrajectoryAttributes(Input=self.pacific())
        selection = simple.TrajectorySelection(Input=attributes)
        selection.ArrayName = "TotalPressureDifference"
        selection.UpdatePipeline()
        self.assertEqual(number_of_cells(selection), 88)
        selection.Minimum = 500.0
        selection.UpdatePipeline()
        selection.UpdatePropertyInformation()
        self.assertEqual(number_of_cells(selection), 24)
        self.assertEqual(selection.NumberOfSelectedLines, 24)
        self.assertEqual(selection.EffectiveMinimum, 500.0)
        selection.Minimum = 50.0
        selection.MinimumIsPercentile = 1
        selection.UpdatePipeline()
        self.assertEqual(number_of_cells(selection), 44)
        selection.ArrayName = "pressure"
        selection.MinimumIsPercentile = 0
        selection.Minimum = 800.0
        selection.AllPoints = 1
        selection.UpdatePipeline()
        self.assertGreaterEqual(selection.PointData["pressure"].GetRange()[0], 800.0)

    def test_importance_combines_any_number_of_criteria(self):
        attributes = simple.TrajectoryAttributes(Input=self.pacific())
        importance = simple.Importance(Input=attributes, Criteria=CRITERIA)
        importance.Exponent = 2.0
        importance.NumberOfHistogramBins = 10
        importance.UpdatePipeline()
        own = importance.GetClientSideObject()
        self.assertEqual(own.GetNumberOfCriteria(), 2)
        expected = pellucid.vtkImportance()
        expected.AddCriterion("temperature", 90.0, 10.0, 1.0, True, True)
        expected.AddCriterion("TotalPressureDifference", 300.0, 600.0, -0.5)
        expected.SetExponent(2.0)
        expected.SetNumberOfHistogramBins(10)
        expected.SetInputData(servermanager.Fetch(attributes))
        expected.Update()
        self.assertEqual(state(own), state(expected))
        data = servermanager.Fetch(importance).GetPointData().GetArray("Importance")
        values = expected.GetOutput().GetPointData().GetArray("Importance")
        self.assertEqual(data.GetRange(), values.GetRange())
        self.assertEqual(data.GetRange(), (0.0, 1.0))
        importance.Criteria = CRITERIA[:6]
        importance.UpdatePipeline()
        self.assertEqual(own.GetNumberOfCriteria(), 1)

    def test_segments_have_the_length_that_is_set(self):
        segments = simple.TrajectorySegments(Input=self.pacific())
        for number, length in ((0, 0.0), (500, 0.0), (500, 5.0)):
            segments.NumberOfSegments = number
            segments.SegmentLength = length
            segments.UpdatePipeline()
            segments.UpdatePropertyInformation()
            expected = pellucid.vtkTrajectorySegments()
            expected.SetNumberOfSegments(number)
            expected.SetSegmentLength(length)
            expected.SetInputData(servermanager.Fetch(segments.Input))
            expected.Update()
            self.assertEqual(segments.TotalNumberOfSegments, expected.GetTotalNumberOfSegments())

    def test_a_state_file_keeps_the_properties(self):
        reader = self.pacific(**READER_PROPERTIES)
        attributes = simple.TrajectoryAttributes(
            Input=reader, PressureArray="pressure", UpAxis="X", TimeWindow=6.0, Velocity="On"
        )
        selection = simple.TrajectorySelection(
            Input=attributes, ArrayName="TotalPressureDifference", Maximum=90.0, MaximumIsPercentile=1
        )
        importance = simple.Importance(Input=selection, Criteria=CRITERIA, Exponent=0.5)
        segments = simple.TrajectorySegments(Input=importance, NumberOfSegments=300)
        pipeline = [reader, attributes, selection, importance, segments]
        segments.UpdatePipeline()
        before = [state(proxy.GetClientSideObject()) for proxy in pipeline]
        names = [proxy.GetXMLName() for proxy in pipeline]
        file = str(TEMPORARY / "pipeline.pvsm")
        simple.SaveState(file)
        simple.ResetSession()
        simple.LoadState(file)
        loaded = {proxy.GetXMLName(): proxy for proxy in simple.GetSources().values()}
        loaded["TrajectorySegments"].UpdatePipeline()
        after = [state(loaded[name].GetClientSideObject()) for name in names]
        self.assertEqual(after, before)


if __name__ == "__main__":
    unittest.main()
