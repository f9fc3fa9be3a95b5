# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties in snake case, whatever tools have made the wrappers."""

import gc
import re
import unittest

from vtkmodules.vtkCommonCore import vtkObjectBase
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

import pellucid


class TestProperties(unittest.TestCase):
    def test_get_and_set(self):
        mapper = pellucid.vtkTrajectoryMapper()
        mapper.radius = 2.0
        mapper.opacity_array = "fade"
        self.assertEqual((mapper.radius, mapper.GetRadius()), (2.0, 2.0))
        self.assertEqual((mapper.opacity_array, mapper.GetOpacityArray()), ("fade", "fade"))
        mapper.opacity_array = None
        self.assertIsNone(mapper.GetOpacityArray())

    def test_several_values(self):
        optimization = pellucid.vtkOpacityOptimization()
        for value in ((1, 3), [2, 4]):
            optimization.importance_range = value
            self.assertEqual(optimization.GetImportanceRange(), tuple(value))
        reference = pellucid.vtkReferenceRenderer()
        reference.size = 12, 8
        self.assertEqual(reference.size, (12, 8))

    def test_objects(self):
        renderer = vtkRenderer()
        reference = pellucid.vtkReferenceRenderer(renderer=renderer)
        self.assertIs(reference.renderer, renderer)
        reference.renderer = None
        self.assertIsNone(reference.GetRenderer())

    def test_keywords_of_the_constructor(self):
        mapper = pellucid.vtkTrajectoryMapper(radius=2.0, scalar_range=(0, 3))
        self.assertEqual((mapper.GetRadius(), mapper.GetScalarRange()), (2.0, (0.0, 3.0)))
        with self.assertRaisesRegex(
                TypeError, "Unexpected keyword argument 'colour' for '.*TrajectoryMapper' constructor"):
            pellucid.vtkTrajectoryMapper(colour="red")

    def test_wrong_values(self):
        mapper = pellucid.vtkTrajectoryMapper()
        with self.assertRaises(TypeError):
            mapper.radius = "large"
        with self.assertRaises(AttributeError):
            mapper.effective_radius = 1
        self.assertEqual(mapper.radius, 0)

    def test_objects_made_by_vtk(self):
        transparency = pellucid.install(vtkRenderer())
        transparency.memory_limit = 64
        self.assertEqual(transparency.GetMemoryLimit(), 64)
        transparency.memory_limit = -1
        self.assertEqual(transparency.memory_limit, 1)
        self.assertIn("at least 1; less counts as 1", " ".join(pellucid.install.__doc__.split()))
        self.assertIsInstance(transparency, pellucid.vtkExactTransparencyPass)
        self.assertEqual(transparency.statistics.longest_list, 0)

        actor = vtkActor()
        actor.SetMapper(pellucid.vtkTrajectoryMapper(radius=3))
        gc.collect()
        self.assertEqual(actor.GetMapper().radius, 3)
        self.assertIsInstance(actor.GetMapper(), pellucid.vtkTrajectoryMapper)
        self.assertIsInstance(actor.GetMapper().NewInstance(), pellucid.vtkTrajectoryMapper)

    def test_subclass_in_python(self):
        class Mapper(pellucid.vtkTrajectoryMapper):
            pass

        self.assertEqual(Mapper(radius=4).radius, 4)

    def test_all_classes_have_them(self):
        classes = [value for value in vars(pellucid).values()
                   if isinstance(value, type) and issubclass(value, vtkObjectBase)]
        self.assertGreater(len(classes), 15)
        for wrapped in classes:
            for name in ("Radius", "MemoryLimit", "SegmentLength", "OcclusionWeight", "FileName"):
                if hasattr(wrapped, f"Set{name}"):
                    property_name = re.sub("(?<=[a-z])(?=[A-Z])", "_", name).lower()
                    self.assertTrue(hasattr(wrapped, property_name), f"{wrapped}.{property_name}")


if __name__ == "__main__":
    unittest.main()
