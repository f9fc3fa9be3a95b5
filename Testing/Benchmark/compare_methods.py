# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Times exact transparency beside VTK's own methods, in one process on one scene.

The scene is a number of streamlines of the ABC flow with 100 points each, lit as VTK's default. VTK
draws them as 8-sided tubes, Pellucid as ray-cast rounded cones of the same radius and, for
comparison, the same tubes; and with opacities optimised for an importance that grows with the
height. The methods take turns frame by frame, so that a busy machine slows all
of them; read the ratios. An opaque sphere measures what an installed pass costs a scene without
translucent geometry.

    python3 compare_methods.py --lines 1000 --frames 7 --json figures.json
"""

import argparse
import json
import statistics
import time

import numpy
import pellucid
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (registers the OpenGL classes)
from vtkmodules.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                            vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import (vtkCameraPass, vtkLightsPass, vtkOpaquePass,
                                            vtkRenderPassCollection, vtkSequencePass,
                                            vtkTranslucentPass)

POINTS_PER_LINE = 100
STEP = 0.05
RADIUS = 0.03
SIZE = (800, 600)


def abc_velocity(points):
    """Unit velocity of the ABC flow with its usual constants, for an (n, 3) array of points."""
    a, b, c = numpy.sqrt(3.0), numpy.sqrt(2.0), 1.0
    x, y, z = points.T
    velocity = numpy.stack([a * numpy.sin(z) + c * numpy.cos(y),
                            b * numpy.sin(x) + a * numpy.cos(z),
                            c * numpy.sin(y) + b * numpy.cos(x)], axis=1)
    return velocity / numpy.linalg.norm(velocity, axis=1, keepdims=True)


def abc_streamlines(lines):
    """Streamlines from seeded random points, by the classic Runge-Kutta scheme."""
    point = numpy.random.default_rng(1).uniform(0.0, 2.0 * numpy.pi, (lines, 3))
    points = [point]
    for _ in range(POINTS_PER_LINE - 1):
        k1 = abc_velocity(point)
        k2 = abc_velocity(point + 0.5 * STEP * k1)
        k3 = abc_velocity(point + 0.5 * STEP * k2)
        k4 = abc_velocity(point + STEP * k3)
        point = point + STEP / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        points.append(point)
    coordinates = numpy.stack(points, axis=1).reshape(-1, 3).astype(numpy.float32)
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(coordinates, deep=True))
    offsets = numpy.arange(0, lines * POINTS_PER_LINE + 1, POINTS_PER_LINE, dtype=numpy.int64)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(numpy.arange(offsets[-1], dtype=numpy.int64), deep=True))
    data = vtkPolyData()
    data.SetPoints(vtk_points)
    data.SetLines(cells)
    return data


def tubes(lines):
    tube = vtkTubeFilter()
    tube.SetInputData(lines)
    tube.SetNumberOfSides(8)
    tube.SetRadius(RADIUS)
    tube.CappingOn()
    tube.Update()
    return tube.GetOutput()


def divided(lines):
    """The lines in the segments of the optimisation, with importance 0 to 1."""
    data = vtkPolyData()
    data.ShallowCopy(lines)
    height = vtk_to_numpy(lines.GetPoints().GetData())[:, 2]
    importance = numpy_to_vtk(numpy.clip(height / height.max(), 0.0, 1.0).astype(numpy.float32),
                              deep=True)
    importance.SetName("Importance")
    data.GetPointData().AddArray(importance)
    segments = pellucid.vtkTrajectorySegments()
    segments.SetInputData(data)
    segments.Update()
    return segments.GetOutput()


class Method:
    """A window with one actor, and the frame times measured in it."""

    def __init__(self, mapper, data, opacity, prepare):
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.OffScreenRenderingOn()
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.window.AddRenderer(self.renderer)
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetColor(0.2, 0.4, 0.8)
        self.renderer.AddActor(actor)
        self.renderer.ResetCamera()
        self.renderer.GetActiveCamera().Zoom(1.6)
        prepare(self.renderer)
        self.milliseconds = []
        self.draw()

    def draw(self):
        self.renderer.GetActiveCamera().Azimuth(1.0)
        self.renderer.ResetCameraClippingRange()
        start = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return 1000.0 * (time.perf_counter() - start)

    def measure(self):
        self.milliseconds.append(self.draw())

    def figures(self):
        figures = {"median_ms": statistics.median(self.milliseconds),
                   "min_ms": min(self.milliseconds), "max_ms": max(self.milliseconds)}
        transparency = pellucid.vtkTransparencyInstaller.GetPass(self.renderer)
        if transparency:
            counts = transparency.GetStatistics()
            figures["fragments"] = counts.GetFragments()
            figures["longest_list"] = counts.GetLongestList()
            figures["bytes"] = counts.GetBufferBytes()
            figures["stages"] = {counts.GetStageName(i): counts.GetStageMilliseconds(i)
                                 for i in range(counts.GetNumberOfStages())}
        return figures


def stock(_renderer):
    pass


def unsorted(renderer):
    """Plain blending in drawing order, which VTK offers as render passes."""
    passes = vtkRenderPassCollection()
    for render_pass in (vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass()):
        passes.AddItem(render_pass)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    renderer.SetPass(camera)


def exact_peeling(renderer):
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(10000)
    renderer.SetOcclusionRatio(0.0)


def optimized(renderer):
    pellucid.install(renderer)
    pellucid.optimize(renderer.GetActors().GetLastActor())


def trajectories():
    mapper = pellucid.vtkTrajectoryMapper()
    mapper.SetRadius(RADIUS)
    return mapper


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lines", type=int, default=1000)
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--json", help="file for the figures")
    options = parser.parse_args()

    lines = abc_streamlines(options.lines)
    tube_mesh = tubes(lines)
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(200)
    sphere.SetPhiResolution(200)
    sphere.Update()
    ball = sphere.GetOutput()
    install = pellucid.vtkTransparencyInstaller.Install
    methods = {
        "vtk unsorted, tubes": Method(vtkPolyDataMapper(), tube_mesh, 0.3, unsorted),
        "vtk default, tubes": Method(vtkPolyDataMapper(), tube_mesh, 0.3, stock),
        "pellucid, tubes": Method(vtkPolyDataMapper(), tube_mesh, 0.3, install),
        "pellucid, trajectories": Method(trajectories(), lines, 0.3, install),
        "pellucid, optimised": Method(trajectories(), divided(lines), 0.3, optimized),
        "opaque sphere, stock": Method(vtkPolyDataMapper(), ball, 1.0, stock),
        "opaque sphere, installed": Method(vtkPolyDataMapper(), ball, 1.0, install),
    }
    peeling = Method(vtkPolyDataMapper(), tube_mesh, 0.3, exact_peeling)
    for _ in range(options.frames):
        for method in methods.values():
            method.measure()
    # An exact peeling takes as long as dozens of the other frames.
    for _ in range(min(options.frames, 3)):
        peeling.measure()
    methods["vtk exact peeling, tubes"] = peeling

    figures = {name: method.figures() for name, method in methods.items()}
    exact = figures["pellucid, trajectories"]["median_ms"]
    ratios = {
        "to unsorted tubes": exact / figures["vtk unsorted, tubes"]["median_ms"],
        "to exact peeling": exact / figures["vtk exact peeling, tubes"]["median_ms"],
        "optimised to exact": figures["pellucid, optimised"]["median_ms"] / exact,
        "opaque, installed to stock": figures["opaque sphere, installed"]["median_ms"] /
                                      figures["opaque sphere, stock"]["median_ms"],
    }
    for name, row in figures.items():
        print(f"{name:28s} {row['median_ms']:9.1f} ms  ({row['min_ms']:.1f} to {row['max_ms']:.1f})")
    for name, ratio in ratios.items():
        print(f"{name:28s} {ratio:9.3f}")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"lines": options.lines, "methods": figures, "ratios": ratios}, file, indent=2)


if __name__ == "__main__":
    main()
