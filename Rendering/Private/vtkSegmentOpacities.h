// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The opacities of the segments of a vtkOptimizedScene in graphics memory, from the least opacity
 * of their fragments, which vtkFragmentStages::Solve() finds, to those that the resolve looks up.
 *
 * | buffer         | element | content                                                         |
 * | -------------- | ------- | --------------------------------------------------------------- |
 * | Segments       | uvec2   | least opacity of its fragments as bits, actor                   |
 * | Actors         | 13 words | vtkOptimizedScene::Parameters                                   |
 * | FirstNeighbors | uint    | first entry of each segment in Neighbors, and the end           |
 * | Neighbors      | uint    | segments                                                        |
 * | Corners        | 8 words | vtkOptimizedScene::Corner                                       |
 * | Source, Target | float   | opacity of each segment, then of each corner; negative: unknown |
 * | Faded          | float   | the same, on its way to Source; where opacities fade            |
 * | Pending        | uint    | 1 where any of these is not there yet                           |
 *
 * A current OpenGL 4.3 context is needed by every function but the static ones.
 */

#ifndef vtkSegmentOpacities_h
#define vtkSegmentOpacities_h

#include "vtkEmptyFramebuffer.h"
#include "vtkStageDraw.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkOpenGLRenderWindow;
class vtkOptimizedScene;
class vtkShaderProgram;

class vtkSegmentOpacities
{
public:
  /** An opacity that a segment's fragment has. */
  struct SegmentOpacity
  {
    std::uint32_t Segment;
    float Opacity;
  };

  /** In the segment of a fragment: its opacity follows from occlusion avoidance. */
  static constexpr std::uint32_t AvoidingBit = 0x80000000u;

  vtkSegmentOpacities() = default;
  ~vtkSegmentOpacities() = default;
  vtkSegmentOpacities(const vtkSegmentOpacities&) = delete;
  void operator=(const vtkSegmentOpacities&) = delete;

  /** `#define`s for the shaders, which go with those of vtkFragmentLists. */
  static std::string GetShaderDefinitions();

  ///@{
  /** Take the tables of a scene, or only the settings of its actors. Returns false when OpenGL is
   * out of memory. */
  bool Upload(const vtkOptimizedScene& scene);
  bool UploadSettings(const vtkOptimizedScene& scene);
  ///@}

  ///@{
  /** Bind what the gather, and what the solve needs. */
  void BindCorners() const;
  void BindTables() const;
  ///@}

  ///@{
  /**
   * From fragments to what the resolve looks up: take the least opacities of the fragments, which
   * are forgotten for the next time; smooth them so many times; and show them, also at corners.
   */
  void TakeLeast(vtkOpenGLRenderWindow* window);
  void Smooth(vtkOpenGLRenderWindow* window, int iterations);
  void Show(vtkOpenGLRenderWindow* window);
  ///@}

  /** Show no opacities: all are as if not seen. */
  void Forget();

  /**
   * Let what is shown from now on, until StopFading(), follow the smoothed opacities only as Fade()
   * says; only segments that were not shown before have theirs at once. The first returns whether
   * it does: OpenGL may be out of memory; the second, whether the smoothed opacities are to be
   * found anew.
   */
  bool StartFading();
  bool StopFading();

  /** Move what is shown by this share, in [0,1], of the way towards the smoothed opacities. When
   * all have come within 1/3000, they are there. */
  void Fade(vtkOpenGLRenderWindow* window, double share);

  /** Whether some of what is shown is still on its way. */
  bool IsFading() const { return this->Shown == Faded && this->HasWayLeft; }

  /** Lower the least opacities of segments to these; between the solve and Smooth(). */
  void Lower(const std::vector<SegmentOpacity>& opacities);

  /** The opacities that the resolve looks up, and how it does. */
  std::vector<float> Read() const;
  static double Interpolate(
    const std::vector<float>& opacities, std::uint32_t first, std::uint32_t share);

  /** Bind what the resolve needs. */
  void BindOpacities() const;

  static void Unbind();

  vtkIdType GetBytes() const;
  void Release();

private:
  enum Buffer
  {
    Segments,
    Actors,
    FirstNeighbors,
    Neighbors,
    Corners,
    Source,
    Target,
    Faded,
    Pending,
    NumberOfBuffers
  };

  bool Allocate(Buffer buffer, vtkIdType bytes, const void* data);
  template <typename Table>
  bool Put(Buffer buffer, const Table& table);
  void Fill(Buffer buffer, float value);
  void DrawFade(vtkOpenGLRenderWindow* window, double share);
  void DrawIterations(vtkOpenGLRenderWindow* window, int first, int last);
  void DrawStep(vtkOpenGLRenderWindow* window, const char* fragmentShader, vtkIdType elements,
    const std::function<void(vtkShaderProgram*)>& setUniforms = {});
  void InterpolateCorners(vtkOpenGLRenderWindow* window);

  std::array<GLuint, NumberOfBuffers> Handles{};
  std::array<vtkIdType, NumberOfBuffers> Bytes{};
  vtkIdType NumberOfSegments = 0;
  vtkIdType NumberOfCorners = 0;
  Buffer Shown = Source;
  bool HasSolution = false; ///< in Source
  bool HasWayLeft = false;  ///< from Faded to Source
  vtkEmptyFramebuffer Framebuffer;
  vtkStageDraw Stage;
};

VTK_ABI_NAMESPACE_END
#endif
