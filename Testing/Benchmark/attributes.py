# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Times all attributes of trajectories beside a copy of the arrays involved.

The trajectories are random walks, many short ones or two long ones, with the pressure difference of
whole lines or within a time window. Every attribute is asked for. The arrays involved are the points, pressure, time and cells of the input and
all arrays of the output; each is copied into new memory, as the filter also writes to new memory. The
filter and the copy take turns, so that a busy machine slows both; read the ratios.

    VTK_SMP_BACKEND_IN_USE=STDThread python3 attributes.py --points 10000000 --threads 2 --json out.json
"""

import argparse
import concurrent.futures
import json
import statistics

import numpy
import pellucid
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonSystem import vtkTimerLog

ALLOWED_RATIO = 3.0


def make_trajectories(points, points_per_line):
    """Random walks of equal length in single precision, with pressure and time."""
    random = numpy.random.default_rng(1)
    lines = points // points_per_line
    count = lines * points_per_line
    coordinates = numpy.cumsum(random.standard_normal((count, 3), dtype=numpy.float32), axis=0)
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(coordinates, deep=True))
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(numpy.arange(lines + 1) * points_per_line, deep=True),
                  numpy_to_vtkIdTypeArray(numpy.arange(count), deep=True))
    data = vtkPolyData()
    data.SetPoints(vtk_points)
    data.SetLines(cells)
    time = (numpy.arange(count) % points_per_line).astype(numpy.float32)
    for name, values in (("pressure", random.random(count, dtype=numpy.float32)), ("time", time)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def arrays_involved(data, output):
    arrays = [data.GetPoints().GetData(), data.GetLines().GetConnectivityArray(),
              data.GetLines().GetOffsetsArray(), output.GetCellData().GetArray(0)]
    arrays += [output.GetPointData().GetArray(i)
               for i in range(output.GetPointData().GetNumberOfArrays())]
    return arrays


def new_like(array):
    copied = array.NewInstance()
    copied.SetNumberOfComponents(array.GetNumberOfComponents())
    copied.SetNumberOfTuples(array.GetNumberOfTuples())
    return copied


def copy(arrays, threads):
    """Copy the arrays into new ones, each shared out to the threads."""
    def copy_share(source, target, share):
        tuples = source.GetNumberOfTuples()
        begin, end = (tuples * (share + i) // threads for i in (0, 1))
        vtk_to_numpy(target)[begin:end] = vtk_to_numpy(source)[begin:end]

    copies = [new_like(array) for array in arrays]
    with concurrent.futures.ThreadPoolExecutor(threads) as executor:
        jobs = [executor.submit(copy_share, source, target, share)
                for source, target in zip(arrays, copies) for share in range(threads)]
        for job in jobs:
            job.result()
    return copies


def seconds(function):
    timer = vtkTimerLog()
    timer.StartTimer()
    result = function()
    timer.StopTimer()
    del result
    return timer.GetElapsedTime()


def measure(data, time_window, threads, repeats):
    attributes = pellucid.vtkTrajectoryAttributes()
    attributes.SetInputData(data)
    attributes.SetAllAttributeStatuses(attributes.ON)
    attributes.SetTimeWindow(time_window)

    def compute():
        attributes.Modified()
        attributes.Update()

    compute()
    arrays = arrays_involved(data, attributes.GetOutput())
    filter_seconds, copy_seconds = [], []
    for _ in range(repeats):
        copy_seconds.append(seconds(lambda: copy(arrays, threads)))
        attributes.GetOutput().Initialize()
        filter_seconds.append(seconds(compute))
    return {"points": data.GetNumberOfPoints(), "lines": data.GetNumberOfLines(),
            "time_window": time_window, "threads": threads, "bytes": sum(vtk_to_numpy(array).nbytes for array in arrays),
            "attributes_s": statistics.median(filter_seconds),
            "copy_s": statistics.median(copy_seconds),
            "ratio": statistics.median(filter_seconds) / statistics.median(copy_seconds)}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--json", help="write the figures to this file")
    options = parser.parse_args()
    vtkSMPTools.Initialize(options.threads)
    runs = []
    for points_per_line in (50, options.points // 2):
        data = make_trajectories(options.points, points_per_line)
        for time_window in (0.0, 24.0):
            runs.append(measure(data, time_window, options.threads, options.repeats))
    figures = {"backend": vtkSMPTools.GetBackend(), "allowed_ratio": ALLOWED_RATIO, "runs": runs}
    text = json.dumps(figures, indent=2)
    print(text)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            file.write(text + "\n")


if __name__ == "__main__":
    main()
