# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of PyVista's examples of translucency are exact once the plotter is installed."""

import base64
import io
import unittest
import warnings

import numpy
import pyvista
from PIL import Image
from pyvista import examples
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkWebCore import vtkWebApplication

import pellucid

# Kept: VTK's crashes where it ends while its threads encode a picture.
APPLICATION = vtkWebApplication()
RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def crossing_lines():
    """A horizontal one of height 0 in front of a vertical one of height 1."""
    lines = pyvista.PolyData(
        numpy.array([(-1, 0, 0.3), (0, 0, 0.3), (1, 0, 0.3), (0, -1, -0.3), (0, 0, -0.3), (0, 1, -0.3)]),
        lines=[3, 0, 1, 2, 3, 3, 4, 5])
    lines["Height"] = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0]
    return lines


def sent_by_server(plotter):
    """What the back end "server" sends to a notebook: a JPEG."""
    encoded = APPLICATION.StillRender(plotter.render_window)
    return numpy.asarray(Image.open(io.BytesIO(base64.b64decode(bytes(encoded)))), float)


def sent_as_picture(plotter):
    """What the back end "static" sends; it closes the plotter."""
    return numpy.asarray(plotter.show(jupyter_backend="static", return_viewer=True), float)[:, :, :3]


class PlotterTest(unittest.TestCase):
    def setUp(self):
        self.plotter = self.make_plotter()

    def make_plotter(self, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 160), **options)
        self.addCleanup(plotter.close)
        plotter.disable_anti_aliasing()
        return plotter

    def assert_exact(self, plotter=None, least_layers=2):
        """But for outlines, the picture is that of the reference renderer."""
        plotter = plotter or self.plotter
        transparency = pellucid.install(plotter)
        found = plotter.screenshot(return_img=True)[:, :, :3].astype(float)
        self.assertGreaterEqual(transparency.GetStatistics().GetLongestList(), least_layers)
        expected = 255 * pellucid.reference_picture(plotter.renderer)[:, :, :3]
        difference = abs(found - expected).max(axis=2)
        self.assertLess((difference > 1).mean(), 0.01)
        self.assertLess((difference ** 2).mean() ** 0.5, 2.0)
        return found


class TestTranslucency(PlotterTest):
    def test_one_opacity(self):
        self.plotter.add_mesh(pyvista.Sphere(), color="tan", opacity=0.4, smooth_shading=True)
        self.plotter.add_mesh(pyvista.Cube(x_length=0.5), color="red", opacity=0.6, show_edges=False)
        self.assert_exact(least_layers=4)

    def test_opacity_follows_scalars(self):
        for opacity in ("linear", "sigmoid_6", [0, 0.2, 0.9, 0.2, 0.1]):
            with self.subTest(opacity=opacity):
                plotter = self.make_plotter()
                mesh = examples.load_random_hills()
                plotter.add_mesh(mesh, scalars="Elevation", opacity=opacity, show_scalar_bar=False)
                self.assert_exact(plotter)

    def test_opacity_by_array(self):
        mesh = pyvista.Sphere()
        mesh["fade"] = numpy.linspace(0, 1, mesh.n_points)
        mesh["height"] = mesh.points[:, 2]
        self.plotter.add_mesh(mesh, scalars="height", opacity="fade", show_scalar_bar=False)
        self.assert_exact()

    def test_depth_peeling_is_not_needed(self):
        centers = [(0, 0, 0), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)]
        spheres = pyvista.merge([pyvista.Sphere(radius=1.5, center=center) for center in centers])
        pictures = []
        for number_of_peels in (None, 1):
            plotter = self.make_plotter()
            plotter.add_mesh(spheres, color="tan", opacity=0.5)
            if number_of_peels:
                plotter.enable_depth_peeling(number_of_peels)
            pictures.append(self.assert_exact(plotter, least_layers=8))
        numpy.testing.assert_array_equal(*pictures)

    def test_glyphs(self):
        points = pyvista.PolyData(numpy.random.default_rng(1).uniform(-1, 1, (60, 3)))
        points["vectors"] = points.points[:, [1, 2, 0]]
        arrows = points.glyph(orient="vectors", scale=False, factor=0.6)
        self.plotter.add_mesh(arrows, color="lime", opacity=0.4)
        self.assert_exact(least_layers=6)

    def test_order_does_not_matter(self):
        pictures = []
        for colors in ((RED, BLUE), (BLUE, RED)):
            plotter = self.make_plotter()
            pellucid.install(plotter)
            for color in colors:
                plotter.add_mesh(
                    pyvista.Plane(center=(0, 0, 0.1 if color == RED else 0)), color=color, opacity=0.5)
            plotter.camera_position = "xy"
            pictures.append(plotter.screenshot(return_img=True))
        numpy.testing.assert_array_equal(*pictures)

    def test_geometry_beside_a_volume(self):
        self.plotter.add_mesh(pyvista.Sphere(center=(-2, 0, 0)), color="tan", opacity=0.5)
        self.plotter.add_mesh(pyvista.Sphere(center=(-2, 0, 0), radius=0.3), color="red", opacity=0.5)
        grid = pyvista.ImageData(dimensions=(10, 10, 10), spacing=(0.1, 0.1, 0.1), origin=(1, -0.5, -0.5))
        grid["values"] = numpy.linspace(0, 1, grid.n_points)
        self.plotter.add_volume(grid, show_scalar_bar=False)
        self.plotter.camera_position = "xy"
        transparency = pellucid.install(self.plotter)
        found = self.plotter.screenshot(return_img=True)[:, :, :3].astype(float)
        self.assertGreaterEqual(transparency.GetStatistics().GetLongestList(), 4)
        expected = 255 * pellucid.reference_picture(self.plotter.renderer)[:, :, :3]
        difference = abs(found - expected).max(axis=2)
        self.assertLess((difference[:, :100] > 1).mean(), 0.01)
        self.assertGreater((difference[:, 100:] > 1).mean(), 0.05)

    def test_windows_of_several_plots(self):
        plotter = self.make_plotter(shape=(1, 2))
        for column, color in enumerate((RED, BLUE)):
            plotter.subplot(0, column)
            plotter.add_mesh(pyvista.Sphere(), color=color, opacity=0.5)
        self.assertIs(pellucid.install(plotter), pellucid.install(plotter.renderer))
        passes = [pellucid.install(renderer) for renderer in plotter.renderers]
        self.assertIs(pellucid.install(plotter), passes[1])
        plotter.screenshot(return_img=True)
        for transparency in passes:
            self.assertEqual(transparency.GetStatistics().GetLongestList(), 2)
        pellucid.uninstall(plotter)

    def test_antialiasing(self):
        for technique in ("ssaa", "msaa", "fxaa"):
            with self.subTest(technique=technique):
                plotter = self.make_plotter()
                plotter.enable_anti_aliasing(technique)
                plotter.add_mesh(pyvista.Sphere(), color=RED, opacity=0.5, lighting=False)
                pellucid.install(plotter)
                picture = plotter.screenshot(return_img=True)
                numpy.testing.assert_allclose(picture[80, 100], (255, 64, 64), atol=1)
                numpy.testing.assert_array_equal(picture[0, 0], (255, 255, 255))

    def test_transparent_background(self):
        self.plotter.add_mesh(pyvista.Sphere(), color=RED, opacity=0.5, lighting=False)
        pellucid.install(self.plotter)
        picture = self.plotter.screenshot(transparent_background=True, return_img=True)
        self.assertEqual(picture[0, 0, 3], 0)
        # Of the white background a quarter remains in the colour, as VTK blends it.
        numpy.testing.assert_allclose(picture[80, 100], (255, 64, 64, 191), atol=1)

    def test_overlays(self):
        plotter = self.make_plotter()
        plotter.add_mesh(pyvista.Sphere(), color="tan", opacity=0.4)
        plotter.add_point_labels([(0.0, 0.0, 0.0)], ["middle"])
        plotter.add_text("sphere")
        transparency = pellucid.install(plotter)
        warnings = []
        transparency.AddObserver("WarningEvent", lambda *_: warnings.append(True))
        plotter.screenshot(return_img=True)
        self.assertFalse(warnings)
        self.assertEqual(transparency.statistics.longest_list, 2)

    def test_notebooks(self):
        for exact in (True, False):
            plotter = self.make_plotter(notebook=True)
            for color, height in ((RED, 0.1), (BLUE, 0)):
                plotter.add_mesh(pyvista.Plane(center=(0, 0, height)), color=color, opacity=0.5)
            plotter.camera_position = "xy"
            if exact:
                expected = self.assert_exact(plotter)
            for found in (sent_by_server(plotter), sent_as_picture(plotter)):
                difference = ((found - expected) ** 2).mean() ** 0.5
                (self.assertLess if exact else self.assertGreater)(difference, 5)


class TestAddLines(PlotterTest):
    def test_lines_are_exact_tubes(self):
        actor = pellucid.add_lines(
            self.plotter, crossing_lines(), radius=0.2, scalars="Height", cmap=["red", "blue"],
            clim=(0, 1), opacity=0.5, show_scalar_bar=False)
        self.plotter.camera_position = "xy"
        self.assert_exact()
        self.assertIsInstance(actor.GetMapper(), pellucid.vtkTrajectoryMapper)
        self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 1))
        self.assertIs(self.plotter.mapper, actor.GetMapper())

    def test_arrays(self):
        lines = [line.points for line in crossing_lines().split_bodies()]
        pellucid.add_lines(
            self.plotter, lines, radius=[0.1, 0.2, 0.3] * 2, scalars=numpy.arange(6), opacity=0.5,
            show_scalar_bar=False)
        self.assert_exact()

    def test_composite_data(self):
        blocks = pyvista.MultiBlock([crossing_lines(), crossing_lines().translate((0.3, 0.3, 0))])
        pellucid.add_lines(self.plotter, blocks, radius=0.2, color="tomato", opacity=0.5)
        self.assert_exact(least_layers=3)

    def test_points(self):
        cloud = numpy.random.default_rng(2).uniform(-1, 1, (200, 3))
        blocks = pyvista.MultiBlock([pyvista.PolyData(cloud[:100]), None, pyvista.PolyData(cloud[100:])])
        pictures = []
        for points in (cloud, blocks):
            plotter = self.make_plotter()
            pellucid.add_points(plotter, points, radius=0.2, color="gold", opacity=0.3)
            pictures.append(self.assert_exact(plotter, least_layers=5))
        numpy.testing.assert_array_equal(*pictures)

    def test_colors_of_directions(self):
        lines = crossing_lines()
        lines["Directions"] = numpy.array([(255, 0, 0)] * 3 + [(0, 255, 0)] * 3, numpy.uint8)
        pellucid.add_lines(self.plotter, lines, radius=0.2, scalars="Directions", rgb=True)
        self.plotter.camera_position = "xy"
        picture = self.assert_exact(least_layers=0)
        self.assertGreater(picture[80, 100, 0], picture[80, 100, 1])
        self.assertFalse(self.plotter.scalar_bars)

    def test_scalar_bar(self):
        pellucid.add_lines(self.plotter, crossing_lines(), scalars="Height", name="lines")
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["Height"])
        # Where another mesh takes the same bar, all have its range.
        other = crossing_lines()
        other["Height"] *= 3
        actor = pellucid.add_lines(self.plotter, other, scalars="Height")
        for shown in (actor, self.plotter.actors["lines"]):
            self.assertEqual(shown.GetMapper().GetScalarRange(), (0, 3))
        self.plotter.update_scalar_bar_range((0, 2))
        self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 2))
        self.plotter.remove_actor(actor)
        self.plotter.remove_actor("lines")
        self.assertFalse(self.plotter.scalar_bars)
        pellucid.add_lines(
            self.plotter, crossing_lines(), scalars="Height", scalar_bar_args={"title": "Above"})
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["Above"])

    def test_titles_of_scalar_bars_are_those_of_pyvista(self):
        lines = crossing_lines()
        lines["Vectors"] = lines.points
        active = crossing_lines()
        active.set_active_scalars("Height")
        for mesh, arguments in (
            (lines, {"scalars": "Vectors"}), (lines, {"scalars": "Vectors", "component": 1}),
            (lines, {"scalars": numpy.arange(6)}), (lines, {"scalars": [3.0, 4.0]}),
            (active, {}), (active, {"color": "red"}), (lines, {"scalars": "Vectors", "rgb": True}),
        ):
            titles, ranges = [], []
            for add in (pyvista.Plotter.add_mesh, pellucid.add_lines):
                plotter = self.make_plotter()
                actor = add(plotter, mesh.copy(), **{
                    name: numpy.array(value) if isinstance(value, list) else value
                    for name, value in arguments.items()})
                titles.append(list(plotter.scalar_bars.keys()))
                ranges.append(actor.GetMapper().GetScalarRange())
            self.assertEqual(*titles, arguments)
            self.assertEqual(*ranges, arguments)

    def test_name_takes_the_place_of_an_actor(self):
        for color in ("red", "blue"):
            pellucid.add_lines(self.plotter, crossing_lines(), color=color, name="lines")
        self.assertEqual(len(self.plotter.actors), 1)

    def test_importance(self):
        lines = crossing_lines()
        for importance in ("Height", lines["Height"]):
            plotter = self.make_plotter()
            actor = pellucid.add_lines(
                plotter, lines, radius=0.2, color="tomato", importance=importance, emphasis=1,
                smoothing_iterations=0)
            plotter.camera_position = "xy"
            self.assert_exact(plotter)
            opacities = pellucid.optimized_opacities(plotter.renderer, actor)
            self.assertLess(numpy.nanmin(opacities), 0.1)

    def test_even_importance_is_told_once(self):
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            pellucid.add_lines(self.plotter, crossing_lines(), importance="Height", importance_range=(3, 4))
        told = [warning for warning in found if "importance is 0 everywhere" in str(warning.message)]
        self.assertEqual([warning.filename for warning in told], [__file__])

    def test_arrays_take_names_that_nothing_has(self):
        lines = crossing_lines()
        lines["Importance"] = [0.0] * 3 + [1.0] * 3
        actor = pellucid.add_lines(
            self.plotter, lines, radius=0.2, scalars="Importance", importance=[1.0] * 6,
            cmap=["red", "blue"], lighting=False, show_scalar_bar=False)
        self.plotter.camera_position = "xy"
        numpy.testing.assert_array_equal(self.plotter.screenshot(return_img=True)[80, 100], (255, 0, 0))
        self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 1))

    def test_surface(self):
        shell = pyvista.Sphere()
        shell["Low"] = numpy.zeros(shell.n_points)
        blocks = pyvista.MultiBlock([shell, shell.translate((0.5, 0, 0))])
        for mesh in (shell, blocks):
            for smooth_shading in (False, True):
                plotter = self.make_plotter()
                actor = pellucid.add_surface(
                    plotter, mesh, color="tan", importance="Low", smooth_shading=smooth_shading)
                pellucid.add_lines(
                    plotter, crossing_lines(), radius=0.05, color="red", importance=numpy.ones(6))
                plotter.camera_position = "xy"
                self.assert_exact(plotter)
                opacities = pellucid.optimized_opacities(plotter.renderer, actor)
                self.assertLess(numpy.nanmin(opacities), 0.1)
        pellucid.add_surface(self.plotter, shell, scalars="Low", show_edges=True, style="wireframe")
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["Low"])

    def test_mappers_of_pyvista_are_refused(self):
        actor = self.plotter.add_mesh(pyvista.Sphere(), scalars="Normals")
        for function in (pellucid.optimize, pellucid.avoid):
            with self.assertRaisesRegex(TypeError, r"found a (vtk)?DataSetMapper; pellucid.add_surface\(\), "):
                function(actor)

    def test_wrong_scalar_bars_change_nothing(self):
        kept = pellucid.add_lines(self.plotter, crossing_lines(), scalars="Height", name="lines")
        self.plotter.camera_position = "xz"
        before = self.plotter.screenshot(return_img=True)
        for error, wrong in (
            (TypeError, {"heading": "x"}), (TypeError, {"n_labels": "x"}), (TypeError, "x"),
            (TypeError, {"mapper": None}), (ValueError, {"color": "no such color"}),
            (ValueError, {"font_family": "no such font"}),
        ):
            for show in (None, False):
                with self.assertRaisesRegex(error, "^scalar_bar_args: expected .*, found "):
                    pellucid.add_lines(
                        self.plotter, crossing_lines(), scalars="Height", scalar_bar_args=wrong,
                        show_scalar_bar=show, name="lines")
        self.assertEqual(list(self.plotter.actors.values()).count(kept), 1)
        numpy.testing.assert_array_equal(self.plotter.screenshot(return_img=True), before)
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["Height"])

    def test_too_many_scalar_bars_change_nothing(self):
        for i in range(10):
            self.plotter.add_mesh(
                crossing_lines(), scalars="Height", scalar_bar_args={"title": f"bar {i}"})
        kept = pellucid.add_lines(self.plotter, crossing_lines(), color="red", name="lines")
        before = dict(self.plotter.actors)
        for name in (None, "lines"):
            with self.assertRaisesRegex(
                    ValueError, "^show_scalar_bar: expected room for another, found 10 scalar bars; remove one"):
                pellucid.add_lines(self.plotter, crossing_lines(), scalars="Height", name=name)
        self.assertEqual(dict(self.plotter.actors), before)
        self.assertIs(self.plotter.mapper, kept.GetMapper())
        for arguments in ({"show_scalar_bar": False}, {"scalar_bar_args": {"title": "bar 3"}},
                          {"scalar_bar_args": {"position_x": 0.1, "position_y": 0.1}}):
            pellucid.add_lines(self.plotter, crossing_lines(), scalars="Height", name="lines", **arguments)

    def test_arguments_of_a_scalar_bar_show_it(self):
        for theme, show, expected in ((False, None, True), (False, False, False), (True, None, True)):
            for add in (pyvista.Plotter.add_mesh, pellucid.add_lines):
                plotter = self.make_plotter()
                plotter.theme.show_scalar_bar = theme
                add(plotter, crossing_lines(), scalars="Height", scalar_bar_args={"title": "bar"},
                    show_scalar_bar=show)
                self.assertEqual(list(plotter.scalar_bars.keys()), ["bar"] * expected)

    def test_scalar_bars_of_composite_data(self):
        blocks = pyvista.MultiBlock([crossing_lines(), crossing_lines()])
        blocks[1]["Height"] += 2
        for arguments, expected in (
            ({}, ["Height"]), ({"scalars": "Height"}, ["Height"]), ({"show_scalar_bar": True}, ["Height"]),
            ({"scalars": "Height", "scalar_bar_args": {"title": "bar"}}, ["bar"]),
            ({"show_scalar_bar": False}, []), ({"color": "red", "show_scalar_bar": True}, []),
        ):
            plotter = self.make_plotter()
            actor = pellucid.add_lines(plotter, blocks, **arguments)
            plotter.screenshot(return_img=True)
            self.assertEqual(list(plotter.scalar_bars.keys()), expected, arguments)
            for bar in plotter.scalar_bars.values():
                self.assertIs(bar.GetLookupTable(), actor.GetMapper().GetLookupTable())
                self.assertEqual(bar.GetLookupTable().GetRange(), (0, 3))
        pellucid.add_surface(self.plotter, pyvista.MultiBlock([pyvista.Sphere()]), scalars="Normals")
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["Normals"])

        blocks[1].point_data.active_scalars_name = None
        plotter = self.make_plotter()
        pellucid.add_lines(plotter, blocks)
        self.assertFalse(plotter.scalar_bars)

    def test_scalar_bars_of_composite_data_name_what_is_mapped(self):
        """What is active in all blocks, points before cells."""
        for names, cells, title in ((("a", None), ("c", "c"), "c"), (("a", "b"), ("c", "c"), "c"),
                                    (("a", "a"), ("c", "c"), "a"), (("a", "b"), ("c", None), None)):
            blocks = pyvista.MultiBlock([crossing_lines(), crossing_lines()])
            for block, points, of_cells in zip(blocks, names, cells):
                block.clear_data()
                if points:
                    block.point_data[points] = range(block.n_points)
                    block.point_data.active_scalars_name = points
                if of_cells:
                    block.cell_data[of_cells] = range(block.n_cells)
                    block.cell_data.active_scalars_name = of_cells
            for add in (pyvista.Plotter.add_mesh, pellucid.add_lines):
                plotter = self.make_plotter()
                mapper = add(plotter, blocks).GetMapper()
                self.assertEqual(list(plotter.scalar_bars.keys()), [title] if title else [])
                self.assertEqual(bool(mapper.GetScalarVisibility()), title is not None)

    def test_composite_data_refuse_what_pyvista_ignores(self):
        blocks = pyvista.MultiBlock([crossing_lines()])
        for arguments, message in (
            ({"opacity": "linear"}, "opacity: expected a number for composite data, found 'linear'"),
            ({"opacity": numpy.ones(6)}, "opacity: expected a number for composite data, found "),
            ({"component": 1}, "^component: PyVista has this for single data sets alone"),
            ({"annotations": {1.0: "one"}, "user_matrix": numpy.eye(4)}, "^annotations, user_matrix: "),
        ):
            with self.assertRaisesRegex(TypeError, message):
                pellucid.add_lines(self.plotter, blocks, **arguments)
        # What PyVista itself refuses late.
        with self.assertRaises(ValueError):
            pellucid.add_lines(self.plotter, blocks, cmap="nope")
        self.assertEqual(list(self.plotter.actors), [])

    def test_bytes_of_composite_data_have_the_colors_of_their_bar(self):
        lines = crossing_lines()
        lines["Height"] = numpy.array([40, 40, 40, 200, 200, 200], numpy.uint8)
        pictures = []
        for data in (lines, pyvista.MultiBlock([lines])):
            plotter = self.make_plotter()
            pellucid.add_lines(plotter, data, radius=0.2, scalars="Height", cmap=["red", "blue"])
            plotter.camera_position = "xy"
            pictures.append(plotter.screenshot(return_img=True))
        numpy.testing.assert_array_equal(*pictures)

    def test_scalar_bars_beside_an_opacity_for_each_point(self):
        lines = crossing_lines()
        lines["Height"] = [10.0] * 3 + [30.0] * 3
        lines["Vectors"] = numpy.outer([0, 0, 0, 1, 1, 1], (3.0, 4.0, 0.0))
        lines["fade"] = numpy.linspace(0.2, 1, 6)
        for arguments, expected in (
            ({"scalars": "Height"}, (10, 30)), ({"scalars": lines["Height"]}, (10, 30)),
            ({"scalars": "Height", "clim": (0, 50)}, (0, 50)), ({"scalars": "Vectors"}, (0, 5)),
            ({"scalars": "Vectors", "component": 1}, (0, 4)),
        ):
            for opacity in ("fade", lines["fade"]):
                for show in (None, True, False):
                    plotter = self.make_plotter()
                    pellucid.add_lines(
                        plotter, lines, opacity=opacity, show_scalar_bar=show, scalar_bar_args={"title": "bar"},
                        **arguments)
                    plotter.screenshot(return_img=True)
                    found = [bar.GetLookupTable().GetRange() for bar in plotter.scalar_bars.values()]
                    self.assertEqual(found, [] if show is False else [expected], arguments)
        pellucid.add_lines(self.plotter, lines, color="red", opacity=lines["fade"], show_scalar_bar=True)
        self.assertFalse(self.plotter.scalar_bars)

    def test_bars_beside_opacities_have_the_colors_of_the_points(self):
        lines = crossing_lines()
        lines["Height"] = [1.0] * 3 + [10.0] * 3
        actor = pellucid.add_lines(
            self.plotter, lines, radius=0.2, scalars="Height", cmap=["red", "blue"], flip_scalars=True,
            log_scale=True, opacity=numpy.ones(6), lighting=False, clim=(1, 10), show_scalar_bar=True)
        self.plotter.camera_position = "xy"
        found = self.plotter.screenshot(return_img=True)[80, 100] / 255
        table = actor.GetMapper().GetLookupTable()
        color = [0.0] * 3
        table.GetColor(1.0, color)
        numpy.testing.assert_allclose(found, color, atol=0.01)
        self.assertFalse(table.UsingLogScale())

    def test_color_maps(self):
        colors = [(1, 0, 0), (0, 0, 1)]
        pictures = []
        for cmap in (["red", "blue"], colors, tuple(colors), numpy.array(colors), numpy.ones((2, 4)) * 0.5):
            plotter = self.make_plotter()
            pellucid.add_lines(
                plotter, crossing_lines(), radius=0.2, scalars="Height", cmap=cmap, clim=(0, 1),
                show_scalar_bar=False)
            pictures.append(plotter.screenshot(return_img=True))
        for picture in pictures[1:-1]:
            numpy.testing.assert_array_equal(picture, pictures[0])
        self.assertTrue((pictures[-1] != pictures[0]).any())
        many = numpy.linspace((0, 0, 0), (1, 1, 1), 1000)
        for data in (crossing_lines(), pyvista.MultiBlock([crossing_lines()])):
            actor = pellucid.add_lines(self.plotter, data, scalars="Height", cmap=many, show_scalar_bar=False)
            self.assertEqual(actor.GetMapper().GetLookupTable().GetNumberOfTableValues(), 1000)
        for error, message, wrong in (
            (ValueError, "cmap: expected colors in .0, 1. as an array of shape", [(0, 0, 255)]),
            (TypeError, "cmap: expected the name of a color map, colors or a pyvista.LookupTable for a "
             "PyVista plotter, found a vtkLookupTable", vtkLookupTable()),
        ):
            with self.assertRaisesRegex(error, message):
                pellucid.add_lines(self.plotter, crossing_lines(), scalars="Height", cmap=wrong)

    def test_wrong_arguments_change_nothing(self):
        for error, message, wrong in (
            (TypeError, "unknown parameter 'size'; there are radius, .*, user_matrix$", {"size": 2}),
            (TypeError, "unknown parameter 'line_width'; use radius", {"line_width": 2}),
            (ValueError, "radius: expected a number of at least 0", {"radius": -1}),
            (ValueError, "scalars: there is no array 'x' of points or cells; there are Height",
             {"scalars": "x"}),
            (TypeError, "name: expected a string, found 5", {"name": 5}),
            (TypeError, "label: expected a string, found 5", {"label": 5}),
            (ValueError, "clim: expected two finite numbers", {"clim": (1,), "scalars": "Height"}),
            (TypeError, "specular: expected a number from 0 to 1, found 'a'", {"specular": "a"}),
            (ValueError, "preset: only with importance", {"preset": "focus"}),
            (ValueError, "importance: there is no point array 'x'", {"importance": "x"}),
            (ValueError, "color", {"color": "no such color"}),
            (ValueError, "", {"cmap": "no such map", "scalars": "Height"}),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(error, message):
                pellucid.add_lines(self.plotter, crossing_lines(), **wrong)
        self.assertFalse(self.plotter.actors)
        self.assertIsNone(pellucid.vtkTransparencyInstaller.GetPass(self.plotter.renderer))


if __name__ == "__main__":
    unittest.main()
