# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid.optimize and pellucid.avoid attach parameters, pellucid.restore ends them."""

import gc
import re
import unittest
import warnings

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCompositePolyDataMapper,
    vtkDataSetMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import pellucid
from pictures import picture

PRESETS = ["clear-front", "balanced", "focus", "clear-back", "points"]


def with_array(data, name, values):
    array = numpy_to_vtk(numpy.asarray(values, numpy.float32), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)
    return data


def make_lines(importance="Importance"):
    """A line of importance 0 in front of one of importance 1."""
    append = vtkAppendPolyData()
    for first, last in (((-1, 0, 0.2), (1, 0, 0.2)), ((0, -1, -0.2), (0, 1, -0.2))):
        line = vtkLineSource()
        line.SetPoint1(first)
        line.SetPoint2(last)
        append.AddInputConnection(line.GetOutputPort())
    append.Update()
    return with_array(append.GetOutput(), importance, (0, 0, 1, 1))


def make_actor(data, mapper=None):
    mapper = mapper or pellucid.vtkTrajectoryMapper()
    if isinstance(mapper, pellucid.vtkTrajectoryMapper):
        mapper.SetRadius(0.1)
    mapper.ScalarVisibilityOff()
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def make_sphere():
    source = vtkSphereSource()
    source.Update()
    sphere = source.GetOutput()
    return with_array(sphere, "Importance", numpy.linspace(0, 1, sphere.GetNumberOfPoints()))


def make_window(*actors):
    renderer = vtkRenderer()
    for actor in actors:
        renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(0, 0, 4)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(64, 48)
    window.AddRenderer(renderer)
    return pellucid.install(renderer), window


def noted(caller, event):
    """The list that takes the messages of an object from now on."""
    messages = []

    def note(_caller, _event, message):
        messages.append(message)
    note.CallDataType = "string0"
    caller.AddObserver(event, note)
    return messages


class TestOptimize(unittest.TestCase):
    def setUp(self):
        self.actor = make_actor(make_lines())

    def assert_same_parameters(self, found, expected):
        for member in ("OcclusionWeight", "ClutterWeight", "Emphasis", "SmoothingIterations"):
            self.assertEqual(getattr(found, "Get" + member)(), getattr(expected, "Get" + member)())

    def test_presets(self):
        self.assertEqual(pellucid.presets(), PRESETS)
        for name in PRESETS:
            expected = pellucid.vtkOpacityOptimization()
            expected.UsePreset(name)
            self.assert_same_parameters(pellucid.optimize(self.actor, name), expected)
        default = pellucid.optimize(self.actor)
        self.assert_same_parameters(default, pellucid.optimize(self.actor, PRESETS[0]))
        self.assert_same_parameters(default, pellucid.vtkOpacityOptimization())

    def test_unknown_preset_changes_nothing(self):
        optimization = pellucid.vtkOpacityOptimization()
        optimization.UsePreset("focus")
        messages = noted(optimization, "ErrorEvent")
        self.assertFalse(optimization.UsePreset("x"))
        self.assertIn(
            f'There is no preset "x". Use one of: {", ".join(PRESETS)}.', "".join(messages))
        self.assert_same_parameters(optimization, pellucid.optimize(self.actor, "focus"))

    def test_parameters(self):
        found = pellucid.optimize(
            self.actor, "focus", occlusion_weight=7, clutter_weight=8.5, emphasis=2,
            smoothing_iterations=9, self_occlusion=True)
        self.assertIs(pellucid.vtkImportanceDrivenOpacity.Get(self.actor), found)
        self.assertEqual(
            (found.GetOcclusionWeight(), found.GetClutterWeight(), found.GetEmphasis(),
             found.GetSmoothingIterations(), found.GetSelfOcclusion(), found.GetImportanceArray()),
            (7, 8.5, 2, 9, True, "Importance"))
        actor = make_actor(make_lines("relevance"))
        self.assertEqual(
            pellucid.optimize(actor, importance="relevance").GetImportanceArray(), "relevance")
        for function in (pellucid.optimize, pellucid.avoid):
            self.assertEqual(function(self.actor).GetImportanceRange(), (0, 1))
            for ends in ((8, -2.5), [0, 1e5], numpy.array((0.5, 2), numpy.float32)):
                found = function(self.actor, importance_range=ends).GetImportanceRange()
                self.assertEqual(found, tuple(ends))

    def test_front_fades_and_comes_back(self):
        self.actor.GetProperty().SetColor(1, 0, 0)
        transparency, window = make_window(self.actor)
        window.Render()
        before = picture(window)
        pellucid.optimize(self.actor, occlusion_weight=1, clutter_weight=0, smoothing_iterations=0)
        window.Render()
        self.assertGreater(transparency.GetStatistics().GetSolvedFragments(), 0)
        opacities = vtk_to_numpy(transparency.GetOptimizedOpacities(self.actor))
        seen = opacities[opacities >= 0]
        self.assertAlmostEqual(seen.min(), 0.5, places=5)
        self.assertAlmostEqual(seen.max(), 1, places=5)
        pellucid.restore(self.actor)
        window.Render()
        self.assertTrue(numpy.array_equal(picture(window), before))
        self.assertEqual(transparency.GetStatistics().GetSolvedFragments(), 0)

    def test_any_array_and_its_range(self):
        actor = make_actor(with_array(make_lines(), "speed", (10, 10, 3, 3)))
        found = []
        for chosen, importance, ends in (
                (self.actor, "Importance", (0, 1)), (actor, "speed", (10, 3)),
                (actor, "speed", (3, 10))):
            pellucid.optimize(chosen, importance=importance, importance_range=ends)
            transparency, window = make_window(chosen)
            window.Render()
            found.append(vtk_to_numpy(transparency.GetOptimizedOpacities(chosen)).tolist())
        self.assertEqual(found[0], found[1])
        self.assertNotEqual(found[0], found[2])

    def test_missing_importance_is_told(self):
        other = make_actor(make_lines("other"))
        optimization = pellucid.optimize(self.actor)
        optimization.Attach(other, optimization)
        transparency, window = make_window(self.actor, other)
        messages = noted(transparency, "WarningEvent")
        window.Render()
        self.assertIn('has no point array "Importance" of one component', "".join(messages))

    def test_segments_are_put_in_once_and_taken_out(self):
        for actor, filter_class in (
            (self.actor, pellucid.vtkTrajectorySegments),
            (make_actor(make_sphere(), vtkPolyDataMapper()), pellucid.vtkSurfaceSegments),
            (make_actor(make_sphere()), pellucid.vtkSurfaceSegments),
            (make_actor(vtkMultiBlockDataSet()), pellucid.vtkTrajectorySegments),
        ):
            mapper = actor.GetMapper()
            before = mapper.GetInputAlgorithm()
            for _ in range(2):
                pellucid.optimize(actor)
                gc.collect()
                self.assertIsInstance(mapper.GetInputAlgorithm(), filter_class)
                self.assertIs(mapper.GetInputAlgorithm().GetInputAlgorithm(), before)
            pellucid.avoid(actor)
            pellucid.restore(actor)
            self.assertIs(mapper.GetInputAlgorithm(), before)
            self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))
            pellucid.restore(actor)
            self.assertIs(mapper.GetInputAlgorithm(), before)

    def test_pipeline_stays_live(self):
        move = vtkTransformPolyDataFilter()
        move.SetInputData(make_lines())
        move.SetTransform(vtkTransform())
        mapper = self.actor.GetMapper()
        mapper.SetInputConnection(move.GetOutputPort())
        pellucid.optimize(self.actor)
        move.GetTransform().Translate(5, 0, 0)
        mapper.Update()
        self.assertAlmostEqual(mapper.GetInput().GetBounds()[0], 4, places=6)
        self.assertTrue(mapper.GetInput().GetPointData().HasArray("SegmentBase"))

    def test_own_segments_are_kept(self):
        segments = pellucid.vtkTrajectorySegments()
        segments.SetInputData(make_lines())
        self.actor.GetMapper().SetInputConnection(segments.GetOutputPort())
        pellucid.optimize(self.actor)
        self.assertIs(self.actor.GetMapper().GetInputAlgorithm(), segments)
        pellucid.restore(self.actor)
        self.assertIs(self.actor.GetMapper().GetInputAlgorithm(), segments)

    def test_composite_data(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_lines())
        blocks.SetBlock(2, make_lines())
        actor = make_actor(blocks)
        pellucid.optimize(actor)
        actor.GetMapper().Update()
        output = actor.GetMapper().GetInputDataObject(0, 0)
        self.assertTrue(output.GetBlock(2).GetPointData().HasArray("SegmentBase"))

    def test_surfaces_take_few_steps_of_smoothing(self):
        for make, parameters, expected in (
            (make_lines, {}, 50), (make_sphere, {}, 5), (make_sphere, {"smoothing_iterations": 9}, 9),
        ):
            actor = make_actor(make())
            for _ in range(2):  # the second time with segments
                found = pellucid.optimize(actor, "focus", **parameters)
                self.assertEqual(found.GetSmoothingIterations(), expected)

    def test_data_may_come_later(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_lines())
        for empty, later in ((vtkPolyData(), make_lines()), (vtkMultiBlockDataSet(), blocks)):
            actor = make_actor(empty)
            pellucid.optimize(actor)
            transparency, window = make_window(actor)
            messages = noted(transparency, "WarningEvent")
            window.Render()
            empty.ShallowCopy(later)
            window.Render()
            opacities = pellucid.optimized_opacities(window.GetRenderers().GetFirstRenderer(), actor)
            self.assertGreater(len(opacities), 1)
            self.assertLess(numpy.nanmin(opacities), 0.1)
            self.assertFalse(messages)
        self.assertIsNotNone(pellucid.optimize(make_actor(vtkPolyData(), vtkPolyDataMapper())))

    def test_restoring_one_of_a_mapper_takes_the_segments_of_all(self):
        other = vtkActor()
        other.SetMapper(self.actor.GetMapper())
        for actor in (self.actor, other):
            pellucid.optimize(actor)
        pellucid.restore(self.actor)
        other.GetMapper().Update()
        self.assertFalse(other.GetMapper().GetInput().GetPointData().HasArray("SegmentBase"))
        pellucid.optimize(other)
        other.GetMapper().Update()
        self.assertTrue(other.GetMapper().GetInput().GetPointData().HasArray("SegmentBase"))


class TestAvoid(unittest.TestCase):
    def test_parameters(self):
        actor = make_actor(make_lines())
        found = pellucid.avoid(
            actor, "weighting", penalty=0.5, importance_weight=2, coverage_weight=3,
            directional_variance_weight=4, depth_weight=5, importance_exponent=6, global_opacity=0.25,
            smooth_attributes=True)
        self.assertIs(pellucid.vtkImportanceDrivenOpacity.Get(actor), found)
        self.assertEqual(
            (found.GetMode(), found.GetPenalty(), found.GetImportanceWeight(),
             found.GetCoverageWeight(), found.GetDirectionalVarianceWeight(), found.GetDepthWeight(),
             found.GetImportanceExponent(), found.GetGlobalOpacity(), found.GetSmoothAttributes()),
            (found.WEIGHTING, 0.5, 2, 3, 4, 5, 6, 0.25, True))
        self.assertEqual(pellucid.avoid(actor).GetMode(), found.PENALTY)


class TestWarnings(unittest.TestCase):
    ROWS = (
        (r"importance is 1 everywhere in this actor, so that within it nothing fades in favour of anything else; "
         r"expected values of 'speed' that differ within importance_range \(0, 1\), found them from 3 to 20; "
         "choose other limits or another array", (3, 20, 5, 6), (0, 1)),
        ("importance is 0 everywhere in this actor, .* 'speed' on both sides of importance_range 1, found them "
         "from 0 to 0.5", (0, 0.5, 0, 0.5), (1, 1)),
        ("importance is 1 everywhere in this actor, .* importance_range 0, found them from 0 to 0.5",
         (0, 0.5, 0, 0.5), (0, 0)),
        ("importance is 0 everywhere in this actor, .* importance_range 1, found them from 0 to 0",
         (0, 0, 0, 0), (1, 1)),
        (r"importance is 0 everywhere in this actor, .* \(9, 8\), found them from 10 to inf",
         (10, numpy.inf, 12, 10), (9, 8)),
        (r"importance is 0 everywhere in this actor, .* \(0, 1\), found NaN alone; choose another array",
         (numpy.nan,) * 4, (0, 1)),
    )

    def test_even_importance_is_told_once(self):
        for message, values, ends in self.ROWS:
            data = with_array(make_lines("other"), "speed", values)
            renderer = vtkRenderer()
            for call in (
                lambda: pellucid.optimize(make_actor(data), importance="speed", importance_range=ends),
                lambda: pellucid.avoid(make_actor(data), importance="speed", importance_range=ends),
                lambda: pellucid.add_lines(renderer, data, importance="speed", importance_range=ends),
            ):
                with warnings.catch_warnings(record=True) as found:
                    warnings.simplefilter("always")
                    call()
                self.assertEqual(len(found), 1)
                self.assertRegex(str(found[0].message), f"^{message}")
                self.assertEqual(found[0].filename, __file__)

    def test_warnings_as_errors_change_no_view(self):
        renderer = vtkRenderer()
        data = with_array(make_lines(), "speed", (1, 2, 3, 4))
        with warnings.catch_warnings(), self.assertRaisesRegex(UserWarning, "importance is 1 everywhere"):
            warnings.simplefilter("error")
            pellucid.add_lines(renderer, data, importance="speed")
        self.assertEqual(renderer.GetActors().GetNumberOfItems(), 0)
        for function in (pellucid.optimize, pellucid.avoid):
            actor = make_actor(data)
            source = actor.GetMapper().GetInputAlgorithm()
            with warnings.catch_warnings(), self.assertRaisesRegex(UserWarning, "importance is 1 everywhere"):
                warnings.simplefilter("error")
                function(actor, importance="speed")
            self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))
            self.assertIs(actor.GetMapper().GetInputAlgorithm(), source)

    def test_refused_actors_are_not_warned_of(self):
        actor = make_actor(with_array(make_lines(), "speed", (1, 2, 3, 4)), vtkPolyDataMapper())
        with warnings.catch_warnings(), self.assertRaisesRegex(TypeError, "expected a vtkTrajectoryMapper"):
            warnings.simplefilter("error")
            pellucid.optimize(actor, importance="speed")

    def test_importance_of_bits(self):
        """NumPy has no such arrays."""
        bits = vtkBitArray()
        bits.SetName("speed")
        for value in (0, 1, 1, 0):
            bits.InsertNextValue(value)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for function in (pellucid.optimize, pellucid.avoid):
                data = make_lines()
                data.GetPointData().AddArray(bits)
                function(make_actor(data), importance="speed")

    def test_no_warning(self):
        """Where importance differs, an actor gives way as a whole, or there are no points yet."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, with_array(make_lines(), "speed", (3, 4, 5, 6)))
        blocks.SetBlock(1, make_lines())
        partly = with_array(make_lines(), "speed", (numpy.nan, 4, 5, 6))
        step = with_array(make_lines(), "speed", (3, 4, 5, 6))
        even = with_array(make_lines(), "speed", (1, 1, 1, 1))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for data, ends in ((blocks, (0, 1)), (partly, (0, 1)), (step, (4, 4)), (even, (0, 1)),
                               (vtkPolyData(), (1, 1))):
                for function in (pellucid.optimize, pellucid.avoid):
                    function(make_actor(data), importance="speed", importance_range=ends)


class TestErrors(unittest.TestCase):
    def test_unknown_parameters(self):
        actor = make_actor(make_lines())
        for function, names in (
            (pellucid.optimize, "occlusion_weight, clutter_weight, emphasis, smoothing_iterations, "
             "self_occlusion"),
            (pellucid.avoid, "penalty, importance_weight, coverage_weight, "
             "directional_variance_weight, depth_weight, importance_exponent, "
             "global_opacity, smooth_attributes"),
        ):
            with self.assertRaisesRegex(TypeError, f"unknown parameter 'x'; there are {names}$"):
                function(actor, x=1)
        for function, letters in (
            (pellucid.optimize, {"q": "occlusion_weight", "r": "clutter_weight", "lambda": "emphasis",
                                 "s": "smoothing_iterations"}),
            (pellucid.avoid, {"m": "importance_weight", "c": "coverage_weight",
                              "v": "directional_variance_weight", "d": "depth_weight",
                              "lambda": "importance_exponent"}),
        ):
            for letter, name in letters.items():
                with self.assertRaisesRegex(TypeError, f"unknown parameter '{letter}'; use {name}$"):
                    function(actor, **{letter: 1})

    def test_values_out_of_range(self):
        actor = make_actor(make_lines())
        with self.assertRaisesRegex(ValueError, "emphasis: expected a number from 0.01 to 100, found 0"):
            pellucid.optimize(actor, emphasis=0)
        with self.assertRaisesRegex(ValueError, "penalty: expected a number from 0 to 1, found 2"):
            pellucid.avoid(actor, penalty=2)
        with self.assertRaisesRegex(ValueError, "occlusion_weight: expected a number of at least 0, found nan"):
            pellucid.optimize(actor, occlusion_weight=float("nan"))
        with self.assertRaisesRegex(TypeError, "self_occlusion: expected True or False, found 2"):
            pellucid.optimize(actor, self_occlusion=2)
        with self.assertRaisesRegex(TypeError, "penalty: expected a number from 0 to 1, found 'a'"):
            pellucid.avoid(actor, penalty="a")

    def test_wrong_ranges(self):
        actor = make_actor(make_lines())
        for function in (pellucid.optimize, pellucid.avoid):
            for error, wrong in (
                (ValueError, (0, 1, 2)), (ValueError, ()), (ValueError, (0, float("nan"))),
                (ValueError, (float("-inf"), 1)), (ValueError, (0, 10**400)), (TypeError, 1),
                (TypeError, None), (TypeError, "01"), (TypeError, (0, "1")), (TypeError, (0, 1j)),
            ):
                with self.assertRaisesRegex(error, "importance_range: expected two finite numbers, "
                                            f"found {re.escape(repr(wrong)[:50])}"):
                    function(actor, importance_range=wrong)
        self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))

    def test_unknown_names(self):
        actor = make_actor(make_lines())
        with self.assertRaisesRegex(ValueError, f"expected one of {', '.join(PRESETS)}; found 'x'"):
            pellucid.optimize(actor, "x")
        for wrong in ("x", ["penalty"]):
            with self.assertRaisesRegex(
                    ValueError, f"expected one of penalty, weighting; found {re.escape(repr(wrong))}"):
                pellucid.avoid(actor, wrong)
        for function in (pellucid.optimize, pellucid.avoid):
            with self.assertRaisesRegex(
                    ValueError, "there is no point array 'x' of one component; there are Importance"):
                function(actor, importance="x")
            with self.assertRaisesRegex(
                    TypeError, r"importance: expected the name of a point array, found an array of float64 of "
                    r"shape \(4,\); put the values into the data as one, or give them to add_lines\(\), "):
                function(actor, importance=numpy.zeros(4))
        self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))

    def test_wrong_actors(self):
        for function in (pellucid.optimize, pellucid.avoid, pellucid.restore):
            for wrong in (None, vtkRenderer(), "actor"):
                with self.assertRaisesRegex(TypeError, "expected a vtkActor, found"):
                    function(wrong)
        without_input = vtkActor()
        without_input.SetMapper(vtkPolyDataMapper())
        for actor in (vtkActor(), without_input):
            for function in (pellucid.optimize, pellucid.avoid):
                with self.assertRaisesRegex(ValueError, "no mapper with an input"):
                    function(actor)
            pellucid.restore(actor)

    def test_mappers_without_importance_are_refused(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_lines())
        with self.assertRaisesRegex(TypeError, "lines and points: expected a vtkTrajectoryMapper"):
            pellucid.optimize(make_actor(make_lines(), vtkPolyDataMapper()))
        for data, mapper in ((vtkUnstructuredGrid(), vtkDataSetMapper()),
                             (blocks, vtkCompositePolyDataMapper())):
            actor = make_actor(data, mapper)
            for function in (pellucid.optimize, pellucid.avoid):
                with self.assertRaisesRegex(
                        TypeError, re.escape(f"one vtkPolyData, found a {mapper.GetClassName()}; "
                                             "pellucid.add_surface(), add_lines() and add_points() add ")):
                    function(actor)
            self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))

    def test_lines_and_surfaces_in_one(self):
        mixed = make_lines()
        mixed.SetPolys(mixed.GetLines())
        actor = make_actor(mixed)
        with self.assertRaisesRegex(ValueError, "both lines or points and surfaces"):
            pellucid.optimize(actor)
        self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))


if __name__ == "__main__":
    unittest.main()
