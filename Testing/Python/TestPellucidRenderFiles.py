#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-render: files recognised by their content, options of readers, and damaged files."""

import unittest
import zipfile

import geographic
import tractograms
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from render_program import DATA, RenderTest, make_lines, write

LON, LAT = [[170, 178, -174], [10, 20, 30]], [[30, 32, 34], [40, 41, 42]]
PRESSURE, HEIGHT = [[900, 700, 500], [800, 800, 700]], [[1000, 3000, 5500], [2000, 2000, 3000]]
TRACT = [[(0, 0, 0), (1, 2, 3), (4, 5, 6)], [(1, 1, 1), (2, 2, 2)]]

# Of each format: the content of a valid file, and how many points it has.
TRAJECTORIES = {
    "Met.3D": (geographic.met3d(LON, LAT, PRESSURE), 6),
    "LAGRANTO NetCDF": (geographic.lagranto_netcdf(LON, LAT, PRESSURE, [0, 6, 12]), 6),
    "LAGRANTO text": (geographic.lagranto_text(
        [zip((0, 6, 12), LON[line], LAT[line], PRESSURE[line]) for line in range(2)]), 6),
    "TrackVis": (tractograms.trk(TRACT), 5),
    "MRtrix": (tractograms.tck(TRACT), 5),
    "TRX": (tractograms.trx(TRACT), 5),
    "TRX, deflated": (tractograms.trx(TRACT, compression=zipfile.ZIP_DEFLATED), 5),
}


class TestRecognition(RenderTest):
    def test_trajectories_of_any_name(self):
        for name, (content, points) in TRAJECTORIES.items():
            for suffix in (".data", ".vtk", ".bin"):
                with self.subTest(name=name, suffix=suffix):
                    path = self.folder / ("any" + suffix)
                    path.write_bytes(content)
                    header = self.list_arrays(path)[0]
                    self.assertEqual(header, f"{path}: {points} points, 2 lines")

    def test_folder_of_trx(self):
        folder = self.folder / "tract"
        for name, content in tractograms.trx_entries(TRACT).items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(content)
        self.assertEqual(self.list_arrays(folder)[0], f"{folder}: 5 points, 2 lines")
        self.refuse(1, "is a folder, expected a file, or a folder in TRX", self.folder)

    def test_kinds_of_vtk_with_wrong_suffixes(self):
        path = self.folder / "right.ply"  # the writer of PLY insists
        for writer, data, properties in (
            (vtkPolyDataWriter(), make_lines(), {}),
            (vtkXMLPolyDataWriter(), make_lines(), {"DataMode": 1}),
            (vtkPLYWriter(), self.sphere, {}),
            (vtkSTLWriter(), self.sphere, {"FileType": 1}),
            (vtkSTLWriter(), self.sphere, {"FileType": 2}),
        ):
            write(writer, data, path, **properties)
            points = data.GetNumberOfPoints()
            for suffix in (".obj", ".vtp", ".nc", ".bin", ".unknown", ""):
                with self.subTest(writer=writer.GetClassName(), suffix=suffix, **properties):
                    wrong = self.folder / ("wrong" + suffix)
                    wrong.write_bytes(path.read_bytes())
                    self.assertIn(f"{wrong}: {points} points", self.list_arrays(wrong)[0])

    def test_unknown_content(self):
        for name, content, text in (
            ("plain.txt", b"hello", "is of no known kind; known are .vtk"),
            ("other.nc", geographic.netcdf({"x": 2}, {"x": ("f", ("x",), [1, 2], {})}),
             "expected the variables time, lon, lat and pressure"),
            ("other.trk", b"hello", "is named as TrackVis but does not begin so"),
            ("other.tck", b"hello", "is named as MRtrix"),
            ("other.trx", b"hello", "is named as TRX"),
            ("other.lsl", b"hello", "is named as LAGRANTO's text format"),
        ):
            (self.folder / name).write_bytes(content)
            self.refuse(1, text, self.folder / name)


class TestDamage(RenderTest):
    def test_damaged_trajectories(self):
        """Files cut short, and files with noise after their beginning."""
        for name, (content, _) in TRAJECTORIES.items():
            half = len(content) * 6 // 10
            for damaged in (content[:half], content[:len(content) - 5],
                            content[:half] + bytes(i * 7919 % 251 for i in range(len(content) - half))):
                if name == "LAGRANTO text" and damaged == content[:-5]:
                    continue  # a shorter number is a number
                with self.subTest(name=name, length=len(damaged)):
                    path = self.folder / "damaged"
                    path.write_bytes(damaged)
                    self.refuse(1, "damaged", path)

    def test_damaged_samples(self):
        for name in ("pacific.nc", "fornix.trk"):
            content = (DATA / name).read_bytes()
            path = self.folder / ("cut-" + name)
            path.write_bytes(content[:len(content) // 2])
            self.refuse(1, "cut-" + name, path)


class TestReaderOptions(RenderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        fill = {"_FillValue": ("f", [-999.99])}
        members = [PRESSURE, [[850, 650, 450], [750, 750, 650]]]
        cls.file = cls.folder / "ensemble.nc"
        cls.file.write_bytes(geographic.met3d(
            [LON, LON], [LAT, LAT], members,
            {"height": ("f", None, [HEIGHT, HEIGHT], {"units": "m", **fill})}))

    def ranges(self, *options):
        """Of each array (minimum, maximum), and the number of lines."""
        lines = self.list_arrays(self.file, *options)
        rows = self.table(lines)
        return ({name: (float(row["minimum"]), float(row["maximum"])) for name, row in rows.items()},
                int(lines[0].split()[-2]))

    def test_ensemble_member(self):
        self.assertEqual(self.ranges()[0]["pressure"], (500, 900))
        self.assertEqual(self.ranges("--ensemble-member", "1")[0]["pressure"], (450, 850))
        self.refuse(1, "ember", self.file, "--ensemble-member", "2")

    def test_vertical_axis(self):
        name = "SegmentHeightDifference"
        height = self.ranges("--vertical-axis", "height")[0][name]
        self.assertEqual(height, (0, 2.5))
        scaled = self.ranges("--vertical-axis", "height", "--vertical-scale", "4")[0][name]
        self.assertEqual(scaled, (0, 10))
        pressure = self.ranges("--vertical-axis", "pressure", "--vertical-scale", "1")[0][name]
        self.assertAlmostEqual(pressure[1], 0.3365, 4)

    def test_units_of_the_map_are_told(self):
        for file, expected in ((self.file, True), (self.lines, False),
                               (DATA / "fornix.trk", False)):
            text = "\n".join(self.list_arrays(file))
            self.assertEqual("longitude" in text and "--vertical-scale" in text, expected, file)
        row = self.table(self.list_arrays(self.file, "--height", "height"))["SegmentHeightDifference"]
        self.assertEqual((row["maximum"], row["unit"]), ("2500", "m"))

    def test_longitudes(self):
        self.assertEqual(self.ranges()[1], 2)
        self.assertEqual(self.ranges("--longitudes", "cut")[1], 3)
        self.assertEqual(self.ranges("--longitudes", "cut", "--central-longitude", "100")[1], 2)

    def test_wrong_usage(self):
        for option, value in (
            ("--ensemble-member", "-1"), ("--ensemble-member", "1.5"), ("--vertical-axis", "z"),
            ("--vertical-scale", "-1"), ("--vertical-scale", "x"), ("--longitudes", "wrap"),
            ("--central-longitude", "361"),
        ):
            with self.subTest(option=option, value=value):
                self.refuse(2, f"{option}: expected ", self.file, option, value)


if __name__ == "__main__":
    unittest.main()
