// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReferenceRenderer
 * @brief   Renders a scene on the CPU in double precision, as a reference for exact transparency.
 *
 * Takes camera, lights, props and background of a vtkRenderer and computes, without OpenGL, the
 * picture that VTK's rasterisation with an exactly sorted transparency shows: the view ray through
 * the centre of every pixel is intersected with every surface in closed form, the fragments are
 * sorted, and blended front to back over the nearest opaque surface or the background. There is no
 * limit on the number of layers. Lighting is that of VTK's own shaders (vtkOpenGLPolyDataMapper).
 *
 * Drawn are vtkActor, and the actors of assemblies, with
 * - tubes, balls, polygons and strips of vtkTrajectoryMapper;
 * - triangles, polygons and strips of any other vtkPolyDataMapper without impostors, and of
 *   composite poly data mappers, and of the surface that vtkDataSetMapper draws;
 * - the polygons of glyphs of vtkGlyph3DMapper.
 * Whatever else the renderer holds (volumes, one-pixel wide lines and points, wireframes, textures,
 * 2D props, ...) is left out; a warning names it, and so does GetOmissions().
 *
 * Opacities follow from importance where an actor has a vtkImportanceDrivenOpacity; each frame
 * shows its own at once (vtkExactTransparencyPass::SetFadeTime() at 0).
 *
 * Order: fragments are sorted by window depth; at equal depths the less opaque one is in front,
 * then the one with less red, green and blue, so that no order of props or cells shows. This also
 * decides between opaque surfaces at the same depth, where VTK shows the one drawn last. A
 * translucent fragment at the depth of an opaque surface is in front of it. Of the polygons that
 * share an edge which runs exactly through the centre of a pixel, the one to the right of it owns
 * the pixel, or the upper one if the edge is horizontal, so that one crossing of a mesh gives one
 * fragment.
 *
 * The camera is used as it is, including its clipping range. Lights that follow the camera are
 * moved as vtkRenderer::Render() would move them, and a renderer without lights gets its headlight,
 * if AutomaticLightCreation allows it. The same scene gives the same bits, with any number of
 * threads and any order of its props.
 *
 * The cost is proportional to the fragments, and to the pixels of the bounding rectangles of the
 * primitives: seconds for a thousand lines of a hundred points at 800x600. Optimised opacities cost
 * the same once more, and so do smoothed attributes of vtkOcclusionAvoidance.
 *
 * @par Reference
 * None: it computes what the other classes, which name theirs, define.
 *
 * @sa vtkExactTransparencyPass vtkImportanceDrivenOpacity vtkTrajectoryMapper
 */

#ifndef vtkReferenceRenderer_h
#define vtkReferenceRenderer_h

#include "vtkObject.h"
#include "vtkPellucidRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the scene's renderer

#include <memory> // for the internals
#include <string> // for the omissions

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkImageData;
class vtkRenderer;
class vtkTable;

class VTKPELLUCIDRENDERING_EXPORT vtkReferenceRenderer : public vtkObject
{
public:
  static vtkReferenceRenderer* New();
  vtkTypeMacro(vtkReferenceRenderer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The scene. Its viewport and its render window, which it need not have, are ignored: the scene
   * fills the whole image. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** Width and height of the image in pixels, at least 1; default 300 x 300. */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /** Whether the background is transparent, as in a window with alpha bit planes: its alpha is then
   * 0 instead of 1, its colour stays. Default: off. */
  vtkSetMacro(TransparentBackground, bool);
  vtkGetMacro(TransparentBackground, bool);
  vtkBooleanMacro(TransparentBackground, bool);
  ///@}

  ///@{
  /** What is shown, and the layer, at least 1, that goes with it: vtkExactTransparencyPass::Views,
   * from VIEW_PICTURE, the default, to VIEW_LAYER. Default of the layer is 1. */
  vtkSetClampMacro(View, int, 0, 6);
  vtkGetMacro(View, int);
  vtkSetClampMacro(Layer, int, 1, VTK_INT_MAX);
  vtkGetMacro(Layer, int);
  ///@}

  ///@{
  /**
   * Resolution at which opacities are optimised, 1 to 4:
   * vtkExactTransparencyPass::SetGatherScale(). A pixel of the small picture, the centre of which
   * need not be one of the full picture, has the opaque depth of the full picture's pixel in its
   * middle, or of the upper or right one of two. Default: 1.
   */
  vtkSetClampMacro(GatherScale, int, 1, 4);
  vtkGetMacro(GatherScale, int);
  ///@}

  ///@{
  /** Whether Update() computes GetOrderChanges(). Time: all pairs of fragments of a pixel that are
   * so close; memory: 48 bytes for each pixel. Default: off. */
  vtkSetMacro(ComputeOrderChanges, bool);
  vtkGetMacro(ComputeOrderChanges, bool);
  vtkBooleanMacro(ComputeOrderChanges, bool);
  ///@}

  /** Render the scene as it is now. Everything below belongs to the last call; without a renderer,
   * or with a size that is not positive, it reports an error and leaves no image. */
  void Update();

  /** The image, bottom row first: RGBA as VTK_DOUBLE in [0,1]. With fragments of total alpha A and
   * blended colour C, the pixel is C + (1-A) background, and its alpha A + (1-A) background alpha.
   */
  vtkImageData* GetImage();

  /** The number of translucent fragments in each pixel that are not behind an opaque surface,
   * whatever the view shows of them; one VTK_INT for each pixel, bottom row first. */
  vtkImageData* GetFragmentCounts();

  /**
   * With ComputeOrderChanges, how much each pixel depends on an order of translucent fragments that
   * single precision does not resolve: bounds of how VIEW_PICTURE, whatever the view shows of it,
   * changes where fragments whose window depths differ, but by less than 4.8e-7, eight of its
   * steps, change places with the opacities that they have. 6 VTK_DOUBLE for each pixel, bottom row
   * first: by how much red, green and blue may fall, in [-1,0], and by how much they may rise, in
   * [0,1]; 0 without such fragments. Without ComputeOrderChanges, an empty image.
   */
  vtkImageData* GetOrderChanges();

  /** The sum of the fragment counts. */
  vtkIdType GetNumberOfFragments();

  /** The largest of the fragment counts. */
  vtkIdType GetLongestList();

  /** The translucent fragments of one pixel, front to back: columns Depth (window depth in [0,1]),
   * Red, Green, Blue, Alpha (straight, in [0,1], before importance changes it). Empty where nothing
   * is, and outside the image. */
  void GetPixelFragments(int x, int y, vtkTable* fragments);

  /**
   * The segments whose opacities are optimised (vtkOpacityOptimization), of the fragments of each
   * pixel, front to back: one cell for each pixel, in no order of theirs, as vtkGlobalOpacitySolver
   * takes them. Segments are counted from 0 through all actors that take part, in the order in
   * which the renderer holds these; those of one actor alone are as its data numbers them.
   */
  void GetPixelSegments(vtkCellArray* lists);

  /** What the scene holds that was not drawn, each kind with its number, or an empty string. */
  std::string GetOmissions();

protected:
  vtkReferenceRenderer();
  ~vtkReferenceRenderer() override;

private:
  vtkReferenceRenderer(const vtkReferenceRenderer&) = delete;
  void operator=(const vtkReferenceRenderer&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  vtkSmartPointer<vtkRenderer> Renderer;
  int Size[2] = { 300, 300 };
  bool TransparentBackground = false;
  int View = 0;
  int Layer = 1;
  int GatherScale = 1;
  bool ComputeOrderChanges = false;
};

VTK_ABI_NAMESPACE_END
#endif
