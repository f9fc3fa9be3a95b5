// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The image-space stages on the fragment lists of one tile. Each draws the tile, or the blocks of
 * it that have fragments, with a program of its own.
 */

#ifndef vtkFragmentStages_h
#define vtkFragmentStages_h

#include "vtkFragmentTiles.h" // for vtkPixelRectangle
#include "vtkPictureView.h"
#include "vtkStageDraw.h"

#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkOpaqueLayer;
class vtkOpenGLRenderWindow;
class vtkPixelAttributes;
class vtkShaderProgram;

class vtkFragmentStages
{
public:
  vtkFragmentStages() = default;
  ~vtkFragmentStages() = default;
  vtkFragmentStages(const vtkFragmentStages&) = delete;
  void operator=(const vtkFragmentStages&) = delete;

  ///@{
  /**
   * Sort the lists of the tile by depth, in place; where these are not kept, without fragments that
   * cannot be seen for those in front of them. The framebuffer must have no colour buffer, or
   * colour writes must be off. Where that has counted ties, the second must follow: it orders the
   * fragments of equal depth.
   */
  void Sort(
    vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile);
  void BreakTies(
    vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile);
  void SetKeepsHidden(bool keeps) { this->KeepsHidden = keeps; }
  ///@}

  /**
   * Find the optimal opacity of the fragments of sorted lists, and of these the least one of each
   * segment. Framebuffer as for Sort.
   */
  void Solve(
    vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile);

  ///@{
  /**
   * Find the attributes of the pixels, and the factors on opacities that follow from them. The
   * first is needed where they are smoothed. Framebuffer as for Sort.
   */
  void FindAttributes(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
    const vtkPixelRectangle& tile, const vtkPixelAttributes& attributes);
  void Avoid(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
    const vtkPixelRectangle& tile, const vtkPixelAttributes& attributes);
  ///@}

  /**
   * Composite the sorted lists over the opaque layer into the current framebuffer. May be repeated:
   * the result does not depend on what the framebuffer holds.
   */
  void Resolve(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
    const vtkPixelRectangle& tile, const vtkPictureView& view);

  /** Whether the nodes hold importances. */
  void SetStoresImportance(bool stores) { this->StoresImportance = stores; }

  /** Set the uniforms of glsl/vtkFragmentListsDec.glsl. */
  static void SetTile(vtkShaderProgram* program, const vtkPixelRectangle& tile);

  void Release();

private:
  /** Draws blocks that have one of these flags of vtkFragmentLists; 0: the whole tile. */
  void Draw(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
    const vtkPixelRectangle& tile, std::uint32_t blocks, const char* fragmentShader,
    const std::string& moreDefinitions = std::string(),
    const vtkStageDraw::SetUniforms& setMoreUniforms = {});

  void DrawAttributes(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
    const vtkPixelRectangle& tile, std::uint32_t blocks, const char* fragmentShader,
    const vtkPixelAttributes& attributes);

  void DrawSort(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
    const vtkPixelRectangle& tile, std::uint32_t blocks, bool breaksTies);

  bool StoresImportance = false;
  bool KeepsHidden = true;
  vtkStageDraw Stage;
};

VTK_ABI_NAMESPACE_END
#endif
