#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-benchmark: what its files hold, and every refusal."""

import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from pictures import read_png

PROGRAM = os.environ["PELLUCID_BENCHMARK"]
KEYS = ["scene", "method", "family", "width", "height", "alpha", "segments", "optimized", "fragments",
        "longest_list", "frames", "median_ms", "min_ms", "max_ms", "stages", "bytes", "rmse",
        "max_error", "psnr", "ssim", "edge_pixels", "on_front"]
METHODS = ["vtk-unsorted", "vtk-weighted-blended", "vtk-dual-peeling-1", "vtk-dual-peeling-exact",
           "pellucid", "pellucid-tubes", "pellucid-optimized"]


class BenchmarkTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments, environment=None):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            capture_output=True,
            encoding="utf-8",
            timeout=120,
            env={**os.environ, **(environment or {})},
        )

    def measure(self, *arguments):
        file = self.folder / "figures.json"
        result = self.run_program(*arguments, "--json", file)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(file.read_text())

    def refuse(self, code, text, *arguments, environment=None):
        """One line on the error stream that holds the text."""
        result = self.run_program(*arguments, environment=environment)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("pellucid-benchmark: "), result.stderr)
        self.assertIn(text, result.stderr)


class TestFiles(BenchmarkTest):
    def test_quick(self):
        """One small scene, all methods, all files."""
        files = [self.folder / name for name in ("rows.csv", "table.md", "plot.png")]
        figures = self.measure("--quick", "--scene", "abc-50", "--frames", "2", "--csv", files[0],
                               "--table", files[1], "--plot", files[2])
        self.assertEqual(list(figures), ["machine", "rows"])
        self.assertEqual(list(figures["machine"]),
                         ["renderer", "opengl", "vtk", "processor", "threads"])
        rows = {row["method"]: row for row in figures["rows"]}
        self.assertEqual(len(rows), len(figures["rows"]))
        self.assertLessEqual(set(METHODS), set(rows))
        for row in rows.values():
            self.check_row(row)
        exact = rows["pellucid"]
        self.assertGreater(exact["bytes"], 0)
        self.assertIn("gather", exact["stages"])
        self.assertNotIn("solve", exact["stages"])
        self.assertIn("solve", rows["pellucid-optimized"]["stages"])
        for row in figures["rows"]:
            if row["method"].startswith("pellucid"):
                self.assertLessEqual(row["max_error"], 1, row)
                self.assertLessEqual(row["rmse"], 0.30, row)
            elif row["method"].startswith("vtk"):
                self.assertIsNone(row["bytes"])
                self.assertEqual(row["stages"], {})
            else:
                self.assertGreater(row["bytes"], 0)
                self.assertIn("resolve", row["stages"])
        self.assertTrue(any(row["on_front"] for row in rows.values()))

        with open(files[0], newline="", encoding="utf-8") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual(list(lines[0]), KEYS)
        self.assertEqual([line["method"] for line in lines], list(rows))
        self.assertEqual(float(lines[0]["median_ms"]), figures["rows"][0]["median_ms"])
        self.assertEqual(lines[0]["bytes"], "")
        table = files[1].read_text()
        for method in rows:
            self.assertIn(method, table)
        picture = read_png(files[2])
        self.assertGreater(picture.shape[1], 600)
        self.assertGreater(len({tuple(pixel) for pixel in picture.reshape(-1, 3)}), 10)

    def check_row(self, row):
        self.assertEqual(list(row), KEYS)
        self.assertEqual((row["scene"], row["width"], row["height"]), ("abc-50", 200, 150))
        self.assertEqual((row["alpha"], row["segments"], row["frames"]), (0.3, 50 * 99, 2))
        self.assertGreater(row["fragments"], 1000)
        self.assertGreater(row["longest_list"], 1)
        self.assertTrue(0 < row["min_ms"] <= row["median_ms"] <= row["max_ms"])
        self.assertAlmostEqual(row["psnr"], 20 * math.log10(255 / row["rmse"]), 9)
        self.assertTrue(0.5 < row["ssim"] <= 1)
        self.assertTrue(0 <= row["edge_pixels"] < 200 * 150)

    def test_choices(self):
        """Several sizes and opacities, by patterns, without errors; what suits no surface is left out."""
        figures = self.measure(
            "--quick", "--scene", "layers-8", "--method", "vtk-un*", "--method", "pellucid*",
            "--size", "40x30", "--size", "20x50", "--alpha", "0.5", "--alpha", "0.1", "--frames", "1",
            "--no-errors")
        self.assertEqual(
            [(row["method"], row["width"], row["alpha"]) for row in figures["rows"]],
            [(method, width, alpha) for width in (40, 20) for alpha in (0.5, 0.1)
             for method in ("vtk-unsorted", "pellucid")])
        for row in figures["rows"]:
            self.assertIsNone(row["rmse"])
            self.assertFalse(row["on_front"])
        self.assertEqual(figures["rows"][1]["longest_list"], 8)

    def test_scaling(self):
        figures = self.measure("--scaling", "--frames", "1", "--largest-fragments", "1e5",
                               "--largest-segments", "5e3")
        self.assertEqual(figures["rows"], [])
        fragments, segments = figures["scaling"]
        self.assertEqual((fragments["method"], fragments["over"]), ("pellucid", "fragments"))
        self.assertEqual((segments["method"], segments["over"]), ("pellucid", "segments"))
        self.assertEqual([row["segments"] for row in segments["rows"]], [1000, 2000, 5000])
        self.assertAlmostEqual(fragments["rows"][0]["fragments"] / 1e5, 1, delta=0.3)
        self.assertIsNone(fragments["time_exponent"])  # of one size
        self.assertAlmostEqual(segments["memory_exponent"], 0, delta=0.1)

    def test_list(self):
        result = self.run_program("--list", environment={"DISPLAY": ""})
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in ("abc-1000 ", "combustor ", "layers-64 ", *METHODS):
            self.assertIn(name, result.stdout)


class TestRefusals(BenchmarkTest):
    def test_options(self):
        for text, *arguments in (
            ("--scene: no scene is called 'abd-100'; there are abc-100,", "--scene", "abd-100"),
            ("no scene is called 'abc-0'", "--scene", "abc-0"),
            ("no scene is called 'abc-1.5'", "--scene", "abc-1.5"),
            ("no scene is called 'z*'", "--scene", "z*"),
            ("--method: no method is called 'vtk'; there are vtk-unsorted,", "--method", "vtk"),
            ("--size: expected WxH in pixels, each 1 to 65536, found '5'", "--size", "5"),
            ("--alpha: expected a number above 0 and below 1, found '1'", "--alpha", "1"),
            ("--frames: expected a whole number", "--frames", "0"),
            ("--budget: expected a number of at least 0", "--budget", "-1"),
            ("--plot: expected a file name ending in .png, found 'plot.pdf'", "--plot", "plot.pdf"),
            ("--largest-fragments: expected", "--scaling", "--largest-fragments", "10"),
            ("--largest-segments: expected", "--scaling", "--largest-segments", "1e12"),
            ("--colour", "--colour", "red"),
        ):
            with self.subTest(text):
                self.refuse(2, text, *arguments)

    def test_surroundings(self):
        absent = self.folder / "absent" / "figures.json"
        self.refuse(1, "figures.json: cannot be written", "--quick", "--json", absent)
        result = self.run_program("--scene", "combustor", "--data", self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("combustor-lines.vtk: no lines could be read", result.stderr)


if __name__ == "__main__":
    unittest.main()
