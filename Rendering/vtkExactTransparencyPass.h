// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExactTransparencyPass
 * @brief   Draws a renderer's props with exact order-independent transparency.
 *
 * Every translucent fragment of every pixel is kept, sorted by depth and composited front to back.
 * The pass takes part in the shaders of all VTK mappers, so surfaces, glyphs, points and
 * trajectories of any number of actors are blended together in the right order, whatever order they
 * are drawn in. It is a leaf of a chain of render passes: it needs a camera pass before it, draws
 * lights, opaque geometry, translucent geometry, volumes and overlay, and delegates to nobody.
 * vtkTransparencyInstaller puts it into a renderer.
 *
 * Stages of a frame with translucent geometry; each is timed under its name in the statistics:
 * 1. `opaque`  - VTK's own opaque pass, SSAO and hidden line removal included
 * 2. `copy`    - colour and depth of the opaque scene into textures, sample by sample
 * 3. `gather`  - the geometry is drawn once; each fragment in front of the opaque scene is appended
 *                to its pixel's linked list
 * 4. `sort`    - each list is sorted by depth in place, as far as it can be seen where no opacities
 *                are yet to be found
 * 5. `solve`   - where opacities are optimised (vtkOpacityOptimization): the optimal opacity of
 *                each fragment, and the least one of each segment
 * 6. `smooth`  - the opacities of segments are smoothed along lines and surfaces
 * 7. `fade`    - what is shown comes nearer to that (SetFadeTime())
 * 8. `attributes` - where they are smoothed: what occlusion avoidance looks up in other pixels
 * 9. `avoid`   - where occlusion is avoided (vtkOcclusionAvoidance): a factor for each fragment
 * 10. `resolve` - each list is composited over the opaque scene, with the opacities found
 * 11. `blend`  - props whose mapper takes no part in render passes, over the result; counted in the
 *                statistics, with one warning
 * A frame without translucent geometry runs VTK's own path and nothing else, and allocates nothing;
 * what an earlier frame has allocated is kept for the next.
 *
 * What a frame shares with the one before is not found again. Where camera, lights, props, their
 * data and the size are the same, there is no `gather` and no `sort`; with the same parameters of
 * opacities no `solve`, `smooth` and `avoid` either. This needs plain actors with poly data
 * mappers, without textures and observers of their shaders: other props are drawn in every frame.
 *
 * Exactness. Lists of any length are composited completely. When the fragments do not fit into the
 * buffers these grow; when they would exceed the memory limit the image is worked through in
 * rectangles, with the same bits as result; optimised opacities need all rectangles before the
 * first is composited, so these gather twice. Fragments of equal depth are ordered by opacity, then
 * colour, so a picture depends neither on the order of props and cells nor on the number of
 * threads. (Where opacities are optimised, segments that are alike in depth, opacity, colour and
 * importance, as a perspective of 1e9 makes many, are told apart by their number in the data.) A
 * stored fragment has 13 bits for each colour component, 25 bits of opacity (8 of them
 * exponent) and a 32-bit float depth. Compositing is in single precision and stops where the rest
 * of a list weighs less than 1/8192, a thirtieth of an 8-bit step.
 *
 * Choices. Each was measured beside others on Mesa's software renderer; Testing/Benchmark/README.md
 * has the figures of stores, sorts and formats, by which one that is never the best has been left
 * out. None was measured on a GPU.
 * - Store: linked lists. Arrays of the right length need the geometry twice, which took 1.4 to 2.0
 * times as long in the median, to save 4 bytes of 16 for each fragment.
 * - Sort, by the length of each list: up to 16 fragments by insertion, more by merging runs of 16,
 * and above 2048 on the CPU, since software renderers end shaders after some 65,000 loop
 * iterations.
 * - Node format: 64 bits for colour and opacity. With 8 bits of opacity the RMSE rises by up to
 * 0.18 of 255 for the same time; 128 bits take half as much memory again and show nothing more.
 * - Geometry: trajectories are ray-cast, a point sprite for each segment up to 12 pixels wide and
 * each ball up to 32, else a quad: 0.8 of the time of quads alone.
 *
 * A picture that is larger than the window (vtkWindowToImageFilter::SetScale(), ParaView's large
 * screenshots) comes in parts: they all take the optimised opacities of the last frame that showed
 * the whole view. Without such a frame they find their own, with a warning.
 *
 * Multisampled targets keep the antialiasing of opaque edges: fragments are gathered once for each
 * pixel and composited over each sample with that sample's depth.
 *
 * VTK's own path is kept for a hardware selection, for shadows (vtkRenderer::SetUseShadows), for
 * volumes that are to be depth peeled with the geometry, and, with one warning, where OpenGL is
 * older than 4.3. Volumes are blended over the result, as VTK does by default.
 *
 * @par Reference
 * M. Bandle: Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D (2016), chapter
 * 2, for the lists and the compositing (equations 2.3 and 2.4), whose lists drop what does not fit,
 * and sections 3.2 and 3.3 for occlusion avoidance.
 * T. Guenther, H. Theisel, M. Gross: Decoupled Opacity Optimization for Points, Lines and Surfaces
 * (2017), for the optimisation; there it takes a second geometry pass.
 *
 * @sa vtkTransparencyInstaller vtkTransparencyStatistics vtkTrajectoryMapper
 */

#ifndef vtkExactTransparencyPass_h
#define vtkExactTransparencyPass_h

#include "vtkNew.h" // for the statistics
#include "vtkOpenGLRenderPass.h"
#include "vtkPellucidRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for GetOptimizedOpacities
#include "vtkTransparencyStatistics.h"  // for GetStatistics

#include <memory> // for std::unique_ptr
#include <string> // for the reason

VTK_ABI_NAMESPACE_BEGIN

class vtkFloatArray;
class vtkRenderWindow;
struct vtkPictureView;
struct vtkPixelRectangle;

class VTKPELLUCIDRENDERING_EXPORT vtkExactTransparencyPass : public vtkOpenGLRenderPass
{
public:
  static vtkExactTransparencyPass* New();
  vtkTypeMacro(vtkExactTransparencyPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Largest size of the fragment lists in MiB, at least 1; less counts as 1. Default 1024, room for
   * 49 million fragments at a time, half of that where opacities follow from importance, or for 16
   * million where OpenGL limits a buffer to 128 MiB as Mesa's software renderer does. A scene that
   * needs more is drawn in several rectangles, which costs one more traversal of the geometry for
   * each. Only the list of a single pixel may exceed the limit; a warning tells. The copies of the
   * opaque scene come on top: 8 bytes for each sample, 20 for each in a floating-point target.
   */
  vtkSetClampMacro(MemoryLimit, int, 1, VTK_INT_MAX);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  /** What is shown of the translucent geometry. */
  enum Views
  {
    VIEW_PICTURE = 0,
    VIEW_OPACITY = 1,
    VIEW_IMPORTANCE = 2,
    VIEW_SEGMENTS = 3,
    VIEW_LENGTH = 4,
    VIEW_FIRST_LAYERS = 5,
    VIEW_LAYER = 6
  };

  ///@{
  /**
   * To look into a picture (M. Pastyrik, Visualization of inner structure of complex 3D objects,
   * 2015, has the last three). Default is VIEW_PICTURE, the picture itself. Four views show the
   * nearest fragment of each pixel, opaque and unlit, in the colour of a number from 0 (black)
   * through red and yellow to 1 (white):
   * - VIEW_OPACITY: the factor on its opacity that follows from importance, 1 where nothing does;
   * - VIEW_IMPORTANCE: its importance, 0 for actors without vtkImportanceDrivenOpacity;
   * - VIEW_SEGMENTS: no number, but a colour for each segment whose opacity is optimised, black
   *   for everything else;
   * - VIEW_LENGTH: the fragments of the pixel, relative to the fullest one.
   * Two composite, as in the picture, some of the fragments of each pixel:
   * - VIEW_FIRST_LAYERS: the first ones, as many as SetLayer() says;
   * - VIEW_LAYER: the one of that number alone.
   */
  vtkSetClampMacro(View, int, VIEW_PICTURE, VIEW_LAYER);
  vtkGetMacro(View, int);
  ///@}

  ///@{
  /** Layers of the last two views, counted from the nearest; at least 1, the default. */
  vtkSetClampMacro(Layer, int, 1, VTK_INT_MAX);
  vtkGetMacro(Layer, int);
  ///@}

  ///@{
  /**
   * Whether what all translucent layers come to is rounded to 8 bits before the opaque scene comes
   * behind it. Off (the default), only the picture is rounded. On, it has the same bits as where
   * the two are put together later, such as by the client of a server that draws, at the price of
   * an error of up to 1 of 255 instead of 1/2.
   */
  vtkSetMacro(RoundTranslucentLayers, bool);
  vtkGetMacro(RoundTranslucentLayers, bool);
  vtkBooleanMacro(RoundTranslucentLayers, bool);
  ///@}

  ///@{
  /**
   * Optimised opacities (vtkOpacityOptimization) are found in a picture of 1/GatherScale of the
   * width and height, 1 (the default) to 4. Above 1 the geometry is drawn twice, small and
   * large; segments that cover less than such a pixel may be missed, and then show with the opacity
   * of their neighbours on the line or surface, or fully where these are missed too. The error of
   * the picture (RMSE) for lines 1 to 2 pixels wide is 6 of 255 with 2, and 10 with 4.
   */
  vtkSetClampMacro(GatherScale, int, 1, 4);
  vtkGetMacro(GatherScale, int);
  ///@}

  ///@{
  /**
   * Seconds in which optimised opacities come nearer to those of a new view, or new parameters, by
   * a factor of e, whatever the frame rate; at least 0. At 0, the default, each frame shows its own
   * opacities at once, as batch jobs and screenshots want it. Otherwise
   * vtkTransparencyStatistics::GetFading() tells whether it takes more frames to get there, which
   * is after 8 times this at most; the opacities are then the very same. Other data, and actors
   * that come or go, have theirs at once.
   */
  vtkSetClampMacro(FadeTime, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FadeTime, double);
  ///@}

  ///@{
  /**
   * Time of the next frame in seconds, for the fade: that of the film which the frame is for, or,
   * negative as by default, that of the clock.
   */
  vtkSetMacro(FrameTime, double);
  vtkGetMacro(FrameTime, double);
  ///@}

  /**
   * The opacities of the segments of an actor (see vtkOpacityOptimization) that the last frame was
   * drawn with, smoothed: one component in [0,1], or -1 for a segment that no fragment has shown.
   * Null when the actor took no part, or nothing was to be optimised. Waits for the frame.
   */
  vtkSmartPointer<vtkFloatArray> GetOptimizedOpacities(vtkProp* actor);

  /** What the last frame cost. Never null; the same object for the life of the pass. */
  vtkTransparencyStatistics* GetStatistics();

  /**
   * Why the current context of this window cannot run the pass, what was found and what is needed;
   * empty when it can. The context must be current.
   */
  static std::string GetReasonUnsupported(vtkRenderWindow* window);

  /** Draw the props of the state's renderer. The camera must have been set up. */
  void Render(const vtkRenderState* state) override;

  ///@{
  /** Free the graphics memory of that window, or of the window that was drawn last. */
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void FreeGraphicsMemory();
  ///@}

  ///@{
  /** Take part in the shader of a mapper; called by the mapper while it is gathered. */
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkExactTransparencyPass();
  ~vtkExactTransparencyPass() override;

private:
  vtkExactTransparencyPass(const vtkExactTransparencyPass&) = delete;
  void operator=(const vtkExactTransparencyPass&) = delete;

  struct Internals;

  bool KeepsStockPath(const vtkRenderState* state);
  void RenderGeometry(const vtkRenderState* state);
  void RenderTranslucentGeometry(const vtkRenderState* state);
  void PrepareImportance(const vtkRenderState* state);
  void BeginSweeps(const vtkRenderState* state, const vtkPixelRectangle& picture);
  void OptimizeOpacities();
  void FadeOpacities();
  void WarnOfTiles();
  void PrepareAvoidance(vtkRenderer* renderer, const vtkPixelRectangle& picture);
  void FindAttributes();
  void Avoid();
  void CollapseLongLists(const vtkPictureView& view);
  void Solve();
  void SmoothOpacities();
  void Resolve(vtkIdType longestList);
  void BlendOtherProps(const vtkRenderState* state);

  int MemoryLimit = 1024;
  int View = VIEW_PICTURE;
  int Layer = 1;
  bool RoundTranslucentLayers = false;
  int GatherScale = 1;
  double FadeTime = 0.0;
  double FrameTime = -1.0;
  vtkNew<vtkTransparencyStatistics> Statistics;

  std::unique_ptr<Internals> Internal;
};

VTK_ABI_NAMESPACE_END
#endif
