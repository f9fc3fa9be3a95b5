// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryMapper
 * @brief   Draw lines as tubes and vertices as balls, without making their geometry.
 *
 * Input is vtkPolyData or composite data of it. Each segment of a line is a rounded cone: all balls
 * whose centre and radius lie linearly between those of its ends. It is drawn as one view-aligned
 * quad on which each pixel intersects the view ray with the cone (M. Gross and S. Gumhold, Advanced
 * Rendering of Line Data with Ambient Occlusion and Transparency, 2021, section 5). At the joints
 * of a line the segments are cut by the bisector planes, normal to the sum of the two unit
 * directions, so that a ray that passes once through a tube makes one fragment. (The planes of
 * eq. 11 there, normal to the chord between the neighbouring points, leave gaps in the outline
 * between segments of unequal length.) Line ends keep their round caps. Where the near plane or a
 * clipping plane opens a tube its inner wall shows, at most 256 segments away from where the view
 * ray starts. Vertices, and lines of one point, are balls; polygons and strips look as
 * vtkPolyDataMapper draws them.
 *
 * Colours, materials, lights, render passes, clipping planes, picking and hardware selection are
 * those of vtkPolyDataMapper; a selection by points returns the nearer end of the segment hit.
 * vtkHardwareSelector and vtkPropPicker see the tubes; vtkCellPicker, which works on the data, sees
 * the lines, so give it a tolerance. Representations other than surface draw the same tubes.
 *
 * Colours, or the scalars where InterpolateScalarsBeforeMapping is on, change linearly from ball to
 * ball; where one ball of a segment contains the other, its colour is that of the larger.
 *
 * Radii are in world units whatever the scale of the actor, so that a stretched axis does not
 * flatten tubes. Bounds include the radius for an actor that is not scaled.
 *
 * Consecutive coincident points of a line count once. Points with a coordinate or a radius that is
 * not finite are left out and split their line, with one warning; negative radii count as 0, and a
 * segment with radius 0 at both ends is not drawn. In composite data, leaves that lack the array to
 * colour by take the colour of the actor's property; where InterpolateScalarsBeforeMapping is on,
 * they and leaves with direct colours take that of NaN.
 *
 * In composite data, blocks can be invisible, not pickable, of an opacity of their own in place of
 * the property's, and of a colour of their own in place of all others, also those of scalars; see
 * SetCompositeDataDisplayAttributes(). What is not drawn does not count for the bounds, but for the
 * automatic radius, so that this stays as it is. With a visible block below opacity 1 the actor is
 * translucent.
 *
 * Cost: 16 bytes of graphics memory for a point, 4 for its colour and 4 for its factor of opacity.
 * Work on the CPU happens only when the data, radii, colours or opacities change, and not when it
 * is how blocks are displayed.
 *
 * @par Reference
 * M. Gross, S. Gumhold: Advanced Rendering of Line Data with Ambient Occlusion and Transparency.
 * IEEE Transactions on Visualization and Computer Graphics 27(2), 2021, section 5.
 *
 * @sa vtkExactTransparencyPass vtkTubeFilter vtkPolyDataMapper
 */

#ifndef vtkTrajectoryMapper_h
#define vtkTrajectoryMapper_h

#include "vtkPellucidRenderingModule.h" // for the export macro
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the attributes of blocks

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN

class vtkCompositeDataDisplayAttributes;

class VTKPELLUCIDRENDERING_EXPORT vtkTrajectoryMapper : public vtkPolyDataMapper
{
public:
  static vtkTrajectoryMapper* New();
  vtkTypeMacro(vtkTrajectoryMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Radius of tubes and balls in world units, at least 0. Default 0: it follows from the diagonal
   * of the bounds, the number of lines and their total length, between 1/2500 of the diagonal for
   * very many lines and 1/200 for few. These are measured before the actor's scale: give a scaled
   * actor a radius of its own.
   */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Name of a point array with one component that holds radii in world units. Data that lacks it
   * uses the constant radius. Default: none.
   */
  vtkSetStringMacro(RadiusArray);
  vtkGetStringMacro(RadiusArray);
  ///@}

  ///@{
  /**
   * Name of a point array with one component that holds factors in [0,1] on the opacity of colour
   * map and property: 1 keeps it, 0 draws nothing. They are linear from ball to ball, as colours
   * are, and on polygons and strips. Values outside are clamped; NaN, and data that lacks the
   * array, count as 1. An array of several components is not used, with one warning. With a factor
   * below 1 the actor is translucent. Importance as factors fades the context and keeps relevant
   * lines opaque (M. Bandle, Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D,
   * 2016, section 3.3.1). Default: none, at no cost.
   */
  vtkSetStringMacro(OpacityArray);
  vtkGetStringMacro(OpacityArray);
  ///@}

  ///@{
  /**
   * How blocks of composite data are displayed: visibility, pickability, opacity and colour; a
   * block without takes that of its parent. Opacities replace that of the property, and those of
   * scalars and of the opacity array multiply them. The rest of the attributes is not used.
   * Default: none.
   */
  void SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes* attributes);
  vtkCompositeDataDisplayAttributes* GetCompositeDataDisplayAttributes();
  ///@}

  /** The constant radius in use: Radius, or the automatic one. Updates the input. */
  double GetEffectiveRadius();

  /** Includes that of the attributes of blocks. */
  vtkMTimeType GetMTime() override;

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool HasTranslucentPolygonalGeometry() override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  /** For vtkHardwareSelector: ids that pixels hold become those of the input. */
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop) override;
  bool GetSupportsSelection() override { return true; }

protected:
  vtkTrajectoryMapper();
  ~vtkTrajectoryMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeBounds() override;

private:
  vtkTrajectoryMapper(const vtkTrajectoryMapper&) = delete;
  void operator=(const vtkTrajectoryMapper&) = delete;

  double Radius = 0.0;
  char* RadiusArray = nullptr;
  char* OpacityArray = nullptr;
  vtkSmartPointer<vtkCompositeDataDisplayAttributes> BlockAttributes;

  class Parts;
  std::unique_ptr<Parts> Drawing;
};

VTK_ABI_NAMESPACE_END
#endif
