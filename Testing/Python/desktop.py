# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A virtual X display of a test's own, and what a user does with a window on it."""

import os
import pathlib
import subprocess
import time
import urllib.parse

import numpy
from Xlib import X, XK, display, protocol
from Xlib.ext import xtest

TIMEOUT = 60.0  # seconds


def wait_for(condition, what):
    """The first true value of the condition."""
    end = time.monotonic() + TIMEOUT
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.02)
    raise AssertionError(f"{what}: not within {TIMEOUT:g} s")


class Desktop:
    """An X server without a window manager: windows lie where, and are as large as, they ask for."""

    def __init__(self, dots_per_inch=96, size="1600x1200"):
        reader, writer = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{size}x24", "-nolisten", "tcp",
             "-noreset"],
            pass_fds=(writer,), stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as file:
            self.name = f":{file.readline().strip()}"
        self.display = display.Display(self.name)
        self.root = self.display.screen().root
        resources = f"Xft.dpi: {dots_per_inch}\n".encode()
        self.root.change_property(
            self.atom("RESOURCE_MANAGER"), self.atom("STRING"), 8, resources)
        self.display.sync()

    def close(self):
        if self.server.poll() is None:
            self.display.close()
        self.server.kill()
        self.server.wait()

    def atom(self, name):
        return self.display.intern_atom(name)

    def find_window(self):
        """The one window that is shown."""
        def find():
            shown = [window for window in self.root.query_tree().children
                     if window.get_attributes().map_state == X.IsViewable]
            return shown[0] if shown else None
        return wait_for(find, "a window")

    def look_at(self, window):
        """The colours of a window: rows from the top x columns x 3."""
        size = window.get_geometry()
        image = window.get_image(0, 0, size.width, size.height, X.ZPixmap, 0xFFFFFFFF)
        pixels = numpy.frombuffer(image.data, numpy.uint8).reshape(size.height, size.width, 4)
        return pixels[:, :, 2::-1].astype(int)

    def move(self, x, y):
        """The mouse; from the upper left corner of the screen."""
        xtest.fake_input(self.display, X.MotionNotify, x=x, y=y)
        self.display.sync()
        time.sleep(0.05)  # an event of its own

    def press(self, button):
        xtest.fake_input(self.display, X.ButtonPress, button)
        self.display.sync()
        time.sleep(0.05)

    def release(self, button):
        xtest.fake_input(self.display, X.ButtonRelease, button)
        self.display.sync()
        time.sleep(0.05)

    def click(self, x, y, button=1):
        self.move(x, y)
        time.sleep(0.2)  # what lies below the mouse has to notice it
        self.press(button)
        time.sleep(0.2)
        self.release(button)

    def drag(self, first, last, button=1):
        self.move(*first)
        self.press(button)
        for step in range(1, 5):
            self.move(*(a + (b - a) * step // 4 for a, b in zip(first, last)))
        self.release(button)

    def press_at(self, x, y, button=1):
        """Move there and press in one, so that a program gets both at once."""
        xtest.fake_input(self.display, X.MotionNotify, x=x, y=y)
        xtest.fake_input(self.display, X.ButtonPress, button)
        self.display.sync()

    def type_key(self, window, name, seconds=0):
        """Press, hold and release a key."""
        window.set_input_focus(X.RevertToParent, X.CurrentTime)
        code = self.find_key(name)
        xtest.fake_input(self.display, X.KeyPress, code)
        self.display.sync()
        time.sleep(seconds)
        xtest.fake_input(self.display, X.KeyRelease, code)
        self.display.sync()

    def find_key(self, name):
        return self.display.keysym_to_keycode(XK.string_to_keysym(name))

    def exchange_keys(self, first, second):
        """Their labels, as the keyboards of other countries have them."""
        codes = [self.find_key(name) for name in (first, second)]
        labels = [self.display.get_keyboard_mapping(code, 1)[0] for code in codes]
        for code, label in zip(codes, reversed(labels)):
            self.display.change_keyboard_mapping(code, [label])
        self.display.sync()
        for code in codes:
            self.display._update_keymap(code, 1)

    def send(self, window, kind, values):
        """A message of 5 numbers."""
        window.send_event(protocol.event.ClientMessage(
            window=window, client_type=self.atom(kind), data=(32, values)))
        self.display.sync()

    def ask_to_close(self, window):
        self.send(window, "WM_PROTOCOLS", [self.atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0])

    def drop(self, window, *paths):
        """Drop files, as a file manager does."""
        self.drop_text(window, "".join(f"file://{urllib.parse.quote(str(path))}\r\n" for path in paths))

    def drop_text(self, window, text):
        """Drop a list of addresses: the XDND protocol, version 5."""
        source = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        selection = self.atom("XdndSelection")
        source.set_selection_owner(selection, X.CurrentTime)
        kind = self.atom("text/uri-list")
        self.send(window, "XdndEnter", [source.id, 5 << 24, kind, 0, 0])
        self.send(window, "XdndPosition",
                  [source.id, 0, 10 << 16 | 10, X.CurrentTime, self.atom("XdndActionCopy")])
        self.send(window, "XdndDrop", [source.id, 0, X.CurrentTime, 0, 0])
        request = self.wait_for_event(X.SelectionRequest)
        request.requestor.change_property(request.property, kind, 8, text.encode())
        request.requestor.send_event(protocol.event.SelectionNotify(
            time=request.time, requestor=request.requestor, selection=request.selection,
            target=request.target, property=request.property))
        self.display.sync()

    def wait_for_event(self, kind):
        def find():
            while self.display.pending_events():
                event = self.display.next_event()
                if event.type == kind:
                    return event
            return None
        return wait_for(find, f"event {kind}")


class Program:
    """A program with one window on a desktop, in a folder of its own."""

    def __init__(self, desktop, folder, *arguments, environment=None):
        self.desktop = desktop
        self.folder = pathlib.Path(folder)
        self.process = subprocess.Popen(
            list(map(str, arguments)), cwd=folder, encoding="utf-8", stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env={**os.environ, "DISPLAY": desktop.name, **(environment or {})})
        self.window = desktop.find_window()

    def read_line(self):
        return self.process.stdout.readline().strip()

    def end(self):
        """The exit code and what was said on the error stream."""
        errors = self.process.communicate(timeout=TIMEOUT)[1]
        return self.process.returncode, errors

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def get_processor_time(self):
        """Seconds that it has computed so far."""
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
