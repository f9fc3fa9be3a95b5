// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkEnteredTubes
 * @brief   Which tubes hold a part of the near plane, and how far along them one can see.
 *
 * A view ray that starts within a tube shows the wall where it leaves the tube, which may be that
 * of a segment several joints away. Such a segment cannot know by itself that the ray did not come
 * from outside. So the segments that hold a part of the near plane are found here, and with each
 * one the stretch of its line that can be seen from there through the joints.
 *
 * Cost: one test for each segment, in parallel; call it only while the near plane is within the
 * bounds of the trajectories.
 */

#ifndef vtkEnteredTubes_h
#define vtkEnteredTubes_h

#include "vtkTrajectoryNodes.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkMatrix4x4;

class vtkEnteredTubes
{
public:
  /** Tubes that a shader looks at; more are not found, the deepest entered are. */
  static constexpr int Maximum = 32;

  struct Tube
  {
    std::array<std::array<float, 4>, 2>
      Balls;         ///< the segment's ends in view coordinates, and radii
    vtkIdType First; ///< nodes at which the first ...
    vtkIdType Last;  ///< ... and last segment of the stretch begin
  };

  /** The middle of the near plane in view coordinates, and the largest distance of a corner. */
  struct NearPlane
  {
    std::array<double, 3> Center;
    double Radius;
    bool Parallel; ///< view rays are parallel to z
  };

  /** `nodeToView` is transposed, as VTK's key matrices are. */
  static std::vector<Tube> Find(
    const vtkTrajectoryNodes& nodes, vtkMatrix4x4* nodeToView, const NearPlane& nearPlane);
};

VTK_ABI_NAMESPACE_END
#endif
