#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-benchmark: what its files hold, and every refusal."""

import csv
import datetime
import fnmatch
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from pictures import read_png

PROGRAM = os.environ["PELLUCID_BENCHMARK"]
FOLDER = pathlib.Path(__file__).resolve().parent.parent / "Benchmark"
KEYS = ["scene", "method", "family", "parameter", "shape", "width", "height", "alpha", "segments",
        "optimized", "fragments", "longest_list", "frames", "cold", "interleaved", "median_ms", "min_ms", "lower_quartile_ms",
        "upper_quartile_ms", "max_ms", "stages", "bytes", "buffer_bytes", "rmse", "max_error", "psnr",
        "ssim", "rmse_covered", "rmse_all_pixels", "max_error_all_pixels", "covered_pixels",
        "edge_pixels", "order_pixels", "skipped", "on_front"]
METHODS = ["vtk-unsorted", "vtk-weighted-blended", "vtk-dual-peeling-1", "vtk-dual-peeling-exact",
           "pellucid", "pellucid-tubes", "pellucid-optimized"]


def read_results(name):
    return json.loads((FOLDER / "Results" / f"{name}.json").read_text())


def read_table(name, folder=FOLDER):
    """What a README has between its marks, and behind them."""
    text = (folder / "README.md").read_text()
    return text.split(f"<!-- {name} -->\n")[1].split(f"<!-- end of {name} -->\n")


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
                         ["date", "pellucid", "renderer", "opengl", "vtk", "processor", "threads"])
        date = datetime.datetime.strptime(figures["machine"]["date"], "%Y-%m-%dT%H:%M:%S%z")
        age = datetime.datetime.now(datetime.timezone.utc) - date
        self.assertLess(abs(age), datetime.timedelta(minutes=5))
        self.assertRegex(figures["machine"]["pellucid"], r"^\d+\.\d+\.\d+$")
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
                self.assertLessEqual(row["rmse_covered"], 0.30, row)
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
        left_out = 100 * exact["edge_pixels"] / exact["covered_pixels"]
        self.assertRegex(table, rf"\| \**pellucid\** \|.*\| {left_out:.1f} \|\n")
        picture = read_png(files[2])
        self.assertGreater(picture.shape[1], 600)
        self.assertGreater(len({tuple(pixel) for pixel in picture.reshape(-1, 3)}), 10)

    def check_row(self, row):
        self.assertEqual(list(row), KEYS)
        self.assertEqual((row["scene"], row["width"], row["height"]), ("abc-50", 200, 150))
        self.assertEqual((row["alpha"], row["segments"], row["frames"]), (0.3, 50 * 99, 2))
        self.assertGreater(row["fragments"], 1000)
        self.assertGreater(row["longest_list"], 1)
        times = [row[key + "_ms"] for key in ("min", "lower_quartile", "median", "upper_quartile", "max")]
        self.assertGreater(times[0], 0)
        self.assertEqual(times, sorted(times))
        self.assertEqual((row["cold"], row["interleaved"], row["skipped"]), (False, True, None))
        self.assertIsNone(row["buffer_bytes"])
        self.assertAlmostEqual(row["psnr"], 20 * math.log10(255 / row["rmse"]), 9)
        self.assertTrue(0.5 < row["ssim"] <= 1)
        self.assertTrue(0 < row["covered_pixels"] < 200 * 150)
        # Lines of few pixels are mostly edges: 242 of 1209 pixels.
        self.assertLess(row["edge_pixels"], 0.25 * row["covered_pixels"])
        self.assertLess(row["order_pixels"], 0.01 * row["covered_pixels"])
        self.assertLess(row["rmse"], row["rmse_covered"])
        self.assertGreaterEqual(row["max_error_all_pixels"], row["max_error"])

    def test_choices(self):
        """Several sizes and opacities, by patterns, without errors; what suits no surface is left out."""
        figures = self.measure(
            "--quick", "--scene", "layers-8", "--method", "vtk-un*", "--method", "pellucid*",
            "--size", "40x30", "--size", "20x50", "--size", "40x30", "--alpha", "0.5", "--alpha", "0.1",
            "--alpha", "0.50", "--frames", "1", "--no-errors")
        self.assertEqual(
            [(row["method"], row["width"], row["alpha"]) for row in figures["rows"]],
            [(method, width, alpha) for width in (40, 20) for alpha in (0.5, 0.1)
             for method in ("vtk-unsorted", "pellucid")])
        for row in figures["rows"]:
            self.assertIsNone(row["rmse"])
            self.assertFalse(row["on_front"])
        self.assertEqual(figures["rows"][1]["longest_list"], 8)

    def test_one_by_one(self):
        """Too many segments for turns: each method alone, with its buffers."""
        figures = self.measure("--quick", "--scene", "abc-20", "--interleave", "1979", "--frames", "1",
                               "--method", "vtk-unsorted", "--method", "pellucid*")
        for row in figures["rows"]:
            self.assertFalse(row["interleaved"])
            self.assertGreater(row["buffer_bytes"], 24 * row["segments"])
            self.assertIsNotNone(row["rmse"])
        figures = self.measure("--quick", "--scene", "abc-20", "--interleave", "1980", "--frames", "1",
                               "--method", "vtk-unsorted", "--method", "pellucid*")
        self.assertTrue(all(row["interleaved"] for row in figures["rows"]))

    def test_memory(self):
        """Methods that need more than is allowed are skipped, or not compared."""
        table = self.folder / "memory.md"
        figures = self.measure("--quick", "--scene", "abc-50", "--frames", "1", "--memory", "0.007",
                               "--method", "vtk-unsorted", "--method", "pellucid", "--table", table)
        triangles, cones = figures["rows"]
        self.assertGreater(triangles["median_ms"], 0)
        self.assertGreater(triangles["fragments"], 1000)
        self.assertIsNone(triangles["rmse"])
        self.assertEqual(triangles["skipped"],
                         "the reference would need about 23.8 MB of memory; --memory allows 7 MB")
        self.assertIsNone(cones["skipped"])
        self.assertLessEqual(cones["max_error"], 1)

        rows = self.folder / "memory.csv"
        figures = self.measure("--quick", "--scene", "abc-50", "--frames", "1", "--memory", "0.0055",
                               "--method", "vtk-unsorted", "--method", "pellucid", "--table", table,
                               "--csv", rows, "--plot", self.folder / "memory.png")
        triangles, cones = figures["rows"]
        self.assertEqual((triangles["frames"], triangles["median_ms"], triangles["rmse"]), (0, None, None))
        self.assertEqual(triangles["skipped"],
                         "the method would need about 6 MB of memory; --memory allows 5.5 MB")
        self.assertIsNotNone(cones["rmse"])
        self.assertIn("| vtk-unsorted | skipped |", table.read_text())
        with open(rows, newline="", encoding="utf-8") as file:
            self.assertEqual(next(csv.DictReader(file))["skipped"], triangles["skipped"])

    def test_cold(self):
        """A first frame that spends four budgets is all there is, and no method to recommend."""
        figures = self.measure("--quick", "--scene", "abc-20", "--budget", "0", "--method", "pellucid")
        row, = figures["rows"]
        self.assertEqual((row["frames"], row["cold"], row["on_front"]), (1, True, False))
        self.assertGreater(row["median_ms"], 0)

    def test_end(self):
        """What is measured when the program is ended is in the file."""
        file = self.folder / "ended.json"
        arguments = ["--quick", "--frames", "1", "--method", "pellucid", "--scene", "abc-20",
                     "--scene", "layers-64", "--json", file]
        with subprocess.Popen([PROGRAM, *map(str, arguments)], stderr=subprocess.PIPE,
                              stdout=subprocess.DEVNULL, encoding="utf-8") as process:
            for line in process.stderr:
                if line.startswith("layers-64"):
                    process.kill()
        self.assertEqual([row["scene"] for row in json.loads(file.read_text())["rows"]][:1], ["abc-20"])

    def test_scaling(self):
        table = self.folder / "scaling.md"
        figures = self.measure("--scaling", "--frames", "1", "--largest-fragments", "1e5",
                               "--largest-segments", "1e4", "--method", "pellucid", "--method",
                               "vtk-unsorted", "--table", table)
        self.assertEqual(figures["rows"], [])
        series = {(line["method"], line["over"]): line for line in figures["scaling"]}
        self.assertEqual(list(series), [(method, over) for over in ("fragments", "segments")
                                        for method in ("vtk-unsorted", "pellucid")])
        for line in series.values():
            for row in line["rows"]:
                self.assertGreater(row["fragments"], 10000)
                self.assertGreater(row["longest_list"], 5)
                self.assertFalse(row["interleaved"])
        fragments = series["pellucid", "fragments"]
        self.assertAlmostEqual(fragments["rows"][0]["fragments"] / 1e5, 1, delta=0.3)
        self.assertIsNone(fragments["time_exponent"])  # of one size
        self.assertIn("exponent of time unknown, of memory unknown", table.read_text())

        # Place, colour and the indices of six corners; 8 points of a tube and 16 triangles.
        for method, bytes_of_segment in (("pellucid", 16 + 4 + 24), ("vtk-unsorted", 400)):
            with self.subTest(method):
                line = series[method, "segments"]
                few, *_, many = line["rows"]
                self.assertEqual((few["segments"], many["segments"]), (1000, 10000))
                geometry = [row["buffer_bytes"] - (row["bytes"] or 0) for row in (few, many)]
                grown = geometry[1] - geometry[0]
                self.assertAlmostEqual(grown / 9000 / bytes_of_segment, 1, delta=0.2)
                exponent = math.log10(many["buffer_bytes"] / few["buffer_bytes"])
                self.assertGreater(line["memory_exponent"], 0)
                self.assertAlmostEqual(line["memory_exponent"], exponent, delta=0.15)

    def test_list(self):
        result = self.run_program("--list", environment={"DISPLAY": ""})
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in ("abc-1000 ", "combustor ", "layers-64 ", *METHODS):
            self.assertIn(name, result.stdout)
        for line in result.stdout.splitlines():
            if line.startswith("  "):
                self.assertRegex(line, r"^  \S+ +\S")
                self.assertLess(line.rindex("  ", 0, 36), 34)


    def list_methods(self):
        result = self.run_program("--list")
        names = result.stdout.split("Methods:\n")[1].splitlines()
        return [line.split()[0] for line in names]

    def test_methods_in_readme(self):
        """Each method has one line in the table of methods, and each line a method."""
        section = (FOLDER / "README.md").read_text().split("### Methods\n")[1].split("\n### ")[0]
        patterns = re.findall(r"^\| `([^`]+)` \| .", section, re.MULTILINE)
        methods = self.list_methods()
        self.assertGreater(len(methods), 40)
        for method in methods:
            found = [pattern for pattern in patterns if fnmatch.fnmatchcase(method, pattern)]
            self.assertEqual(len(found), 1, method)
        for pattern in patterns:
            self.assertTrue(fnmatch.filter(methods, pattern), pattern)


class TestRecord(BenchmarkTest):
    """Why candidates are not in the product."""

    def write(self, rows):
        file = self.folder / "results.json"
        machine = {"renderer": "r", "opengl": "o", "vtk": "9.2", "processor": "p", "threads": 2}
        file.write_text(json.dumps({"machine": machine, "rows": rows}))
        return file

    def make_row(self, scene, method, milliseconds, rmse, on_front=False, alpha=0.3):
        return {"scene": scene, "method": method, "width": 80, "height": 60, "alpha": alpha,
                "median_ms": milliseconds, "rmse": rmse, "on_front": on_front}

    def record(self, file):
        result = self.run_program("--record", file, environment={"DISPLAY": ""})
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_table(self):
        file = self.write([
            self.make_row("a", "pellucid", 10, 0.25, True),
            self.make_row("a", "lists-shell", 15, 0.25),
            self.make_row("a", "k-buffer-4", 5, 1.25, True),
            self.make_row("b", "vtk-unsorted", 1, 9, True),
            self.make_row("b", "pellucid", 20, 0.25, True),
            self.make_row("b", "k-buffer-4", 30, 0.5),
            self.make_row("b", "multi-layer-4", None, None),
            self.make_row("c", "k-buffer-4", 99, 9, True),  # without the product
            self.make_row("b", "pellucid", 20, None, True, alpha=0.1),
            self.make_row("b", "k-buffer-4", 40, None, True, alpha=0.1),
        ])
        lines = self.record(file).splitlines()
        self.assertEqual(lines[0], "r, VTK 9.2, p, 80x60: a at 0.3, b at 0.3, c at 0.3, b at 0.1.")
        shell, buffer = [line.split(" | ") for line in lines[4:]]
        self.assertEqual(shell[:6], ["| `lists-shell`", "-", "1.50", "1.50", "1.50", "0.00"])
        self.assertEqual(
            buffer[:6], ["| `k-buffer-4`", "a at 0.3, b at 0.1", "0.50", "1.50", "2.00", "1.00"])
        for line in shell, buffer:
            self.assertGreater(len(line[6]), 20)  # the reason

    def test_measured(self):
        """Every candidate has a reason, in the file that --json writes as well."""
        file = self.folder / "measured.json"
        self.run_program("--quick", "--scene", "layers-4", "--size", "9x9", "--frames", "1", "--json", file)
        lines = self.record(file).splitlines()[4:]
        rows = json.loads(file.read_text())["rows"]
        candidates = [row["method"] for row in rows if not row["method"].startswith(("vtk-", "pellucid"))]
        self.assertEqual([line.split("`")[1] for line in lines], candidates)
        for line in lines:
            self.assertRegex(line, r" \| [a-z][^|]{20,} \|$")

    def test_readme(self):
        """The table of README.md is that of the results beside it."""
        table, _ = read_table("record")
        self.assertEqual(self.record(FOLDER / "Results" / "llvmpipe.json"), table)

    def test_lines(self):
        """The table of the README of all is that of its results, and so are the ratios below it."""
        rows = {(row["scene"], row["method"]): row for row in read_results("lines")["rows"]}
        table, below = read_table("lines", FOLDER.parent.parent)
        methods = ["vtk-weighted-blended", "vtk-dual-peeling-exact", "pellucid-tubes", "pellucid"]
        expected = [("tubes", method) for method in methods] + [("tubes", "pellucid-optimized")]
        expected += [("abc", method) for method in methods]
        lines = [line.split(" | ") for line in table.splitlines()[2:]]
        self.assertEqual(len(lines), len(expected))
        for line, (scene, method) in zip(lines, expected):
            self.assertEqual("VTK" in line[0], method.startswith("vtk"))
            numbers = [row[key] for row in (rows[f"{scene}-1000", method], rows[f"{scene}-5000", method])
                       for key in ("median_ms", "rmse_covered", "max_error")]
            cells = [f"{number:.{digits}f}" for number, digits in zip(numbers, (0, 2, 0) * 2)]
            self.assertEqual(line[1:], cells[:-1] + [cells[-1] + " |"], line[0])
        ratios = []
        for scene in ("tubes", "abc"):
            for method in ("pellucid", "pellucid-tubes"):
                ratios += [round(rows[f"{scene}-{count}", "vtk-dual-peeling-exact"]["median_ms"] /
                                 rows[f"{scene}-{count}", method]["median_ms"]) for count in (1000, 5000)]
        pairs = re.findall(r"(\d+)\s+and\s+(\d+)\s+times", below.split("![")[0])
        self.assertEqual([int(number) for pair in pairs for number in pair], ratios)

    def test_errors(self):
        rows = {(row["scene"], row["method"]): row for row in read_results("errors")["rows"]}
        lines = read_table("errors")[0].splitlines()[2:]
        self.assertGreater(len(lines), 6)
        for line in lines:
            row = rows[line.split("`")[1], "pellucid"]
            self.assertEqual(line, f"| `{row['scene']}` | {row['covered_pixels']} | {row['edge_pixels']} | "
                             f"{row['order_pixels']} | {row['rmse_covered']:.3f} | {row['max_error']:.0f} | "
                             f"{row['rmse_all_pixels']:.2f} |")
        for row in rows.values():
            self.assertLessEqual(row["rmse_covered"], 0.30)
        above = [(name, row["max_error"]) for name, row in rows.items() if row["max_error"] > 1]
        self.assertEqual(above, [(("abc-10000", "pellucid-tubes"), 2)])

    def test_scaling_tables(self):
        expected = []
        for series in read_results("scaling")["scaling"]:
            expected += [f"`{series['method']}` over {series['over']}: exponent of time "
                         f"{series['time_exponent']:.2f}, of memory {series['memory_exponent']:.2f}.", "",
                         "| window | segments | fragments | longest list | ms | MiB |",
                         "| --- | --- | --- | --- | --- | --- |"]
            for row in series["rows"]:
                digits = 2 if row["median_ms"] < 10 else 1 if row["median_ms"] < 100 else 0
                expected.append(f"| {row['width']}x{row['height']} | {row['segments']} | {row['fragments']} | "
                                f"{row['longest_list']} | {row['median_ms']:.{digits}f} | "
                                f"{row['buffer_bytes'] / 2**20:.1f} |")
            expected.append("")
        self.assertEqual(read_table("scaling")[0].splitlines(), expected[:-1])

    def test_refusals(self):
        absent = self.folder / "absent.json"
        self.refuse(1, "absent.json: cannot be read", "--record", absent)
        other = self.folder / "other.json"
        for text in "{", "[]", '{"machine": {}, "rows": []}':
            other.write_text(text)
            self.refuse(1, "other.json: expected a file that --json has written, found: ", "--record", other)
        self.refuse(1, "expected methods that --list names, found 'lists-bubble'; measure again",
                    "--record", self.write([self.make_row("a", "lists-bubble", 1, 1)]))
        self.refuse(1, "expected a row of 'pellucid' to compare with, found none",
                    "--record", self.write([self.make_row("a", "lists-shell", 1, 1)]))


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
            ("--plot excludes --scaling", "--plot", "a.png", "--scaling"),
            ("--plot excludes --no-errors", "--plot", "a.png", "--no-errors"),
            ("--memory: expected a number of at least 0", "--memory", "-1"),
            ("--interleave: expected a whole number", "--interleave", "few"),
            ("--largest-fragments: expected", "--scaling", "--largest-fragments", "10"),
            ("--largest-segments: expected", "--scaling", "--largest-segments", "1e12"),
            ("--scene excludes --scaling", "--scaling", "--scene", "abc-100"),
            ("--quick excludes --scaling", "--quick", "--scaling"),
            ("--largest-segments requires --scaling", "--largest-segments", "1e4"),
            ("--quick excludes --record", "--record", "a.json", "--quick"),
            ("--json excludes --list", "--list", "--json", "a.json"),
            ("--json, --csv, --table, --plot: expected a file of its own for each, found 'a.csv'",
             "--json", "a.csv", "--csv", "a.csv"),
            ("--colour", "--colour", "red"),
        ):
            with self.subTest(text):
                self.refuse(2, text, *arguments)

    def test_surroundings(self):
        absent = self.folder / "absent" / "figures.json"
        self.refuse(1, "figures.json: cannot be written", "--quick", "--json", absent)
        folder = self.folder / "folder"
        folder.mkdir()
        link = self.folder / "link.json"
        link.symlink_to(absent)
        for other in (folder, link, "/dev/null"):
            self.refuse(1, "expected a new file, or one to replace", "--quick", "--json", other)
        result = self.run_program("--scene", "combustor", "--data", self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("combustor-lines.vtk: no lines could be read", result.stderr)


if __name__ == "__main__":
    unittest.main()
