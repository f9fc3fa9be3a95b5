# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares decoupled opacity optimisation with the global problem that it stands for.

Section 6.3 of T. Guenther, H. Theisel and M. Gross, Decoupled Opacity Optimization for Points, Lines
and Surfaces (2017), repeated on streamlines of a field, or on a file of trajectories, from several
sides: solves per second of vtkExactTransparencyPass and of vtkGlobalOpacitySolver, and how far their
opacities are apart. The paper found 23 to 83 times as many solves for lines.

What a solve is. Decoupled: the stages `solve` and `smooth` of the pass; with `sort`, on which they
build, beside it. Global: vtkGlobalOpacitySolver::Solve(), that is the occlusion degrees h_ij of the
pixel lists, the matrix and its factorisation; the lists come from vtkReferenceRenderer, and their time
is not counted. Three things set the ratio apart from the paper's, which compares a graphics card with
a processor. Without such a card (`renderer` in the figures tells) all stages run on the processor.
The paper's solver has to copy the lists from the card. And vtkGlobalOpacitySolver, which knows that no
bound is ever active, factorises once instead of searching the bounds. Its time grows with the squares
of the lengths of the lists, that of the decoupled solution with the lengths: --seeds 5000 shows it.

Which parameters correspond. Per pixel, q and r weigh single fragments; globally they weigh squares of
numbers of pixels, so that one value means something else for each picture. Here both are
multiplied by one factor for each view, such that the opacities that both methods give to the visible
segments have the same mean; the figures hold it, times the square of the mean number of pixels of a
segment. It is found by bisection, and each of its steps is one timed solve. n smoothing steps, each
half of the way to the neighbours, spread an opacity with the variance n/2 in squared segments, and the
smoothness s with 2 s where nothing else acts: s = n/4. The importance of a segment is that at its
middle.

    python3 compare_global.py --pictures folder --json figures.json
    python3 compare_global.py --input combxyz.bin combq.bin --importance speed --preset balanced
"""

import argparse
import json
import os
import statistics
import time

import numpy
import pellucid
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (registers the OpenGL classes)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkDataSetReader
from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

PAPERS_SPEEDUP = (23.0, 83.0)
PLOT3D_VELOCITY = 200
FIT_STEPS = 10
COMBUSTOR = os.path.join(os.path.dirname(__file__), "..", "..", "Data", "combustor.vtk")


def read_field(names):
    if len(names) == 2:
        reader = vtkMultiBlockPLOT3DReader()
        reader.SetXYZFileName(names[0])
        reader.SetQFileName(names[1])
        reader.AutoDetectFormatOn()
        reader.AddFunction(PLOT3D_VELOCITY)
        reader.Update()
        field = reader.GetOutput().GetBlock(0)
        field.GetPointData().SetActiveVectors("Velocity")
        return field
    reader = vtkDataSetReader() if names[0].endswith(".vtk") else vtkXMLGenericDataObjectReader()
    reader.SetFileName(names[0])
    reader.Update()
    return reader.GetOutput()


def trace(field, seeds):
    """Streamlines with the arrays `speed` and `vorticity` of their points."""
    arrays = field.GetPointData()
    vectors = arrays.GetVectors() or next(
        array for array in map(arrays.GetArray, range(arrays.GetNumberOfArrays()))
        if array.GetNumberOfComponents() == 3)
    gradient = vtkGradientFilter()
    gradient.SetInputData(field)
    gradient.SetInputArrayToProcess(0, 0, 0, 0, vectors.GetName())
    gradient.ComputeGradientOff()
    gradient.ComputeVorticityOn()
    gradient.SetVorticityArrayName("vorticity")
    tracer = pellucid.vtkFieldStreamlines()
    tracer.SetInputConnection(gradient.GetOutputPort())
    tracer.SetInputArrayToProcess(0, 0, 0, 0, vectors.GetName())
    tracer.SetNumberOfSeeds(seeds)
    tracer.Update()
    lines = tracer.GetOutput()
    speed = numpy.linalg.norm(vtk_to_numpy(lines.GetPointData().GetArray(vectors.GetName())), axis=1)
    add_point_array(lines, "speed", speed)
    return lines


def read_lines(names, seeds):
    """Lines of the input and the arrays that can be their importance, the default first."""
    reader = pellucid.vtkTrajectoryReaderFactory.CreateReader(names[0])
    if not reader:
        return trace(read_field(names), seeds), "vorticity"
    attributes = pellucid.vtkTrajectoryAttributes()
    attributes.SetInputConnection(reader.GetOutputPort())
    attributes.Update()
    return attributes.GetOutput(), "TotalPressureDifference"


def add_point_array(data, name, values):
    array = numpy_to_vtk(numpy.asarray(values, dtype=numpy.float32), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def divide(lines, array, percentiles, segments):
    importance = pellucid.vtkImportance()
    importance.SetInputData(lines)
    importance.AddCriterion(array, *percentiles, 1.0, True, True)
    divider = pellucid.vtkTrajectorySegments()
    divider.SetInputConnection(importance.GetOutputPort())
    divider.SetNumberOfSegments(segments)
    divider.Update()
    return divider.GetOutput()


def cell_array(lengths, ids):
    cells = vtkCellArray()
    offsets = numpy.concatenate([[0], numpy.cumsum(lengths)])
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.asarray(ids, dtype=numpy.int64), deep=True))
    return cells


class Segments:
    """What is known of the segments of lines that vtkTrajectorySegments has divided."""

    def __init__(self, data):
        points = {name: vtk_to_numpy(data.GetPointData().GetArray(name))
                  for name in ("SegmentBase", "SegmentWeight", "Importance")}
        firsts = vtk_to_numpy(data.GetCellData().GetArray("FirstSegment"))
        counts = vtk_to_numpy(data.GetCellData().GetArray("NumberOfSegments"))
        self.number = int(counts.sum())
        self.base, self.weight = points["SegmentBase"], points["SegmentWeight"]
        places, point_place = numpy.unique(self.base + self.weight.astype(float),
                                           return_inverse=True)
        means = (numpy.bincount(point_place, points["Importance"]) / numpy.bincount(point_place))
        ids = numpy.arange(self.number)
        self.importance = numpy.interp(ids, places, means)
        is_first = numpy.isin(ids, firsts)
        is_last = numpy.isin(ids, firsts + counts - 1)
        candidates = numpy.stack([ids - 1, ids + 1], axis=1)
        exists = ~numpy.stack([is_first, is_last], axis=1)
        self.neighbors = cell_array(exists.sum(axis=1), candidates[exists])

    def at_points(self, values):
        following = values[numpy.minimum(self.base + 1, self.number - 1)]
        return (1.0 - self.weight) * values[self.base] + self.weight * following


class Scene:
    """A window with the lines, whose opacities are optimised or those of an array."""

    def __init__(self, data, options):
        self.data = data
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*options.size)
        self.window.OffScreenRenderingOn()
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.window.AddRenderer(self.renderer)
        self.mapper = pellucid.vtkTrajectoryMapper()
        self.mapper.SetInputData(data)
        self.mapper.SetRadius(options.radius)
        self.mapper.SetScalarModeToUsePointFieldData()
        self.mapper.SelectColorArray("Importance")
        self.mapper.SetScalarRange(0.0, 1.0)
        self.mapper.GetLookupTable().SetHueRange(2.0 / 3.0, 0.0)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer.AddActor(self.actor)
        self.optimization = pellucid.vtkOpacityOptimization()
        self.optimization.UsePreset(options.preset)
        pellucid.vtkOpacityOptimization.Attach(self.actor, self.optimization)
        self.renderer.ResetCamera()
        self.camera = self.renderer.GetActiveCamera()
        self.camera.Elevation(20.0)
        self.camera.Zoom(1.4)
        self.transparency = pellucid.install(self.renderer)

    def turn(self, degrees):
        self.camera.Azimuth(degrees)
        self.camera.OrthogonalizeViewUp()
        self.renderer.ResetCameraClippingRange()

    def draw(self):
        self.window.Render()
        self.window.WaitForCompletion()

    def picture(self):
        self.draw()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        return grab.GetOutput()

    def picture_with(self, opacities):
        """The lines with an opacity at each point instead of the optimisation."""
        add_point_array(self.data, "Opacity", opacities)
        self.data.Modified()
        self.mapper.SetOpacityArray("Opacity")
        pellucid.vtkOpacityOptimization.Attach(self.actor, None)
        result = self.picture()
        pellucid.vtkOpacityOptimization.Attach(self.actor, self.optimization)
        self.mapper.SetOpacityArray(None)
        return result

    def time_stages(self, frames):
        """Milliseconds of the stages, frame by frame, each from slightly another side."""
        statistics_of_frame = self.transparency.GetStatistics()
        times = []
        for _ in range(frames):
            self.turn(0.1)
            self.draw()
            times.append({name: statistics_of_frame.GetStageMilliseconds(name)
                          for name in ("sort", "solve", "smooth")})
        return times

    def pixel_lists(self):
        reference = pellucid.vtkReferenceRenderer()
        reference.SetRenderer(self.renderer)
        reference.SetSize(*self.window.GetSize())
        reference.Update()
        lists = vtkCellArray()
        reference.GetPixelSegments(lists)
        return lists


def solve_globally(scene, segments, lists, mean_opacity, visible):
    """Opacities of that mean, the factor on q and r which gives it, and the seconds of each solve."""
    solver = pellucid.vtkGlobalOpacitySolver()
    solver.SetImportance(numpy_to_vtk(segments.importance))
    solver.SetPixelLists(lists)
    solver.SetNeighbors(segments.neighbors)
    solver.SetEmphasis(scene.optimization.GetEmphasis())
    solver.SetSmoothness(scene.optimization.GetSmoothingIterations() / 4.0)
    pixels = lists.GetNumberOfConnectivityIds() / visible.sum()
    lower, upper = numpy.log(1e-3 / pixels ** 2), numpy.log(1e3)
    seconds = []
    for _ in range(FIT_STEPS):
        middle = 0.5 * (lower + upper)
        factor = numpy.exp(middle)
        solver.SetOcclusionWeight(factor * scene.optimization.GetOcclusionWeight())
        solver.SetBackgroundWeight(factor * scene.optimization.GetClutterWeight())
        start = time.perf_counter()
        solver.Solve()
        seconds.append(time.perf_counter() - start)
        opacities = vtk_to_numpy(solver.GetOpacity())
        if opacities[visible].mean() > mean_opacity:
            lower = middle
        else:
            upper = middle
    return opacities, {"weight_factor_times_pixels_squared": factor * pixels ** 2,
                       "pixels_per_segment": pixels, "residual": solver.GetResidual()}, seconds


def compare_view(scene, segments, frames):
    times = scene.time_stages(frames)
    decoupled_picture = scene.picture()
    decoupled = vtk_to_numpy(scene.transparency.GetOptimizedOpacities(scene.actor)).astype(float)
    counts = scene.transparency.GetStatistics()
    visible = decoupled >= 0.0
    opacities, figures, seconds = solve_globally(
        scene, segments, scene.pixel_lists(), decoupled[visible].mean(), visible)
    figures.update(fragments=counts.GetFragments(), longest_list=counts.GetLongestList(),
                   visible_segments=int(visible.sum()))
    global_picture = scene.picture_with(segments.at_points(opacities))
    difference = (opacities - decoupled)[visible]
    colors = [vtk_to_numpy(picture.GetPointData().GetScalars()).astype(float)
              for picture in (decoupled_picture, global_picture)]
    figures["opacities"] = {
        "decoupled_mean": decoupled[visible].mean(), "global_mean": opacities[visible].mean(),
        "mean_absolute_difference": numpy.abs(difference).mean(),
        "rmse": numpy.sqrt((difference ** 2).mean()),
        "correlation": numpy.corrcoef(decoupled[visible], opacities[visible])[0, 1]}
    figures["picture_rmse_of_255"] = numpy.sqrt(((colors[0] - colors[1]) ** 2).mean())
    return figures, times, seconds, (decoupled_picture, global_picture)


def write_side_by_side(pictures, name):
    append = vtkImageAppend()
    for picture in pictures:
        append.AddInputData(picture)
    writer = vtkPNGWriter()
    writer.SetInputConnection(append.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()


def summarize(times, seconds):
    decoupled_ms = statistics.median(row["solve"] + row["smooth"] for row in times)
    with_sort_ms = statistics.median(sum(row.values()) for row in times)
    global_ms = 1000.0 * statistics.median(seconds)
    return {
        "decoupled": {"stages": "solve, smooth", "median_ms": decoupled_ms,
                      "solves_per_second": 1000.0 / decoupled_ms},
        "decoupled_with_sort": {"stages": "sort, solve, smooth", "median_ms": with_sort_ms,
                                "solves_per_second": 1000.0 / with_sort_ms},
        "global": {"stages": "occlusion degrees, matrix, factorisation; pixel lists given",
                   "median_ms": global_ms, "solves_per_second": 1000.0 / global_ms},
        "speedup": global_ms / decoupled_ms, "speedup_with_sort": global_ms / with_sort_ms,
        "papers_speedup": PAPERS_SPEEDUP}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--input", nargs="+", default=[COMBUSTOR],
                        help="a field, two files of PLOT3D, or trajectories; default: the combustor")
    parser.add_argument("--importance", help="point array, such as speed; default: vorticity of a "
                        "field, the total pressure difference of trajectories")
    parser.add_argument("--percentiles", nargs=2, type=float, default=(50.0, 99.0),
                        help="of the array, of importance 0 and 1")
    parser.add_argument("--preset", default="clear-front")
    parser.add_argument("--seeds", type=int, default=1000)
    parser.add_argument("--segments", type=int, default=10000)
    parser.add_argument("--radius", type=float, default=0.0,
                        help="of the lines, in world units; default: from the data")
    parser.add_argument("--size", nargs=2, type=int, default=(800, 600))
    parser.add_argument("--views", type=int, default=4, help="camera positions around the scene")
    parser.add_argument("--frames", type=int, default=7, help="timed frames of each view")
    parser.add_argument("--quick", action="store_true", help="a small run, of seconds")
    parser.add_argument("--pictures", help="folder for pictures: decoupled left, global right")
    parser.add_argument("--json", help="file for the figures")
    options = parser.parse_args()
    if options.quick:
        options.seeds, options.segments, options.size = 100, 1000, (240, 180)
        options.views, options.frames = 2, 2
    return options


def main():
    options = parse_arguments()
    lines, default_importance = read_lines(options.input, options.seeds)
    data = divide(lines, options.importance or default_importance, options.percentiles,
                  options.segments)
    segments = Segments(data)
    scene = Scene(data, options)
    scene.draw()
    views, all_times, all_seconds = [], [], []
    for view in range(options.views):
        figures, times, seconds, pictures = compare_view(scene, segments, options.frames)
        views.append(figures)
        all_times += times
        all_seconds += seconds
        if options.pictures:
            write_side_by_side(pictures, os.path.join(options.pictures, f"view{view}.png"))
        scene.turn(360.0 / options.views)
    renderer = next((line.split(":", 1)[1].strip()
                     for line in scene.window.ReportCapabilities().splitlines()
                     if line.startswith("OpenGL renderer string")), "")
    figures = {"input": options.input, "importance": options.importance or default_importance,
               "preset": options.preset, "lines": data.GetNumberOfLines(),
               "segments": segments.number, "size": options.size, "renderer": renderer,
               **summarize(all_times, all_seconds), "views": views}
    text = json.dumps(figures, indent=2)
    print(text)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            file.write(text + "\n")


if __name__ == "__main__":
    main()
