# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid.add_lines, add_points and add_surface bring data and arrays of NumPy into a renderer."""

import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource

import pellucid
from views import BACK, FRONT, HEIGHTS, ViewTest


class TestData(ViewTest):
    def points_of(self, data):
        actor = pellucid.add_lines(self.renderer, data)
        mesh = actor.GetMapper().GetInput()
        cells = mesh.GetLines()
        self.assertIsInstance(actor.GetMapper(), pellucid.vtkTrajectoryMapper)
        return vtk_to_numpy(mesh.GetPoints().GetData()), vtk_to_numpy(cells.GetOffsetsArray()).tolist()

    def test_arrays_of_points(self):
        for data, offsets in (
            (numpy.array(FRONT), [0, 3]), ([numpy.array(FRONT), BACK[:2]], [0, 3, 5]),
            (FRONT, [0, 3]), ([FRONT, []], [0, 3, 3]), ([], [0]),
            (numpy.array((FRONT, BACK)), [0, 3, 6]),
        ):
            points, found = self.points_of(data)
            self.assertEqual(found, offsets)
            self.assertEqual(len(points), offsets[-1])
        self.assertEqual(points.dtype, numpy.float64)
        self.assertEqual(self.points_of(numpy.array(FRONT, numpy.float32))[0].dtype, numpy.float32)

    def test_poly_data_is_taken_as_it_is(self):
        lines = pellucid.add_lines(self.renderer, [FRONT, BACK]).GetMapper().GetInput()
        self.assertIs(pellucid.add_lines(self.renderer, lines).GetMapper().GetInput(), lines)
        with_scalars = pellucid.add_lines(self.renderer, lines, scalars=HEIGHTS)
        self.assertIsNone(lines.GetPointData().GetArray("Scalars"))
        array = with_scalars.GetMapper().GetInput().GetPointData().GetArray("Scalars")
        self.assertEqual(vtk_to_numpy(array).tolist(), HEIGHTS)

    def test_arrays_take_names_that_nothing_has(self):
        arrays = {"radius": [1, 2, 3], "importance": [4, 5, 6], "scalars": [7, 8, 9]}
        names = {"Importance", "Radius", "Scalars"}
        mesh = self.mesh_of(FRONT)
        for name in names:
            mesh = self.with_array(mesh, name, [0, 0, 0])
        for named in (None, "Importance", "Radius", "Scalars"):
            arguments = {**arrays, "scalars": named} if named else arrays
            actor = pellucid.add_lines(self.renderer, mesh, importance_range=(4, 6), **arguments)
            mapper = actor.GetMapper()
            optimization = pellucid.vtkImportanceDrivenOpacity.Get(actor)
            mapper.Update()
            attributes = mapper.GetInput().GetPointData()
            for name in names:
                self.assertEqual(vtk_to_numpy(attributes.GetArray(name)).tolist(), [0, 0, 0])
            self.assertEqual(
                [vtk_to_numpy(attributes.GetArray(name)).tolist() for name in (
                    mapper.GetRadiusArray(), optimization.GetImportanceArray(), mapper.GetArrayName())],
                [[1, 2, 3], [4, 5, 6], [0, 0, 0] if named else [7, 8, 9]])
        self.assertEqual(mesh.GetPointData().GetNumberOfArrays(), 3)

    def mesh_of(self, lines):
        return pellucid.add_lines(self.renderer, lines).GetMapper().GetInput()

    @staticmethod
    def with_array(mesh, name, values):
        array = numpy_to_vtk(numpy.array(values), deep=True)
        array.SetName(name)
        copy = mesh.NewInstance()
        copy.ShallowCopy(mesh)
        copy.GetPointData().AddArray(array)
        return copy

    def test_values_of_lines_and_of_cells(self):
        lines = numpy.array((FRONT, BACK))
        for given in (lines, list(lines)):
            actor = pellucid.add_lines(
                self.renderer, given, scalars=[(1, 2, 3), (4, 5, 6)],
                radius=numpy.array([(1, 2, 3), (4, 5, 6)]), importance=numpy.zeros((2, 3)))
            actor.GetMapper().Update()
            attributes = actor.GetMapper().GetInput().GetPointData()
            for name in ("Radius", "Scalars"):
                self.assertEqual(vtk_to_numpy(attributes.GetArray(name)).tolist(), [1, 2, 3, 4, 5, 6])
        vectors = numpy.arange(18).reshape(2, 3, 3)
        actor = pellucid.add_lines(self.renderer, lines, scalars=vectors)
        array = actor.GetMapper().GetInput().GetPointData().GetArray("Scalars")
        self.assertEqual(vtk_to_numpy(array).tolist(), vectors.reshape(6, 3).tolist())

        unequal = [FRONT, BACK[:2]]
        for values in ([3, 4], [[3, 3, 3], [4, 4]], numpy.array([3, 3, 3, 4, 4])):
            actor = pellucid.add_lines(
                self.renderer, unequal, radius=values, importance=values, importance_range=(3, 4))
            actor.GetMapper().Update()
            attributes = actor.GetMapper().GetInput().GetPointData()
            for name in ("Radius", "Importance"):
                self.assertEqual(vtk_to_numpy(attributes.GetArray(name)).tolist(), [3, 3, 3, 4, 4])
        named = pellucid.add_lines(self.renderer, unequal, scalars=[3, 4]).GetMapper().GetInput()
        actor = pellucid.add_lines(
            self.renderer, named, radius="Scalars", importance="Scalars", importance_range=(3, 4))
        self.assertEqual(actor.GetMapper().GetRadiusArray(), "Radius")
        self.assertEqual(pellucid.vtkImportanceDrivenOpacity.Get(actor).GetImportanceArray(), "Importance")

        self.renderer.RemoveAllViewProps()
        pellucid.add_lines(
            self.renderer, [FRONT, BACK[:2]], scalars=[2, 5], cmap=[(1, 0, 0), (0, 0, 1)], radius=0.2,
            lighting=False)
        drawn = self.draw()
        self.assertEqual(drawn[20, 30].tolist(), [255, 0, 0])
        self.assertEqual(drawn[10, 30].tolist(), [0, 0, 255])

    def test_none_means_the_default(self):
        actor = pellucid.add_lines(
            self.renderer, FRONT, radius=None, importance=None, preset=None, emphasis=None, opacity=None,
            lighting=None, specular=None, scalars=None, clim=None, color=None)
        self.assertEqual(actor.GetMapper().GetRadius(), 0)
        self.assertEqual(actor.GetProperty().GetOpacity(), 1)
        self.assertIsNone(pellucid.vtkImportanceDrivenOpacity.Get(actor))

    def test_range_of_colors(self):
        for clim, expected in ((2, (-2, 2)), ([1, 3], (1, 3)), (numpy.array((1, 3)), (1, 3)),
                               (numpy.array(2.0), (-2, 2))):
            actor = pellucid.add_lines(self.renderer, FRONT, scalars=[0, 1, 2], clim=clim)
            self.assertEqual(actor.GetMapper().GetScalarRange(), expected)

    def test_types_of_numbers(self):
        for kind in ("?", "i1", "u8", "<i4", ">i4", "<f4", ">f4", ">f8", "f2", "g"):
            with self.subTest(kind=kind):
                values = numpy.array([0, 1, 1], kind)
                actor = pellucid.add_lines(
                    self.renderer, numpy.array(FRONT, ">f4"), scalars=values, radius=values)
                attributes = actor.GetMapper().GetInput().GetPointData()
                for name in ("Scalars", "Radius"):
                    self.assertEqual(vtk_to_numpy(attributes.GetArray(name)).tolist(), [0, 1, 1])
                self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 1))
                self.assertEqual(actor.GetMapper().GetBounds()[4], numpy.float32(0.3) - 1)

    def test_range_of_finite_values(self):
        nan, inf = numpy.nan, numpy.inf
        for values, expected in (
            ([nan, 2, 3], (2, 3)), ([-inf, 2, inf], (2, 2)), ([nan] * 3, (0, 1)),
            ([(0, 3, 4), (nan, 0, 0), (0, 0, 1)], (1, 5)),
        ):
            actor = pellucid.add_lines(self.renderer, FRONT, scalars=values)
            self.assertEqual(actor.GetMapper().GetScalarRange(), expected)

    def test_masked_values_count_as_nan(self):
        values = numpy.ma.array([1, 9, 2], mask=[False, True, False])
        actor = pellucid.add_lines(
            self.renderer, numpy.ma.array(FRONT), scalars=values, radius=values, importance=values)
        mapper = actor.GetMapper()
        mapper.Update()
        self.assertEqual(mapper.GetScalarRange(), (1, 2))
        for name in ("Scalars", "Radius", "Importance"):
            array = mapper.GetInput().GetPointData().GetArray(name)
            numpy.testing.assert_array_equal(vtk_to_numpy(array), [1, numpy.nan, 2])
        actor = pellucid.add_lines(
            self.renderer, numpy.ma.array([FRONT, FRONT]), scalars=numpy.ma.array([values, values]))
        array = actor.GetMapper().GetInput().GetPointData().GetArray("Scalars")
        numpy.testing.assert_array_equal(vtk_to_numpy(array), [1, numpy.nan, 2] * 2)

    def test_composite_data(self):
        blocks = vtkMultiBlockDataSet()
        for i, line in enumerate((FRONT, BACK)):
            lines = pellucid.add_lines(self.renderer, line, scalars=[i, i, i]).GetMapper().GetInput()
            blocks.SetBlock(i, lines)
        actor = pellucid.add_lines(self.renderer, blocks, scalars="Scalars")
        self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 1))
        with self.assertRaisesRegex(TypeError, "scalars: of vtkMultiBlockDataSet, expected the name"):
            pellucid.add_lines(self.renderer, blocks, scalars=HEIGHTS)
        blocks.SetBlock(3, pellucid.add_points(self.renderer, BACK[:2]).GetMapper().GetInput())
        balls = pellucid.add_points(self.renderer, blocks).GetMapper().GetInputDataObject(0, 0)
        self.assertEqual(
            [(balls.GetBlock(i).GetNumberOfVerts(), balls.GetBlock(i).GetNumberOfLines())
             for i in (0, 1, 3)], [(3, 0), (3, 0), (2, 0)])
        self.assertIsNone(balls.GetBlock(2))

    def test_points(self):
        actor = pellucid.add_points(self.renderer, numpy.array(FRONT + BACK))
        mesh = actor.GetMapper().GetInput()
        self.assertEqual(mesh.GetNumberOfVerts(), 6)
        self.assertIs(pellucid.add_points(self.renderer, mesh).GetMapper().GetInput(), mesh)
        lines = pellucid.add_lines(self.renderer, [FRONT], scalars=[1, 2, 3]).GetMapper().GetInput()
        balls = pellucid.add_points(self.renderer, lines, scalars="Scalars").GetMapper().GetInput()
        self.assertEqual((balls.GetNumberOfVerts(), balls.GetNumberOfLines()), (3, 0))


class TestPicture(ViewTest):
    def test_the_renderer_becomes_exact(self):
        pellucid.add_lines(self.renderer, [FRONT, BACK], radius=0.2, color="tomato", opacity=0.5)
        self.assert_reference()
        transparency = pellucid.install(self.renderer)
        self.assertGreater(transparency.GetStatistics().GetLongestList(), 1)
        self.assertIs(pellucid.install(self.window), transparency)
        pellucid.uninstall(self.window)
        self.assertIsNone(self.renderer.GetPass())

    def test_colors(self):
        table = vtkLookupTable()
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 1, 0, 0, 1)
        table.SetTableValue(1, 0, 0, 1, 1)
        for cmap in (table, [(1, 0, 0), (0, 0, 1)], numpy.array([(1, 0, 0, 1), (0, 0, 1, 1.0)])):
            self.renderer.RemoveAllViewProps()
            actor = pellucid.add_lines(
                self.renderer, [FRONT, BACK], radius=0.2, scalars=HEIGHTS, cmap=cmap, lighting=False)
            self.assertEqual(actor.GetMapper().GetScalarRange(), (-0.3, 0.3))
            self.assertEqual(self.draw()[20, 30].tolist(), [0, 0, 255])
            pellucid.add_lines(self.renderer, [FRONT], scalars=HEIGHTS[:3], clim=(2, 4))

    def test_a_table_keeps_its_mode(self):
        table = vtkLookupTable()
        table.SetHueRange(2 / 3, 0)
        table.SetVectorModeToComponent()
        table.SetVectorComponent(1)
        values = numpy.array([(9, 0, 0)] * 3 + [(8, 4, 0)] * 3)
        actor = pellucid.add_lines(
            self.renderer, [FRONT, BACK], radius=0.2, scalars=values, cmap=table, lighting=False)
        self.assertEqual(table.GetVectorMode(), table.COMPONENT)
        self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 4))
        self.assertEqual(self.draw()[20, 30].tolist(), [0, 0, 255])
        self.assertEqual(self.draw()[10, 30].tolist(), [255, 0, 0])

    def test_radius_for_each_point(self):
        for radius in (numpy.float32(0.5), numpy.array(0.5)):
            constant = pellucid.add_lines(self.renderer, FRONT, radius=radius)
            self.assertEqual(constant.GetMapper().GetRadius(), 0.5)
        for radius in ([0.1, 0.2, 0.3], "Radius"):
            self.renderer.RemoveAllViewProps()
            if radius == "Radius":
                data = actor.GetMapper().GetInput()
            else:
                data = FRONT
            actor = pellucid.add_lines(self.renderer, data, radius=radius, color=(1, 1, 1))
            columns = (self.draw().sum(axis=2) > 0).sum(axis=0)
            self.assertGreater(columns[42], 1.5 * columns[18])

    def test_points_without_a_finite_radius_are_left_out(self):
        for wrong in (numpy.nan, numpy.inf):
            self.renderer.RemoveAllViewProps()
            actor = pellucid.add_lines(
                self.renderer, FRONT + BACK, radius=[0.2] * 5 + [wrong], color=(1, 1, 1))
            warnings = []
            actor.GetMapper().AddObserver("WarningEvent", lambda *_: warnings.append(True))
            self.assertGreater(self.draw()[20, 20].max(), 0)
            self.assertEqual(self.draw()[35, 30].max(), 0)
            self.assertTrue(warnings)

    def test_appearance(self):
        actor = pellucid.add_lines(
            self.renderer, FRONT, color="#336699", opacity=0.25, ambient=0.1, diffuse=0.5, specular=0.3,
            specular_power=20, lighting=False, pickable=False, nan_color="red")
        appearance = actor.GetProperty()
        self.assertEqual(
            (appearance.GetOpacity(), appearance.GetAmbient(), appearance.GetDiffuse(),
             appearance.GetSpecular(), appearance.GetSpecularPower(), appearance.GetLighting(),
             actor.GetPickable()), (0.25, 0.1, 0.5, 0.3, 20, False, False))
        for flag in (numpy.int64(0), numpy.bool_(False), numpy.array(False)):
            flat = pellucid.add_lines(self.renderer, FRONT, lighting=flag, pickable=flag)
            self.assertEqual((flat.GetProperty().GetLighting(), flat.GetPickable()), (False, False))
        numpy.testing.assert_allclose(appearance.GetColor(), (0.2, 0.4, 0.6))

    def test_importance(self):
        actor = pellucid.add_lines(
            self.renderer, [FRONT, BACK], radius=0.2, importance=HEIGHTS, importance_range=(0.3, -0.3),
            preset="focus", smoothing_iterations=0)
        found = pellucid.vtkImportanceDrivenOpacity.Get(actor)
        self.assertEqual((found.GetOcclusionWeight(), found.GetSmoothingIterations()), (1000, 0))
        with self.assertRaisesRegex(ValueError, "expected an actor whose opacities the last frame"):
            pellucid.optimized_opacities(self.renderer, actor)
        self.assert_reference()
        opacities = pellucid.optimized_opacities(self.renderer, actor)
        self.assertEqual(opacities.dtype, numpy.float32)
        self.assertLess(numpy.nanmin(opacities), 0.1)
        self.assertEqual(numpy.nanmax(opacities), 1)


class TestSurfaces(ViewTest):
    @staticmethod
    def sphere(radius, depth):
        source = vtkSphereSource()
        source.SetRadius(radius)
        source.SetCenter(0, 0, depth)
        source.SetThetaResolution(32)
        source.SetPhiResolution(32)
        source.Update()
        return source.GetOutput()

    def test_a_surface_fades_before_lines(self):
        """Poly data and composite data; each in the picture of the reference renderer."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(1, TestData.with_array(self.sphere(0.8, 0.5), "Low", numpy.zeros(962)))
        for mesh, importance in ((blocks.GetBlock(1), numpy.zeros(962)), (blocks, "Low")):
            self.renderer.RemoveAllViewProps()
            actor = pellucid.add_surface(
                self.renderer, mesh, color="red", importance=importance, ambient=0.2)
            pellucid.add_lines(
                self.renderer, [FRONT, BACK], radius=0.1, color="white", importance=numpy.ones(6))
            self.assert_reference()
            opacities = pellucid.optimized_opacities(self.renderer, actor)
            self.assertLess(numpy.nanmin(opacities), 0.1)
            self.assertGreater(numpy.nanmax(opacities), 0.9)

    def test_a_surface_of_one_opacity(self):
        sphere = self.sphere(0.8, 0)
        pellucid.add_surface(self.renderer, sphere, scalars=numpy.arange(sphere.GetNumberOfCells()),
                             opacity=0.5)
        self.assert_reference()


if __name__ == "__main__":
    unittest.main()
