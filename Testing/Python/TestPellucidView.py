#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-view: what it shows, what a user does with its window, and what it refuses.

Its pictures have the bits of pellucid-render's, of the same view.
"""

import os
import pathlib
import shlex
import subprocess
import tempfile
import time
import unittest

import desktop
from render_program import DATA, PROGRAM, read_picture

VIEWER = os.environ["PELLUCID_VIEW"]
LINES = DATA / "combustor-lines.vtk"
TRACT = DATA / "fornix.trk"
SIZE = (320, 360)
PANEL = 300
RED = (255, 115, 102)  # of errors in the panel
OLD_OPENGL = {"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLSL_VERSION_OVERRIDE": "330"}
WRONG_OPENGL = {**OLD_OPENGL, "MESA_GL_VERSION_OVERRIDE": "4.3"}  # whose shaders do not compile
MIDDLE = (SIZE[0] // 2, SIZE[1] // 2)

# Where the panel has them, from its upper left corner.
RESET = (45, 17)
SAVE = (135, 17)
METHOD = (80, 40)
SECOND_METHOD = (80, 75)
RULE = (80, 200)
SECOND_IMPORTANCE = (80, 317)


def run(program, *arguments, **environment):
    return subprocess.run(
        [program, *map(str, arguments)], capture_output=True, encoding="utf-8", timeout=120,
        env={**os.environ, **environment})


class TestScreenshots(unittest.TestCase):
    """--screenshot, without a user."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        desk = desktop.Desktop()
        cls.addClassCleanup(desk.close)
        cls.display = desk.name

    def compare(self, *arguments):
        ours, theirs = self.folder / "viewer.png", self.folder / "program.png"
        for program, option, path in ((VIEWER, "--screenshot", ours), (PROGRAM, "-o", theirs)):
            path.unlink(missing_ok=True)
            result = run(program, *arguments, option, path, "--size", "200x150",
                         DISPLAY=self.display)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())

    def test_same_as_pellucid_render(self):
        self.compare(LINES)
        self.compare(LINES, "--opacity", "0.6", "--radius", "0.1", "--lighting", "off")
        self.compare(LINES, "--optimize", "--gather-scale", "2")
        self.compare(LINES, "--importance", "Velocity:0%:100%", "--exponent", "2")
        self.compare(LINES, "--avoid", "weighting", "--importance", "Density:10%:90%")
        self.compare(LINES, "--preset", "focus", "--view", "opacity")
        self.compare(LINES, "--view", "first:2", "--background", "1,1,1")
        self.compare(LINES, TRACT, "--view-up", "0,1,0")

    def test_same_with_other_methods(self):
        self.compare(LINES, "--method", "vtk")
        self.compare(LINES, "--method", "vtk-peeling")

    def refuse(self, code, text, *arguments, **environment):
        result = run(VIEWER, *arguments, **{"DISPLAY": self.display, **environment})
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertTrue(result.stderr.startswith("pellucid-view: "), result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(text, result.stderr)

    def test_usage(self):
        picture = self.folder / "none.png"
        self.refuse(2, "input", "--screenshot", picture)
        self.refuse(2, "a file name ending in .png", LINES, "--screenshot", "none.gif")
        self.refuse(2, "--method", LINES, "--method", "vtk", "--optimize")
        self.refuse(2, "--size", LINES, "--size", "large")
        result = run(VIEWER, "--help")
        self.assertEqual(result.returncode, 0)
        for text in ("Mouse: left turns", "--screenshot", "--preset", "dropped"):
            self.assertIn(text, result.stdout)
        result = run(VIEWER, "--version")
        self.assertRegex(result.stdout, r"^pellucid-view \d+\.\d+\.\d+\n$")

    def test_files(self):
        self.refuse(1, "missing.vtk", "missing.vtk")
        self.refuse(1, "missing.vtk", "missing.vtk", "--screenshot", self.folder / "none.png")
        self.refuse(1, "cannot be written", LINES, "--screenshot", "/missing/none.png")

    def test_without_display(self):
        self.refuse(1, "no window can be opened", LINES, DISPLAY="")
        self.refuse(1, "no window can be opened", LINES, DISPLAY=":9876")

    def test_old_opengl(self):
        picture = self.folder / "old.png"
        self.refuse(1, "--method vtk draws without exactness", LINES, "--screenshot", picture,
                    **OLD_OPENGL)
        result = run(VIEWER, LINES, "--screenshot", picture, "--method", "vtk",
                     DISPLAY=self.display, **OLD_OPENGL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(picture.exists())
        self.refuse(1, "OpenGL 3.2", LINES, MESA_GL_VERSION_OVERRIDE="2.1")


class WindowTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.count = 0

    def start(self, *arguments, environment=None, **screen):
        self.desktop = desktop.Desktop(**screen)
        self.addCleanup(self.desktop.close)
        self.viewer = desktop.Program(
            self.desktop, self.folder, VIEWER, *arguments, environment=environment)
        self.addCleanup(self.viewer.kill)
        self.window = self.viewer.window

    def open_lines(self, *arguments):
        self.arguments = arguments
        self.start(LINES, "--size", "{}x{}".format(*SIZE), *arguments)

    def take_picture(self):
        """That of a viewer which has been asked to save one, and the options that make the same."""
        self.count += 1
        name, view = self.viewer.read_line().split(": ", 1)
        self.assertEqual(name, f"pellucid-view-{self.count}.png")
        return read_picture(self.folder / name), shlex.split(view)

    def save(self):
        self.desktop.type_key(self.window, "s")
        return self.take_picture()

    def assert_as_rendered(self, picture, view, *arguments, name=LINES):
        path = self.folder / "expected.png"
        result = run(PROGRAM, name, *arguments, *view, "-o", path, DISPLAY=self.desktop.name)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        expected = read_picture(path)
        self.assertEqual(expected.shape, picture.shape)
        self.assertEqual(abs(expected - picture).max(), 0)

    def click_panel(self, position):
        width = self.window.get_geometry().width
        self.desktop.click(width - PANEL + position[0], position[1])

    def end(self, code=0):
        found, errors = self.viewer.end()
        self.assertEqual(found, code, errors)
        return errors


class TestMouseAndKeys(WindowTest):
    def test_view(self):
        self.open_lines("--optimize")
        first, view = self.save()
        self.assert_as_rendered(first, view, "--optimize")
        self.assertEqual(first.shape, (SIZE[1], SIZE[0], 3))
        x, y = MIDDLE
        for change in (
            lambda: self.desktop.drag(MIDDLE, (x + 60, y + 30)),
            lambda: self.desktop.drag(MIDDLE, (x + 30, y), button=2),
            lambda: self.desktop.drag(MIDDLE, (x, y - 40), button=3),
            lambda: self.desktop.click(x, y, button=4),
        ):
            before, _ = self.save()
            change()
            picture, view = self.save()
            self.assertGreater(abs(picture - before).mean(), 0.5)
            self.assert_as_rendered(picture, view, "--optimize")
        self.desktop.type_key(self.window, "r")
        picture, _ = self.save()
        self.assertEqual(abs(picture - first).max(), 0)
        self.desktop.type_key(self.window, "q")
        self.end()

    def test_shown_is_saved(self):
        self.open_lines()
        saved, _ = self.save()
        shown = self.desktop.look_at(self.window)[:, :SIZE[0]]
        self.assertEqual(abs(shown - saved).max(), 0)

    def test_resize(self):
        self.open_lines()
        first, _ = self.save()
        self.window.configure(width=700, height=500)
        self.desktop.display.sync()
        desktop.wait_for(lambda: self.desktop.look_at(self.window).shape[0] == 500, "new size")
        time.sleep(0.5)
        picture, view = self.save()
        self.assertEqual(picture.shape, (500, 400, 3))
        self.assert_as_rendered(picture, view)
        self.assert_as_rendered(picture, ["--size", "400x500"])
        # The panel leaves the picture the whole window.
        self.desktop.type_key(self.window, "Tab")
        picture, view = self.save()
        self.assertEqual(picture.shape, (500, 700, 3))
        self.assert_as_rendered(picture, view)
        self.assert_as_rendered(picture, ["--size", "700x500"])

    def test_a_turned_view_stays_where_the_size_changes(self):
        self.open_lines()
        self.desktop.drag(MIDDLE, (MIDDLE[0] + 60, MIDDLE[1] + 30))
        _, (_, _, *turned) = self.save()
        self.desktop.type_key(self.window, "Tab")
        picture, (_, size, *view) = self.save()
        self.assertEqual((size, view), (f"{SIZE[0] + PANEL}x{SIZE[1]}", turned))
        self.desktop.type_key(self.window, "r")
        picture, _ = self.save()
        self.assert_as_rendered(picture, ["--size", size])

    def test_sleeps(self):
        self.open_lines("--optimize")
        self.save()
        time.sleep(1.5)  # the fade
        before = self.viewer.get_processor_time()
        time.sleep(1.5)
        self.assertLess(self.viewer.get_processor_time() - before, 0.1)

    def test_fades(self):
        self.open_lines("--preset", "focus")
        self.save()
        self.desktop.drag(MIDDLE, (MIDDLE[0] + 100, MIDDLE[1]))
        fading = self.desktop.look_at(self.window)[:, :SIZE[0]]
        time.sleep(4.0)
        faded = self.desktop.look_at(self.window)[:, :SIZE[0]]
        self.assertGreater(abs(faded - fading).max(), 0)
        picture, view = self.save()
        self.assertEqual(abs(picture - faded).max(), 0)
        self.assert_as_rendered(picture, view, "--preset", "focus")

    def test_held_keys_act_once(self):
        self.open_lines()
        self.save()
        self.desktop.type_key(self.window, "s", 2)
        self.take_picture()
        self.save()
        self.assertEqual(len(list(self.folder.iterdir())), 3)

    def test_keys_are_those_of_the_labels(self):
        self.open_lines()
        self.desktop.exchange_keys("a", "q")
        self.desktop.type_key(self.window, "a")
        self.save()
        self.desktop.type_key(self.window, "q")
        self.assertEqual(self.end(), "")

    def test_dots_per_inch(self):
        self.start(LINES, "--size", "700x400", dots_per_inch=192)
        picture, view = self.save()
        self.assertEqual(picture.shape, (400, 700, 3))
        self.assertEqual(self.window.get_geometry().width, 700 + 2 * PANEL)
        self.assert_as_rendered(picture, view)

    def test_small_screen(self):
        self.start(LINES, size="1280x800")
        picture, view = self.save()
        self.assertEqual(picture.shape, (800, 1280 - PANEL, 3))
        size = self.window.get_geometry()
        self.assertEqual((size.x, size.y, size.width, size.height), (0, 0, 1280, 800))
        self.assert_as_rendered(picture, view)
        self.assert_as_rendered(picture, ["--size", f"{1280 - PANEL}x800"])


class TestPanel(WindowTest):
    def test_buttons(self):
        self.open_lines()
        first, _ = self.save()
        self.desktop.drag(MIDDLE, (MIDDLE[0] + 50, MIDDLE[1]))
        self.click_panel(SAVE)
        turned, view = self.take_picture()
        self.assertGreater(abs(turned - first).mean(), 0.5)
        self.assert_as_rendered(turned, view)
        self.click_panel(RESET)
        self.click_panel(SAVE)
        self.assertEqual(abs(self.take_picture()[0] - first).max(), 0)

    def test_method(self):
        self.open_lines()
        self.save()
        # The message of the picture has moved the rest down.
        self.desktop.type_key(self.window, "r")
        self.click_panel(METHOD)
        self.click_panel(SECOND_METHOD)
        time.sleep(0.5)
        picture, view = self.save()
        self.assert_as_rendered(picture, view, "--method", "vtk")

    def test_rule(self):
        self.open_lines()
        even, _ = self.save()
        self.desktop.type_key(self.window, "r")
        self.click_panel(RULE)
        self.click_panel((RULE[0], RULE[1] + 42))
        time.sleep(0.5)
        picture, view = self.save()
        self.assertGreater(abs(picture - even).mean(), 0.5)
        self.assert_as_rendered(picture, view, "--optimize")

    def test_importance_of_two_arrays(self):
        first = ("--optimize", "--color-by", "Velocity", "--importance", "Velocity:0:20")
        self.start(LINES, "--size", "320x600", *first)
        self.save()
        self.desktop.type_key(self.window, "r")
        self.click_panel(SECOND_IMPORTANCE)
        self.click_panel((SECOND_IMPORTANCE[0], SECOND_IMPORTANCE[1] + 75))
        time.sleep(0.5)
        picture, view = self.save()
        self.assert_as_rendered(picture, view, *first, "--importance", "Density:50%:99%")

    def test_the_scene_stays_where_the_panel_is_pressed(self):
        self.open_lines()
        first, _ = self.save()
        x, y = SIZE[0] + PANEL // 2, SIZE[1] - 5
        self.desktop.move(*MIDDLE)
        time.sleep(0.5)
        self.desktop.press_at(x, y)
        self.desktop.move(x - 100, y - 50)
        self.desktop.release(1)
        self.desktop.move(*MIDDLE)
        time.sleep(0.5)
        self.desktop.press_at(x, y, button=4)
        self.desktop.release(4)
        self.assertEqual(abs(self.save()[0] - first).max(), 0)


class TestFiles(WindowTest):
    def count_red(self):
        return (self.desktop.look_at(self.window) == RED).all(axis=2).sum()

    def test_empty_window(self):
        self.start("--size", "700x400")
        desktop.wait_for(lambda: self.desktop.look_at(self.window).shape[1] == 700 + PANEL, "its size")
        desktop.wait_for(
            lambda: (self.desktop.look_at(self.window)[:, :700] == 255).all(axis=2).sum() > 1000, "a hint")
        self.desktop.drop(self.window, TRACT)
        time.sleep(1.0)
        saved, view = self.save()
        self.assert_as_rendered(saved, view, name=TRACT)
        self.assertEqual(abs(self.desktop.look_at(self.window)[:, :700] - saved).max(), 0)

    def test_drop_without_a_file(self):
        self.open_lines()
        first, _ = self.save()
        self.desktop.drop_text(self.window, "# nothing\r\n")
        self.assertEqual(abs(self.save()[0] - first).max(), 0)
        self.desktop.type_key(self.window, "q")
        self.assertEqual(self.end(), "")

    def test_error_without_panel(self):
        self.open_lines()
        self.save()
        self.desktop.type_key(self.window, "Tab")
        self.desktop.drop(self.window, self.folder)
        desktop.wait_for(lambda: self.count_red() > 100, "an error")
        self.desktop.type_key(self.window, "r")
        desktop.wait_for(lambda: self.count_red() == 0, "no error")
        self.desktop.type_key(self.window, "q")
        errors = self.end()
        self.assertTrue(errors.startswith("pellucid-view: "), errors)
        self.assertIn(self.folder.name, errors)
        self.assertEqual(len(errors.splitlines()), 1, errors)

    def test_drop(self):
        self.start("--size", "{}x{}".format(*SIZE))
        self.desktop.drag(MIDDLE, (MIDDLE[0] + 50, MIDDLE[1]))  # nothing to turn or save yet
        self.desktop.type_key(self.window, "r")
        self.desktop.type_key(self.window, "s")
        desktop.wait_for(lambda: self.count_red() > 100, "an error")
        self.desktop.drop(self.window, TRACT)
        desktop.wait_for(lambda: self.count_red() == 0, "no error")
        time.sleep(1.0)
        picture, view = self.save()
        self.assert_as_rendered(picture, view, name=TRACT)

    def test_unreadable(self):
        self.open_lines("--importance", "Velocity:0:20")
        first, _ = self.save()
        for name, content in (("no lines.vtk", "no lines"), ("empty.nc", ""), ("", None)):
            path = self.folder / name
            if content is not None:
                path.write_text(content)
            self.desktop.drop(self.window, path)
            desktop.wait_for(lambda: self.count_red() > 100, "an error")
            picture, view = self.save()
            self.assertEqual(abs(picture - first).max(), 0)
            desktop.wait_for(lambda: self.count_red() == 0, "no error")
        # What was said of the old file is no error for the next one.
        self.desktop.drop(self.window, TRACT)
        time.sleep(1.0)
        picture, view = self.save()
        self.assert_as_rendered(picture, view, name=TRACT)

    def test_pictures_with_errors_are_not_saved(self):
        self.start(LINES, "--size", "{}x{}".format(*SIZE), environment=WRONG_OPENGL)
        desktop.wait_for(lambda: self.count_red() > 100, "an error")
        for _ in range(2):
            self.desktop.type_key(self.window, "s")
            time.sleep(1.0)
            self.assertGreater(self.count_red(), 100)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.desktop.type_key(self.window, "q")
        self.assertIn("the picture cannot be drawn: ", self.end())

    def test_old_opengl(self):
        self.start(LINES, "--size", "{}x{}".format(*SIZE), environment=OLD_OPENGL)
        orange = (255, 204, 102)
        desktop.wait_for(
            lambda: (self.desktop.look_at(self.window) == orange).all(axis=2).sum() > 100,
            "a message")
        picture, view = self.save()
        self.assertGreater(picture.std(), 5)


class TestEnds(WindowTest):
    def test_close(self):
        self.open_lines()
        self.save()
        self.desktop.ask_to_close(self.window)
        self.assertEqual(self.end(), "")

    def test_escape(self):
        self.open_lines()
        self.save()
        self.desktop.type_key(self.window, "Escape")
        self.assertEqual(self.end(), "")

    def test_escape_closes_a_list_first(self):
        self.open_lines()
        self.save()
        self.desktop.type_key(self.window, "r")
        time.sleep(0.5)
        closed = self.desktop.look_at(self.window)
        self.click_panel(METHOD)
        self.desktop.move(*MIDDLE)
        time.sleep(0.5)
        opened = self.desktop.look_at(self.window)
        self.assertGreater((opened != closed).sum(), 10000)
        self.desktop.type_key(self.window, "Escape")
        desktop.wait_for(
            lambda: (self.desktop.look_at(self.window) != closed).sum() < 5000, "a closed list")
        picture, view = self.save()
        self.assert_as_rendered(picture, view)
        self.desktop.type_key(self.window, "Escape")
        self.assertEqual(self.end(), "")

    def expect_lost_connection(self):
        """In the words of Xlib, which depend on how it has noticed."""
        self.assertRegex(self.end(1), "^(X connection|XIO: +fatal)")

    def test_lost_window(self):
        self.open_lines()
        self.save()
        self.window.kill_client()
        self.desktop.display.sync()
        self.expect_lost_connection()

    def test_lost_display(self):
        self.open_lines()
        self.save()
        self.desktop.server.kill()
        self.expect_lost_connection()
