// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   VTK, and with it Pellucid, in a window and OpenGL context of the application's own.
 *
 * What to do in an application that has its own window, be it of GLFW, SDL, Qt or the operating
 * system; the source of this class is the example.
 *
 * Once:
 * 1. Make a context of OpenGL 4.3 or newer, core or compatibility profile. With 3.2 to 4.2 VTK
 *    draws by its own transparency; vtkExactTransparencyPass::GetReasonUnsupported() tells. The
 *    framebuffer needs neither depth nor samples: VTK has its own.
 * 2. Make a vtkGenericOpenGLRenderWindow and answer its events: WindowMakeCurrentEvent makes the
 *    context current, WindowIsCurrentEvent sets the bool that comes as call data. SetOwnContext(0)
 *    says that others change the state of the context. From VTK 9.4 on, SetOpenGLSymbolLoader()
 *    names the function that finds OpenGL's. Then call OpenGLInitContext() and OpenGLInit(), in
 *    this order, with the context current.
 * 3. Add a renderer and call vtkTransparencyInstaller::Install(renderer).
 * 4. Make a vtkGenericRenderWindowInteractor, hand it the mouse in pixels from the lower left
 *    corner, and let its RenderEvent ask for a new frame (EnableRenderOff()), so that several
 *    events make one.
 *
 * For each frame, with the context current:
 * 5. Bind the framebuffer that is to get the picture: VTK copies it to the lower left corner of
 *    what is bound for drawing, in the size of SetSize().
 * 6. Leave no OpenGL error behind: VTK would report it as its own.
 * 7. Call Render(). What vtkOpenGLState knows of the state is saved before and given back: the
 *    framebuffers, viewport, scissor, blending, depth, stencil, masks, culling, clear values, pixel
 *    store, program, vertex array, vertex and index buffer, active texture unit. Not given back are
 *    the textures of the units and the storage buffers of the binding points: bind yours anew. Not
 *    set for you is what programs rarely touch: have no sampler objects bound, writing of sRGB,
 *    primitive restart and clip distances off, and polygons filled.
 * 8. Draw your own on top, and swap.
 *
 * Where only your own part changes, BlitDisplayFramebuffer() copies the last picture again.
 *
 * In the end, while the context still exists: make it current and call Finalize().
 */

#ifndef EmbeddedView_h
#define EmbeddedView_h

#include "GLWindow.h"

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace pellucid
{
/** One renderer in the lower left part of a window, turned by the mouse. */
class EmbeddedView
{
public:
  explicit EmbeddedView(GLWindow& window);
  ~EmbeddedView();
  EmbeddedView(const EmbeddedView&) = delete;
  void operator=(const EmbeddedView&) = delete;

  /** Show another renderer, or none. */
  void SetRenderer(vtkRenderer* renderer);

  /** In pixels. */
  void SetSize(int width, int height);

  /** The next Draw() is to render. */
  void Invalidate() { this->IsStale = true; }
  bool NeedsRender() const { return this->IsStale; }

  /** Into the window's framebuffer: render where something has changed, else show the same again.
   */
  void Draw();

  vtkGenericOpenGLRenderWindow* GetRenderWindow() { return this->RenderWindow; }

  ///@{
  /** What the mouse does: turn (left), shift (middle), zoom (right, or the wheel). */
  void OnButton(int button, bool isPressed, const Pointer& pointer);
  void OnMove(const Pointer& pointer);
  void OnScroll(double steps, const Pointer& pointer);
  ///@}

private:
  void AnswerEvents();
  void Place(const Pointer& pointer);

  GLWindow& Window;
  vtkNew<vtkGenericOpenGLRenderWindow> RenderWindow;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
  vtkSmartPointer<vtkRenderer> Renderer;
  bool IsStale = true;
  double Scrolled = 0.0; // of a step, which touchpads make in parts
};
}

#endif
