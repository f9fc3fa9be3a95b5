# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share inside ParaView: loading it, scenes, pictures."""

import contextlib
import os
import sys
import tempfile

from paraview import servermanager, simple

import pellucid
import pictures


def load_plugin():
    """Load the plugin here and, if there is one, on the server."""
    for remote in {False, servermanager.ActiveConnection.IsRemote()}:
        simple.LoadPlugin(os.environ["PELLUCID_PLUGIN"], remote=remote, ns=vars(simple))


def create_view(size=200):
    """A render view whose camera ParaView leaves alone."""
    simple._DisableFirstRenderCameraReset()
    return simple.CreateView("RenderView", ViewSize=[size, size], OrientationAxesVisibility=0)


def gradient(wavelet=None):
    source = simple.Gradient(Input=wavelet or simple.Wavelet(), ScalarArray=["POINTS", "RTData"])
    source.UpdatePipeline()  # seeds and lengths follow from its bounds
    return source


def stream_lines(field=None):
    """Twenty lines through the gradient of ParaView's wavelet."""
    tracer = simple.StreamTracer(Input=field or gradient(), SeedType="Line")
    tracer.Vectors = ["POINTS", "Gradient"]
    tracer.SeedType.Resolution = 19
    tracer.MaximumStepLength = 1.0
    tracer.InitialStepLength = 1.0
    return tracer


def show(source, view, representation="Pellucid", opacity=0.5):
    display = simple.Show(source, view)
    assert representation in display.GetProperty("Representation").Available
    display.Representation = representation
    display.Opacity = opacity
    return display


def place_camera(view):
    """Look at the wavelet from a corner."""
    view.CameraPosition = [40.0, 30.0, 30.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 25.0


def draw_scene(view):
    """Fading lines and translucent surfaces, stock ones among them; the display of the lines."""
    lines = show(stream_lines(), view)
    lines.TubeRadius = 0.4
    lines.ImportanceArray = ["POINTS", "RTData"]
    lines.AutomaticImportanceRange = 0
    lines.ImportanceRange = [150.0, 260.0]
    lines.OpacityPreset = "Balanced"
    simple.ColorBy(lines, ("POINTS", "RTData"))
    shells = simple.Contour(Input=simple.Wavelet(), ContourBy=["POINTS", "RTData"])
    shells.Isosurfaces = [130.0, 200.0]
    show(shells, view, opacity=0.3)
    ball = simple.Sphere(Radius=7.0, ThetaResolution=32, PhiResolution=32)
    show(ball, view, "Surface", opacity=0.4).DiffuseColor = [0.9, 0.3, 0.1]
    place_camera(view)
    return lines


def picture(view):
    simple.Render(view)
    return pictures.picture(view.GetRenderWindow())


def save(path, view, **options):
    """Save Screenshot; the picture that the file holds."""
    simple.SaveScreenshot(str(path), view, **options)
    return pictures.read_png(path)


def fragments(view):
    """The number of translucent fragments of the last picture; None where the view is ParaView's own."""
    transparency = pellucid.vtkTransparencyInstaller.GetPass(view.GetClientSideObject().GetRenderer())
    return transparency and transparency.GetStatistics().GetFragments()


def statistics(view):
    """What the panel's information says of the last picture, of the first display Pellucid."""
    display = next(each for each in view.Representations if each.GetPropertyValue("Representation") == "Pellucid")
    display.SMProxy.UpdatePropertyInformation()
    names = ("Fragments", "SolvedFragments", "LongestList", "BufferBytes", "SeesAllFragments")
    figures = {name: display.GetPropertyValue(name) for name in names}
    figures["UsedImportanceRange"] = list(display.GetPropertyValue("UsedImportanceRange"))
    figures["Stages"] = [stage.split()[0] for stage in display.GetPropertyValue("StageTimes").split(", ")]
    return figures


@contextlib.contextmanager
def silence(case):
    """Nothing may be said meanwhile: no error, no warning, neither of VTK nor of OpenGL."""
    with tempfile.TemporaryFile("w+") as said:
        kept = os.dup(2)
        os.dup2(said.fileno(), 2)
        try:
            yield
        finally:
            sys.stderr.flush()
            os.dup2(kept, 2)
            os.close(kept)
            said.seek(0)
            text = said.read()
            sys.stderr.write(text)
        case.assertEqual(text, "")
