#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of geographic trajectories: a real sample, and files whose lines are known."""

import math
import pathlib

from vtkmodules.test import Testing
from vtkmodules.vtkCommonDataModel import vtkDataObject

from geographic import lagranto_netcdf, lagranto_text, met3d, netcdf
from pellucid import (
    vtkGeographicTrajectoryReader as Base,
    vtkLagrantoNetCDFReader,
    vtkLagrantoReader,
    vtkMet3DReader,
    vtkTrajectoryAttributes,
    vtkTrajectoryReaderFactory,
)
from readers import (
    FILE,
    GAP,
    NAN,
    PACIFIC,
    TestCase,
    cells,
    lines_of,
    log_height,
    points,
    read,
    steps_of,
    units,
    xs_of,
)


class TestPacific(TestCase):
    """The numbers are those of netCDF4 and numpy."""

    def test_counts_units_extremes(self):
        reader = vtkMet3DReader()
        output, messages = read(reader)
        self.assertEqual(messages, [])
        self.assertEqual(output.GetNumberOfLines(), 88)
        self.assertEqual(output.GetNumberOfPoints(), 3920)
        self.assertEqual(cells(output, "TrajectoryId"), list(range(88)))
        for name, unit, lowest, highest in [
            ("lon", "degrees_east", -179.92635, 179.86221),
            ("lat", "degrees_north", 17.736958, 60.89774),
            ("pressure", "hPa", 378.38748, 999.9103),
            ("temperature", "K", 227.70094, 296.98828),
            ("relative_humidity", "%", 6.8731294, 100),
            ("geopotential_height", "m", 22.380198, 7475.996),
            ("time", "hours since 2011-01-15 12:00:00", 0, 48),
        ]:
            array = output.GetPointData().GetArray(name)
            self.assertEqual(array.GetDataTypeAsString(), "double" if name == "time" else "float")
            self.assertEqual(units(output, name), unit)
            self.assert_close(array.GetRange(), (lowest, highest), 1e-3)
        self.assertEqual(output.GetPointData().GetNumberOfArrays(), 7)
        self.assertEqual(steps_of(reader), list(range(49)))
        self.assertEqual(reader.GetNumberOfEnsembleMembers(), 1)

    def test_lines_that_rise_most(self):
        output, _ = read(vtkMet3DReader)
        pressure = output.GetPointData().GetArray("pressure")
        count = 0
        for cell in range(output.GetNumberOfCells()):
            ids = output.GetCell(cell).GetPointIds()
            line = [pressure.GetValue(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]
            count += max(line) - min(line) > 500
        self.assertEqual(count, 24)

    def test_rise_does_not_depend_on_the_map(self):
        def rises(**properties):
            attributes = vtkTrajectoryAttributes()
            attributes.SetInputData(read(vtkMet3DReader, **properties)[0])
            attributes.Update()
            output = attributes.GetOutput()
            return set(
                zip(cells(output, "TrajectoryId"), cells(output, "TotalPressureDifference"))
            )

        expected = rises()
        self.assertEqual(sum(rise > 500 for _, rise in expected), 24)
        for longitude in range(-180, 180, 30):
            found = rises(LongitudeMode=Base.CUT, CentralLongitude=longitude)
            self.assertEqual(found, expected, longitude)

    def test_unwrap_and_cut(self):
        unwrapped = xs_of(read(vtkMet3DReader)[0])
        self.assertLess(max(abs(a - b) for line in unwrapped for a, b in zip(line, line[1:])), 10)
        self.assertGreater(max(map(max, unwrapped)), 180)
        cut, _ = read(vtkMet3DReader, LongitudeMode=Base.CUT)
        self.assertEqual(cut.GetNumberOfLines(), 94)
        self.assertEqual(cut.GetNumberOfPoints(), 3920 + 12)
        self.assertLessEqual(max(abs(x) for line in xs_of(cut) for x in line), 180)
        whole, _ = read(vtkMet3DReader, LongitudeMode=Base.CUT, CentralLongitude=180)
        self.assertEqual(whole.GetNumberOfLines(), 88)


class TestLines(TestCase):
    def test_positions_and_arrays(self):
        output, messages = read(
            vtkMet3DReader,
            met3d(
                [[10, 11, 12], [20, 21, 22]],
                [[40, 41, 42], [50, 51, 52]],
                [[1000, 800, 600], [900, 700, 500]],
                {
                    "T": (
                        "f",
                        None,
                        [[280, GAP, 260], [250, 240, 230]],
                        {"units": "K", "missing_value": ("d", [GAP]), "auxiliary_data": "yes"},
                    ),
                    "start_lon": ("f", ("trajectory",), [10, 20], {}),
                    "id": ("i", ("trajectory",), [7, 2147483647], {}),
                    "clock": ("h", ("time",), [1, 2, 3], {}),
                    "name": ("c", ("trajectory",), [b"a", b"b"], {}),
                    "scalar": ("f", (), [1], {}),
                },
            ),
        )
        self.assertEqual(messages, [])
        self.assert_close(lines_of(output)[1][2], (22, 52, log_height(500)))
        self.assertEqual(output.GetPoints().GetData().GetDataTypeAsString(), "float")
        self.assert_close(points(output, "T"), [280, NAN, 260, 250, 240, 230])
        self.assertEqual(points(output, "pressure"), [1000, 800, 600, 900, 700, 500])
        self.assertEqual(points(output, "clock"), [1, 2, 3, 1, 2, 3])
        self.assertEqual(cells(output, "start_lon"), [10, 20])
        self.assertEqual(cells(output, "id"), [7, 2147483647])
        self.assertFalse(output.GetPointData().HasArray("scalar"))
        self.assertFalse(output.GetCellData().HasArray("name"))
        self.assertEqual(units(output, "T"), "K")

    def test_doubles_stay_doubles(self):
        output, _ = read(
            vtkMet3DReader, met3d([[10.123456789, 11]], [[40, 41]], [[900, 800]], kind="d")
        )
        self.assertEqual(output.GetPoint(0)[0], 10.123456789)
        self.assertEqual(points(output, "lon")[0], 10.123456789)

    def test_layouts(self):
        lon = [[[10, 11, 12], [20, 21, 22]], [[30, 31, 32], [40, 41, 42]]]
        pressure = [[[900, 800, 700]] * 2] * 2
        for order in [
            ("ensemble", "trajectory", "time"),
            ("trajectory", "ensemble", "time"),
            ("time", "ensemble", "trajectory"),
            ("time", "trajectory", "ensemble"),
        ]:
            for version, records in ((1, None), (2, order[0]), (5, None), (5, order[0])):
                reader = vtkMet3DReader()
                output, messages = read(
                    reader,
                    met3d(lon, lon, pressure, order=order, version=version, records=records),
                    EnsembleMember=1,
                )
                self.assertEqual(messages, [])
                self.assertEqual(reader.GetNumberOfEnsembleMembers(), 2)
                self.assertEqual(xs_of(output), lon[1])
        output, _ = read(
            vtkMet3DReader, met3d(lon[0], lon[0], pressure[0], order=("trajectory", "time"))
        )
        self.assertEqual(xs_of(output), lon[0])

    def test_standard_names(self):
        over = ("n", "t")
        content = netcdf(
            {"t": 2, "n": 1},
            {
                "hours": ("d", ("t",), [0, 1], {"standard_name": "time"}),
                "x": ("f", over, [1, 2], {"standard_name": "longitude"}),
                "y": ("f", over, [3, 4], {"standard_name": "latitude"}),
                "Druck": ("f", over, [100, 200], {"standard_name": "air_pressure"}),
            },
        )
        output, messages = read(vtkMet3DReader, content)
        self.assertEqual(messages, [])
        self.assert_close(output.GetPoint(1), (2, 4, log_height(200)))

    def test_gaps(self):
        lon = [[1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6], [GAP] * 6]
        lat = [[0, 0, GAP, 0, NAN, 0], [0] * 6, [0] * 6]
        pressure = [[500] * 6, [500, math.inf, 500, 500, 0, -5], [500] * 6]
        output, messages = read(vtkMet3DReader, met3d(lon, lat, pressure))
        self.assertEqual(xs_of(output), [[1, 2], [4], [6], [1], [3, 4]])
        self.assertEqual(cells(output, "TrajectoryId"), [0, 0, 0, 1, 1])
        self.assertEqual(points(output, "time"), [0, 1, 3, 5, 0, 2, 3])
        self.assertEqual([event for event, _ in messages], ["WarningEvent"])
        self.assertIn("2 positions have a pressure of 0 or less", messages[0][1])
        output, messages = read(vtkMet3DReader, met3d([[GAP]], [[GAP]], [[GAP]]))
        self.assertEqual(output.GetNumberOfLines(), 0)
        self.assertIn("there is no line", messages[0][1])

    def test_missing_values(self):
        def variable(kind, numbers, **items):
            return kind, None, [numbers], {key: (kind, value) for key, value in items.items()}

        output, _ = read(
            vtkMet3DReader,
            met3d(
                [[1, 2, 3]],
                [[1, 2, 3]],
                [[500] * 3],
                {
                    "fill": variable("f", [1, -1, -2], _FillValue=[-1], missing_value=[-2]),
                    "default": variable("f", [1, 9.969209968386869e36, 2]),
                    "short": variable("h", [1, -32767, 2]),
                    "byte": variable("b", [1, -127, 2]),
                    "integer": variable("i", [1, -2147483647, 16777217]),
                    "packed": (
                        "h",
                        None,
                        [[1, -1, 100]],
                        {
                            "scale_factor": ("d", [0.5]),
                            "add_offset": ("d", [10]),
                            "_FillValue": ("h", [-1]),
                        },
                    ),
                },
            ),
        )
        self.assert_close(points(output, "fill"), [1, NAN, NAN])
        self.assert_close(points(output, "default"), [1, NAN, 2])
        self.assert_close(points(output, "short"), [1, NAN, 2])
        self.assert_close(points(output, "byte"), [1, -127, 2])
        self.assert_close(points(output, "integer"), [1, NAN, 16777217])
        self.assert_close(points(output, "packed"), [10.5, NAN, 60])

    def test_vertical_axis(self):
        def make(unit, height_unit="m", pressure=((50000, 100000),)):
            return met3d(
                [[1, 2]],
                [[1, 2]],
                pressure,
                {"altitude": ("f", None, [[5500, 100]], {"units": height_unit})},
                pressure_attributes={"units": unit},
            )

        def heights(content, **properties):
            output, messages = read(vtkMet3DReader, content, **properties)
            self.assertEqual(messages, [])
            return [z for line in lines_of(output) for _, _, z in line]

        self.assert_close(heights(make("Pa")), [log_height(500), 0])
        self.assert_close(heights(make("Pa"), VerticalScale=2), [log_height(500, 2), 0])
        self.assert_close(heights(make("")), [log_height(50000), log_height(100000)])
        self.assert_close(heights(make("Pa"), VerticalAxis=Base.HEIGHT), [5.5, 0.1])
        self.assert_close(
            heights(make("Pa", "km"), VerticalAxis=Base.HEIGHT, VerticalScale=0.5), [2750, 50], 1e-3
        )
        self.assert_close(heights(make("", pressure=None)), [5.5, 0.1])
        self.assert_close(
            heights(make("m"), VerticalAxis=Base.HEIGHT, HeightArray="pressure"), [50, 100]
        )
        self.assert_error(vtkMet3DReader, make("kPa"), "'kPa' of 'pressure'", "hPa")
        self.assert_error(
            vtkMet3DReader, make("Pa", "feet"), "'feet' of 'altitude'", VerticalAxis=Base.HEIGHT
        )
        self.assert_error(
            vtkMet3DReader,
            make("Pa"),
            "no variable 'z'",
            "lon, lat, pressure, altitude",
            VerticalAxis=Base.HEIGHT,
            HeightArray="z",
        )
        self.assert_error(
            vtkMet3DReader,
            met3d([[1]], [[1]], [[1]]),
            "known as height",
            "LOG_PRESSURE",
            VerticalAxis=Base.HEIGHT,
        )
        self.assert_error(
            vtkMet3DReader, met3d([[1]], [[1]], None), "pressure or height", "lon, lat"
        )


    def test_great_heights(self):
        height = {"z": ("f", None, [[1000, 3e38, 3000, -3e38]], {"units": "km"})}
        output, messages = read(
            vtkMet3DReader,
            met3d([[1, 2, 3, 4]], [[0] * 4], None, height),
            VerticalScale=10,
        )
        self.assertEqual([[z for _, _, z in line] for line in lines_of(output)], [[1e4], [3e4]])
        self.assertEqual([event for event, _ in messages], ["WarningEvent"])
        self.assertIn("2 positions have", messages[0][1])

    def test_units_in_any_letters(self):
        for unit, expected in [("hPa ", 500), (" HPA\n", 500), ("pa", 5), ("MBar", 500)]:
            output, messages = read(
                vtkMet3DReader,
                met3d([[1]], [[1]], [[500]], pressure_attributes={"units": unit}),
            )
            self.assertEqual(messages, [])
            self.assert_close(output.GetPoint(0), (1, 1, log_height(expected)))
            self.assertEqual(units(output, "pressure"), unit.strip())
        self.assert_error(
            vtkMet3DReader,
            met3d([[1]], [[1]], [[500]], pressure_attributes={"units": " kPa "}),
            "the unit 'kPa' of 'pressure' is not known; expected one of hPa, mbar",
        )


class TestLongitudes(TestCase):
    def read_lines(self, lon, lat=None, **properties):
        lat = lat or [[0] * len(line) for line in lon]
        pressure = [[500] * len(line) for line in lon]
        output, messages = read(vtkMet3DReader, met3d(lon, lat, pressure), **properties)
        self.assertEqual(messages, [])
        return output

    def test_unwrap(self):
        lines = [
            [170, 179, -172, -163],
            [-170, 175, 160, 150],
            [350, 359, 8, 17],
            [0, 120, -120, 0],
            [0, 180, 0, -180],
            [170, GAP, -170, -160],
        ]
        output = self.read_lines(lines)
        self.assertEqual(
            xs_of(output)[:5] + [sum(xs_of(output)[5:], [])],
            [
                [170, 179, 188, 197],
                [-170, -185, -200, -210],
                [350, 359, 368, 377],
                [0, 120, 240, 360],
                [0, 180, 0, -180],
                [170, 190, 200],
            ],
        )
        self.assert_close(points(output, "lon"), [x for line in lines for x in line if x != GAP])

    def test_cut(self):
        output = self.read_lines(
            [[170, 176, -172, -163], [-170, 170, 160, 150], [350, 2, 4, 6]],
            [[0, 1, 4, 5], [0, 2, 0, 0], [0, 0, 0, 0]],
            LongitudeMode=Base.CUT,
        )
        self.assertEqual(
            xs_of(output),
            [
                [170, 176, 180],
                [-180, -172, -163],
                [-170, -180],
                [180, 170, 160, 150],
                [-10, 2, 4, 6],
            ],
        )
        self.assertEqual(cells(output, "TrajectoryId"), [0, 0, 1, 1, 2])
        self.assert_close(lines_of(output)[0][2], (180, 2, log_height(500)))
        self.assert_close(lines_of(output)[1][0], (-180, 2, log_height(500)))
        self.assert_close(points(output, "time")[:6], [0, 1, 4 / 3, 4 / 3, 2, 3])
        self.assert_close(
            points(output, "lon"),
            [170, 176, 180, -180, -172, -163, -170, -180, 180, 170, 160, 150, 350, 2, 4, 6],
        )

    def test_cut_through_positions(self):
        # On the edge, along it and over the edge at a gap: no empty line, nothing doubled.
        output = self.read_lines(
            [
                [179, 180, -179, -178],
                [180, -180, 180, 179],
                [-179, -180, -180, 178],
                [179, GAP, -179, -178],
            ],
            LongitudeMode=Base.CUT,
        )
        self.assertEqual(
            xs_of(output),
            [
                [179, 180],
                [-180, -179, -178],
                [180, 180, 180, 179],
                [-179, -180, -180],
                [180, 178],
                [179],
                [-179, -178],
            ],
        )

    def test_cut_at_a_position_beside_a_missing_value(self):
        fill = {"_FillValue": ("f", [-999.99])}
        content = met3d(
            [[170, 175, -180, -175]],
            [[0] * 4],
            [[500] * 4],
            {"T": ("f", None, [[280, 279, 278, -999.99]], fill)},
        )
        output, _ = read(vtkMet3DReader, content, LongitudeMode=Base.CUT)
        self.assertEqual(xs_of(output), [[170, 175, 180], [-180, -175]])
        self.assertEqual(str(points(output, "T")), str([280.0, 279.0, 278.0, 278.0, math.nan]))

    def test_cut_elsewhere(self):
        output = self.read_lines(
            [[170, 190, 350, 10]], LongitudeMode=Base.CUT, CentralLongitude=180
        )
        self.assertEqual(xs_of(output), [[170, 190, 350, 360], [0, 10]])
        output = self.read_lines(
            [[80, 100, 120, 140]], LongitudeMode=Base.CUT, CentralLongitude=-90
        )
        self.assertEqual(xs_of(output), [[80, 90], [-270, -260, -240, -220]])

    def test_far_longitudes(self):
        output = self.read_lines([[-35990, -35981], [3610, 2], [0, 36000]])
        self.assertEqual(xs_of(output), [[-35990, -35981], [3610, 3602], [0, 0]])
        lon = [[10, 1e30, 12, 13], [36000.01, 1, -3e38, 2]]
        for mode in (Base.UNWRAP, Base.CUT):
            output, messages = read(
                vtkMet3DReader, met3d(lon, [[0] * 4] * 2, [[500] * 4] * 2), LongitudeMode=mode
            )
            self.assertEqual(xs_of(output), [[10], [12, 13], [1], [2]])
            self.assertEqual([event for event, _ in messages], ["WarningEvent"])
            self.assertIn("3 positions have", messages[0][1])
            self.assertIn("longitude beyond 36000 degrees", messages[0][1])


class TestTimes(TestCase):
    def test_until(self):
        reader = vtkMet3DReader()
        reader.SetTimeSelectionToUntilRequested()
        content = met3d(
            [[1, 2, 3, 4], [5, GAP, 7, 8]],
            [[0] * 4] * 2,
            [[500] * 4] * 2,
            {"a": ("f", ("trajectory",), [3, 4], {})},
            time=[0, 6, 12, 18],
        )
        key = vtkDataObject.DATA_TIME_STEP()
        for time, expected, ids in [
            (6, [[1, 2], [5]], [0, 1]),
            (-1, [], []),
            (12.5, [[1, 2, 3], [5], [7]], [0, 1, 1]),
            (99, [[1, 2, 3, 4], [5], [7, 8]], [0, 1, 1]),
        ]:
            output, messages = read(reader, content, time)
            self.assertEqual(messages, [])
            self.assertEqual(xs_of(output), expected)
            self.assertEqual(cells(output, "TrajectoryId"), ids)
            self.assertEqual(cells(output, "a"), [i + 3 for i in ids])
            self.assertTrue(all(t <= time for t in points(output, "time")))
            self.assertEqual(units(output, "lon"), "degrees_east")
            self.assertEqual(output.GetInformation().Get(key), time)
        self.assertEqual(steps_of(reader), [0, 6, 12, 18])
        self.assertEqual(xs_of(read(vtkMet3DReader, content, 6)[0]), [[1, 2, 3, 4], [5], [7, 8]])
        self.assertEqual(
            read(vtkMet3DReader, content, TimeSelection=Base.UNTIL_REQUESTED)[
                0
            ].GetNumberOfPoints(),
            7,
        )

    def test_another_time_does_not_read_again(self):
        reader = vtkMet3DReader()
        reader.SetTimeSelectionToUntilRequested()
        read(reader, met3d([[1, 2]], [[1, 2]], [[500, 500]]), 0)
        pathlib.Path(FILE).write_bytes(b"another file")
        reader.UpdateTimeStep(1)
        self.assertEqual(xs_of(reader.GetOutput()), [[1, 2]])

    def test_what_is_opened_for_information_is_read(self):
        reader = vtkMet3DReader()
        pathlib.Path(FILE).write_bytes(met3d([[1, 2]], [[1, 2]], [[500, 500]]))
        reader.SetFileName(FILE)
        reader.UpdateInformation()
        pathlib.Path(FILE).unlink()
        pathlib.Path(FILE).write_bytes(b"another file")
        reader.Update()
        self.assertEqual(xs_of(reader.GetOutput()), [[1, 2]])
        reader.Modified()
        self.assert_error(reader, b"another file")

    def test_missing_and_repeated_times(self):
        reader = vtkMet3DReader()
        output, _ = read(reader, met3d([[1, 2, 3, 4]], [[0] * 4], [[500] * 4], time=[6, 0, 6, NAN]))
        self.assertEqual(steps_of(reader), [0, 6])
        self.assert_close(points(output, "time"), [6, 0, 6, NAN])


class TestUntrusted(TestCase):
    GOOD = met3d([[1, 2]], [[1, 2]], [[500, 600]], {"T": ("f", None, [[1, 2]], {"units": "K"})})

    def test_members(self):
        message = self.assert_error(vtkMet3DReader, self.GOOD, EnsembleMember=1)
        self.assertEqual(message, "EnsembleMember is 1, but the file has members 0 to 0")

    def test_truncated(self):
        orders = {None: ("trajectory", "time"), "time": ("time", "ensemble", "trajectory")}
        for version in (1, 2, 5):
            for records in orders:
                content = met3d(
                    [[1, 2]],
                    [[1, 2]],
                    [[500, 600]],
                    version=version,
                    records=records,
                    order=orders[records],
                )
                self.assertEqual(read(vtkMet3DReader, content)[1], [])
                for length in range(0, len(content), 7 if version > 1 else 1):
                    self.assert_error(vtkMet3DReader, content[:length])
                    self.assertFalse(vtkMet3DReader().CanReadFile(FILE))
        content = pathlib.Path(PACIFIC).read_bytes()
        for share in (0.001, 0.01, 0.1, 0.5, 0.9, 0.99):
            self.assert_error(vtkMet3DReader, content[: int(share * len(content))])

    def test_messages(self):
        self.assert_error(
            vtkMet3DReader, self.GOOD[:-1], "'T' should end at byte", str(len(self.GOOD))
        )
        self.assert_error(vtkMet3DReader, self.GOOD[:60], "header should go on")
        self.assert_error(vtkMet3DReader, b"nothing of the kind", "is not a NetCDF file")
        self.assert_error(
            vtkMet3DReader,
            netcdf({"t": 1}, {"time": ("d", ("t",), [0], {})}),
            "has no trajectories",
            "time(t)",
        )
        empty = {name: ("f", ("t", "n"), [], {}) for name in ("lon", "lat", "p")}
        self.assert_error(
            vtkLagrantoNetCDFReader,
            netcdf({"n": 1, "t": 0}, {"time": ("d", ("t",), [], {}), **empty}, records="t"),
            "holds no positions: 1 trajectories, 0 times",
        )
        self.assert_error(vtkLagrantoNetCDFReader, self.GOOD, "read it with vtkMet3DReader")
        self.assert_error(
            vtkMet3DReader,
            lagranto_netcdf([[1]], [[1]], [[500]], [0]),
            "read it with vtkLagrantoNetCDFReader",
        )

    def test_many_variables(self):
        def make(count):
            extra = {f"v{i}": ("b", ("trajectory",), [i % 100], {}) for i in range(count)}
            return met3d([[1]], [[1]], [[500]], extra, order=("trajectory", "time"))

        output, messages = read(vtkMet3DReader, make(4093))  # besides lon, lat, pressure
        self.assertEqual(messages, [])
        self.assertEqual(cells(output, "v4092"), [92])
        self.assert_error(
            vtkMet3DReader, make(4094), "at most 4096 arrays", "found more"
        )
        self.assertFalse(vtkMet3DReader().CanReadFile(FILE))

    def test_lying_sizes(self):
        # The length of the dimension `trajectory`, behind its name.
        at = self.GOOD.index(b"trajectory") + 12
        for length in (2, 1000, 0x7FFFFFFF):
            lie = self.GOOD[:at] + length.to_bytes(4, "big") + self.GOOD[at + 4 :]
            self.assert_error(vtkMet3DReader, lie, "should end at byte")
        # NetCDF-4 of 100000 x 100000 positions, of which none was written.
        unwritten = pathlib.Path(__file__).parent.parent / "Data" / "unwritten.nc"
        self.assert_error(
            vtkMet3DReader, str(unwritten), "claims more than it can hold: 40000000000 bytes"
        )
        # Numbers of elements, of types and of dimensions.
        for at in range(4, self.GOOD.index(b"pressure") + 100, 4):
            for value in (0x7FFFFFFF, 0xFFFFFFFF, 12345):
                lie = self.GOOD[:at] + value.to_bytes(4, "big") + self.GOOD[at + 4 :]
                _, messages = read(vtkMet3DReader, lie)
                errors = [event for event, _ in messages if event == "ErrorEvent"]
                self.assertLessEqual(len(errors), 1)

    def test_can_read_file(self):
        lagranto = lagranto_netcdf([[1]], [[1]], [[500]], [0])
        grid = netcdf(
            {"time": 1, "lat": 2, "lon": 2},
            {
                "time": ("d", ("time",), [0], {}),
                "lat": ("f", ("lat",), [0, 1], {}),
                "lon": ("f", ("lon",), [0, 1], {}),
                "p": ("f", ("time", "lat", "lon"), [1] * 4, {}),
            },
        )
        over = ("time", "y", "x")
        moving_grid = netcdf(
            {"time": 1, "y": 2, "x": 2},
            {
                "time": ("d", ("time",), [0], {}),
                **{name: ("f", over, [1] * 4, {}) for name in ("lon", "lat", "p")},
            },
        )
        track = netcdf(
            {"time": 2},
            {
                "time": ("d", ("time",), [0, 1], {}),
                **{name: ("f", ("time",), [1, 2], {}) for name in ("lon", "lat", "p")},
            },
        )
        profiles = met3d([[1]], [[1]], [[1]], attributes={"featureType": "timeSeriesProfile"})
        flat = met3d([[1]], [[1]], None)
        readers = [vtkMet3DReader, vtkLagrantoNetCDFReader, vtkLagrantoReader]
        for content, expected in [
            (self.GOOD, vtkMet3DReader),
            (lagranto, vtkLagrantoNetCDFReader),
            (lagranto_text([[(0, 1, 1, 500), (1, 2, 2, 600)]]), vtkLagrantoReader),
            (grid, None),
            (moving_grid, None),
            (track, None),
            (profiles, None),
            (flat, None),
            (b"", None),
            (b"# vtk DataFile Version 3.0\n", None),
            (b"-----\n", None),
        ]:
            pathlib.Path(FILE).write_bytes(content)
            self.assertEqual(
                [bool(reader().CanReadFile(FILE)) for reader in readers],
                [reader is expected for reader in readers],
            )
            chosen = vtkTrajectoryReaderFactory.CreateReader(FILE)
            self.assertIs(type(chosen), expected or type(None))
        for name in (PACIFIC, str(pathlib.Path(FILE).parent), "no such file"):
            self.assertEqual(
                [bool(reader().CanReadFile(name)) for reader in readers],
                [name == PACIFIC, False, False],
            )
        for name in ("combustor.vtk", "combustor-lines.vtk"):
            name = str(pathlib.Path(Testing.VTK_DATA_ROOT, name))
            self.assertFalse(any(reader().CanReadFile(name) for reader in readers))
