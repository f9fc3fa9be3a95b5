# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""States, traces, undo, copies and links keep what the representation has been told."""

import pathlib
import unittest

from paraview import servermanager, simple, smstate, smtrace
from paraview.modules.vtkRemotingServerManager import (
    vtkSMLink,
    vtkSMPropertyLink,
    vtkSMUndoStack,
    vtkSMUndoStackBuilder,
)
from vtkmodules.test import Testing

from pictures import read_png
from plugin import create_view, draw_scene, load_plugin, picture, save, show, stream_lines
from processes import HERE, program, run

TEMPORARY = pathlib.Path(Testing.VTK_TEMP_DIR)


def properties_modified(proxy, **values):
    """Set properties and have the trace record it, as the panel does."""
    item = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": proxy})
    for name, value in values.items():
        setattr(proxy, name, value)
    item.finalize()


class TestPluginState(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load_plugin()

    def setUp(self):
        self.view = create_view()

    def tearDown(self):
        simple.Delete(self.view)
        del self.view  # ParaView crashes in the end if a view is left
        simple.ResetSession()

    def show_lines(self):
        display = show(stream_lines(), self.view)
        simple.ResetCamera(self.view)
        return display

    def same(self, first, second):
        return first.shape == second.shape and bool((first == second).all())

    def assert_reproduces(self, path):
        """A process of its own draws the same picture from the file."""
        expected = save(TEMPORARY / "expected.png", self.view, ImageResolution=[200, 200])
        folder = TEMPORARY / path.name.replace(".", "_")
        said = run(program("pvpython"), HERE / "draw.py", folder, "--state", path)
        self.assertGreater(int(said.rsplit("fragments:", 1)[1]), 1000)
        self.assertTrue(self.same(read_png(folder / "opaque.png"), expected))

    def test_a_state_file_gives_the_same_picture(self):
        draw_scene(self.view)
        path = TEMPORARY / "scene.pvsm"
        simple.SaveState(str(path))
        self.assert_reproduces(path)

    def test_a_python_state_gives_the_same_picture(self):
        draw_scene(self.view)
        path = TEMPORARY / "state.py"
        path.write_text(smstate.get_state())
        self.assertIn("Representation = 'Pellucid'", path.read_text())
        self.assert_reproduces(path)

    def test_a_trace_gives_the_same_picture(self):
        simple.Delete(self.view)
        smtrace.start_trace()
        self.view = simple.CreateView("RenderView")
        properties_modified(self.view, ViewSize=[200, 200], OrientationAxesVisibility=0)
        ball = simple.Sphere()
        properties_modified(ball, ThetaResolution=32, PhiResolution=32)
        display = simple.Show(ball, self.view)
        display.SetRepresentationType("Pellucid")
        properties_modified(display, Opacity=0.4, DiffuseColor=[0.9, 0.3, 0.1], TubeRadius=0.25)
        simple.ResetCamera(self.view)
        path = TEMPORARY / "trace.py"
        path.write_text(smtrace.stop_trace())
        for line in ("SetRepresentationType('Pellucid')", ".TubeRadius = 0.25", ".Opacity = 0.4"):
            self.assertIn(line, path.read_text())
        self.assert_reproduces(path)

    def test_undo_and_redo(self):
        stack = vtkSMUndoStack()
        builder = vtkSMUndoStackBuilder()
        builder.SetUndoStack(stack)
        manager = servermanager.vtkSMProxyManager.GetProxyManager()
        manager.SetUndoStackBuilder(builder)
        self.addCleanup(stack.Clear)
        self.addCleanup(manager.SetUndoStackBuilder, None)
        display = self.show_lines()
        pictures = [picture(self.view)]
        for name, value in (("TubeRadius", 0.7), ("Opacity", 0.2), ("Representation", "Surface")):
            builder.Begin(name)
            setattr(display, name, value)
            builder.EndAndPushToStack()
            pictures.append(picture(self.view))
            self.assertFalse(self.same(pictures[-1], pictures[-2]))
        for expected in reversed(pictures[:-1]):
            self.assertTrue(stack.CanUndo())
            stack.Undo()
            display.UpdateVTKObjects()  # as the desktop client does
            self.assertTrue(self.same(picture(self.view), expected))
        for expected in pictures[1:]:
            self.assertTrue(stack.CanRedo())
            stack.Redo()
            display.UpdateVTKObjects()
            self.assertTrue(self.same(picture(self.view), expected))

    def test_properties_are_copied_to_another_display(self):
        display = self.show_lines()
        display.TubeRadius = 0.7
        display.Opacity = 0.3
        expected = picture(self.view)
        display.Visibility = 0
        copy = simple.Show(stream_lines(), self.view)
        self.assertFalse(self.same(picture(self.view), expected))
        copy.SMProxy.Copy(display.SMProxy)
        copy.Visibility = 1
        self.assertEqual((copy.Representation, copy.TubeRadius, copy.Opacity), ("Pellucid", 0.7, 0.3))
        self.assertTrue(self.same(picture(self.view), expected))

    def test_linked_displays_follow_one_another(self):
        display = self.show_lines()
        follower = show(simple.Sphere(), self.view)
        link = vtkSMPropertyLink()
        link.AddLinkedProperty(display.SMProxy, "TubeRadius", vtkSMLink.INPUT)
        link.AddLinkedProperty(follower.SMProxy, "TubeRadius", vtkSMLink.OUTPUT)
        display.TubeRadius = 0.6
        self.assertEqual(follower.TubeRadius, 0.6)


if __name__ == "__main__":
    unittest.main()
