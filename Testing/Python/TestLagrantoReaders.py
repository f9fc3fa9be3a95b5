#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What is LAGRANTO's own: layouts, times, text."""

import pathlib

from geographic import lagranto_netcdf, lagranto_text
from pellucid import vtkLagrantoNetCDFReader, vtkLagrantoReader
from readers import (
    FILE,
    GAP,
    NAN,
    TestCase,
    lines_of,
    log_height,
    points,
    read,
    steps_of,
    units,
    xs_of,
)


class TestLagrantoNetCDF(TestCase):
    DATE = {
        name: ("i", [value])
        for name, value in [
            ("ref_year", 2011),
            ("ref_month", 1),
            ("ref_day", 23),
            ("ref_hour", 6),
            ("ref_min", 30),
            ("duration", -1440),
        ]
    }

    def test_time_major(self):
        reader = vtkLagrantoNetCDFReader()
        output, messages = read(
            reader,
            lagranto_netcdf(
                [[1, 2, 3], [4, 5, GAP]],
                [[0, 0, 0], [1, 1, GAP]],
                [[500, 600, 700], [800, 900, GAP]],
                [0, -0.30, -1.15],
                {"TH": [[300, GAP, 302], [303, 304, GAP]]},
                self.DATE,
            ),
        )
        self.assertEqual(messages, [])
        self.assertEqual(xs_of(output), [[1, 2, 3], [4, 5]])
        self.assert_close(points(output, "TH"), [300, NAN, 302, 303, 304])
        self.assertEqual(points(output, "time"), [0, -0.5, -1.25, 0, -0.5])
        self.assertEqual(units(output, "time"), "hours since 2011-01-23 06:30:00")
        self.assertEqual(units(output, "p"), "hPa")
        self.assertEqual(steps_of(reader), [-1.25, -0.5, 0])

    def test_times(self):
        def times(time, **options):
            output, messages = read(
                vtkLagrantoNetCDFReader,
                lagranto_netcdf([[1, 2, 3]], [[0] * 3], [[500] * 3], time, **options),
            )
            self.assertEqual(messages, [])
            return points(output, "time"), units(output, "time")

        seconds = {"units": "seconds since 2011-01-01"}
        self.assertEqual(
            times([0, 1800, 3600], time_attributes=seconds),
            ([0, 1800, 3600], "seconds since 2011-01-01"),
        )
        self.assertEqual(times([0, 0.3, 1]), ([0, 0.5, 1], "hours"))

    def test_decimals_or_minutes(self):
        for time, expected in [
            ([0, 0.75, 1.5], None),
            ([0, 0.5, 1], None),
            ([0, -0.5, -1, -1.5], None),
            ([0, 0.2, 0.4, 1], [0, 1 / 3, 2 / 3, 1]),
            ([-1, -0.3, 0], [-1, -0.5, 0]),
            ([0, 0.1, 0.2], [0, 1 / 6, 1 / 3]),  # as even in decimals
            ([0, 0.5], [0, 5 / 6]),
            ([0.05], [1 / 12]),
            ([0, 6, 18], [0, 6, 18]),
        ]:
            zero = [0] * len(time)
            pressure = [500] * len(time)
            rows = list(zip(time, zero, zero, pressure))
            for reader, content in [
                (vtkLagrantoNetCDFReader, lagranto_netcdf([zero] * 2, [zero] * 2, [pressure] * 2,
                                                          time)),
                (vtkLagrantoReader, lagranto_text([rows, rows])),
                (vtkLagrantoReader, lagranto_text([[row, row] for row in rows])),
            ]:
                output, messages = read(reader, content)
                self.assert_close(sorted(points(output, "time")), sorted(2 * (expected or time)))
                self.assertEqual(
                    [event for event, _ in messages], [] if expected else ["WarningEvent"]
                )
                if messages:
                    self.assertIn("taken as hours in decimals, not as hh.mm", messages[0][1])

    def test_height_and_dimension_names(self):
        output, messages = read(
            vtkLagrantoNetCDFReader,
            lagranto_netcdf(
                [[1], [2]], [[0], [0]], [[1500], [3000]], [0], names=("time", "id"), vertical="z"
            ),
        )
        self.assertEqual(messages, [])
        self.assertEqual([line[0][2] for line in lines_of(output)], [1.5, 3])
        self.assertEqual(units(output, "z"), "m")


class TestLagrantoText(TestCase):
    ROWS = [
        [(0, 10, 50, 900, 300), (-6.30, 11, 51, 800, GAP)],
        [(0, 20, 60, 700, 301), (-6.30, 21, 61, 600, 302)],
    ]
    NAMES = ("time", "lon", "lat", "p", "TH")

    def test_current_format(self):
        for end in ("\n", "\r\n"):
            reader = vtkLagrantoReader()
            output, messages = read(reader, lagranto_text(self.ROWS, self.NAMES, end=end))
            self.assertEqual(messages, [])
            self.assertEqual(xs_of(output), [[10, 11], [20, 21]])
            self.assert_close(output.GetPoint(3), (21, 61, log_height(600)))
            self.assert_close(points(output, "TH"), [300, NAN, 301, 302])
            self.assertEqual(points(output, "time"), [0, -6.5, 0, -6.5])
            self.assertEqual(units(output, "time"), "hours since 2011-01-23 10:30:00")
            self.assertEqual(
                [units(output, name) for name in self.NAMES[1:]],
                ["degrees_east", "degrees_north", "hPa", None],
            )
            self.assertEqual(steps_of(reader), [-6.5, 0])

    def test_older_format(self):
        rows = [[(0, 1, 1, 500), (-0.5, 2, 2, 600)]]
        output, _ = read(
            vtkLagrantoReader, lagranto_text(rows, title=" time period 2006 131 18 UTC  -120.00 h")
        )
        self.assertEqual(points(output, "time"), [0, -0.5])
        self.assertEqual(units(output, "time"), "hours since 2006-01-31 18:00:00")
        output, _ = read(vtkLagrantoReader, lagranto_text(rows, title="Reference date unknown"))
        self.assertEqual(units(output, "time"), "hours")

    def test_sorted_by_time(self):
        blocks = [list(block) for block in zip(*self.ROWS)]
        expected, _ = read(vtkLagrantoReader, lagranto_text(self.ROWS, self.NAMES))
        expected = lines_of(expected), points(expected, "time")
        output, messages = read(vtkLagrantoReader, lagranto_text(blocks, self.NAMES))
        self.assertEqual(messages, [])
        self.assertEqual((lines_of(output), points(output, "time")), expected)
        self.assert_error(
            vtkLagrantoReader,
            lagranto_text(blocks + [blocks[0][:1]], self.NAMES),
            "sorted by times",
            "1 rows",
        )

    def test_lines_of_differing_lengths(self):
        output, _ = read(
            vtkLagrantoReader, lagranto_text([self.ROWS[0], [], self.ROWS[1][:1]], self.NAMES)
        )
        self.assertEqual(xs_of(output), [[10, 11], [20]])
        text = lagranto_text(self.ROWS, self.NAMES).rstrip()
        self.assertEqual(read(vtkLagrantoReader, text)[0].GetNumberOfPoints(), 4)

    def test_missing_numbers(self):
        output, messages = read(
            vtkLagrantoReader,
            lagranto_text(
                [
                    [
                        (0, 1, 1, 500, "*******"),
                        (1, "-999.990", 1, -1000, "nan"),
                        (2, 3, 1, "+6e2", 5),
                        (3, 4, "-1.5e-400", "6e2", "1e-310"),
                    ]
                ],
                self.NAMES,
            ),
        )
        self.assertEqual(messages, [])
        self.assertEqual(xs_of(output), [[1], [3, 4]])
        self.assert_close(points(output, "TH"), [NAN, 5, 0])
        self.assertEqual(points(output, "lat"), [1, 1, 0])

    def test_column_names(self):
        names = ("time", "lon", "lat", "z", "TH", "TH", "TH_2", "time")
        output, messages = read(vtkLagrantoReader, lagranto_text([[range(1, 9)]], names))
        self.assertEqual(messages, [])
        data = output.GetPointData()
        found = {data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}
        self.assertEqual(found, {"lon", "lat", "z", "TH", "TH_2", "TH_2_2", "time_2", "time"})
        self.assertEqual(points(output, "TH_2"), [6])
        self.assert_close(output.GetPoint(0), (2, 3, 0.004))

    def test_errors(self):
        good = lagranto_text(self.ROWS, self.NAMES).decode()
        self.assert_error(vtkLagrantoReader, b"time lon lat p\n1 2 3 4\n", "line of dashes")
        self.assert_error(
            vtkLagrantoReader, lagranto_text(self.ROWS, ("a", "b", "c", "d", "e")), "time lon lat"
        )
        self.assert_error(vtkLagrantoReader, lagranto_text([]), "no row of numbers")
        self.assert_error(
            vtkLagrantoReader,
            good.replace("51.000", "").encode(),
            "line 7: expected 5 columns",
            "found 4",
        )
        self.assert_error(
            vtkLagrantoReader, good.replace("61.000", "61.0 7").encode(), "line 10", "found 6"
        )
        self.assert_error(
            vtkLagrantoReader,
            good.replace("51.000", "5l.000").encode(),
            "line 7: expected a number for 'lat', found '5l.000'",
        )
        for number in ("1e999", "1e39", "-"):
            self.assert_error(
                vtkLagrantoReader, good.replace("51.000", number).encode(), f"found '{number}'"
            )

    def test_truncated(self):
        text = lagranto_text(self.ROWS, self.NAMES)
        for length in range(len(text)):
            output, messages = read(vtkLagrantoReader, text[:length])
            self.assertLessEqual(len(messages), 1)
            self.assertTrue(messages or output.GetNumberOfPoints() > 0)

    def test_progress_and_abort(self):
        pathlib.Path(FILE).write_bytes(lagranto_text(self.ROWS * 500, self.NAMES))
        reader = vtkLagrantoReader()
        reader.SetFileName(FILE)
        seen = []
        reader.AddObserver("ProgressEvent", lambda *_: seen.append(reader.GetProgress()))
        reader.Update()
        seen.remove(0)  # by the pipeline, between the information and the data
        self.assertEqual(seen, sorted(seen))  # the text is parsed once
        self.assertGreater(len(seen), 90)
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 2000)
        reader.Modified()
        reader.AddObserver("ProgressEvent", lambda *_: reader.SetAbortExecute(1))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 0)
