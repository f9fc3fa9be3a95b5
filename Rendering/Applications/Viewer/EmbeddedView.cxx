// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmbeddedView.h"

#include "vtkCallbackCommand.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkVersionMacros.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
void Observe(vtkObject* object, unsigned long event, void* client,
  void (*callback)(vtkObject*, unsigned long, void*, void*))
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(client);
  command->SetCallback(callback);
  object->AddObserver(event, command);
}
}

//------------------------------------------------------------------------------
EmbeddedView::EmbeddedView(GLWindow& window)
  : Window(window)
{
  this->AnswerEvents();
  this->RenderWindow->SetOwnContext(0);
  this->RenderWindow->SetMultiSamples(0);
  this->RenderWindow->SetAlphaBitPlanes(1);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  this->RenderWindow->SetOpenGLSymbolLoader(
    [](void*, const char* name) { return glfwGetProcAddress(name); }, nullptr);
#endif
  this->RenderWindow->OpenGLInitContext();
  this->RenderWindow->OpenGLInit();
  this->Interactor->SetRenderWindow(this->RenderWindow);
  this->Interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
  this->Interactor->EnableRenderOff();
  this->Interactor->Initialize();
}

//------------------------------------------------------------------------------
EmbeddedView::~EmbeddedView()
{
  this->Window.MakeCurrent();
  this->SetRenderer(nullptr);
  this->RenderWindow->Finalize();
}

//------------------------------------------------------------------------------
void EmbeddedView::AnswerEvents()
{
  Observe(this->RenderWindow, vtkCommand::WindowMakeCurrentEvent, &this->Window,
    [](vtkObject*, unsigned long, void* window, void*)
    { static_cast<GLWindow*>(window)->MakeCurrent(); });
  Observe(this->RenderWindow, vtkCommand::WindowIsCurrentEvent, &this->Window,
    [](vtkObject*, unsigned long, void* window, void* isCurrent)
    { *static_cast<bool*>(isCurrent) = static_cast<GLWindow*>(window)->IsCurrent(); });
  Observe(this->Interactor, vtkCommand::RenderEvent, this,
    [](vtkObject*, unsigned long, void* view, void*)
    { static_cast<EmbeddedView*>(view)->Invalidate(); });
}

//------------------------------------------------------------------------------
void EmbeddedView::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer)
  {
    this->RenderWindow->RemoveRenderer(this->Renderer);
  }
  this->Renderer = renderer;
  if (this->Renderer)
  {
    this->RenderWindow->AddRenderer(this->Renderer);
  }
  this->Invalidate();
}

//------------------------------------------------------------------------------
void EmbeddedView::SetSize(int width, int height)
{
  const int* size = this->Interactor->GetSize();
  if (width != size[0] || height != size[1])
  {
    this->Interactor->UpdateSize(width, height);
    this->Invalidate();
  }
}

//------------------------------------------------------------------------------
void EmbeddedView::Draw()
{
  // Others have changed the state: VTK must not rely on what it remembers of it.
  this->Window.MakeCurrent();
  vtkOpenGLState* state = this->RenderWindow->GetState();
  if (this->IsStale)
  {
    this->IsStale = false;
    if (this->Renderer)
    {
      this->Renderer->ResetCameraClippingRange();
    }
    this->RenderWindow->Render();
  }
  else
  {
    state->Reset();
    this->RenderWindow->BlitDisplayFramebuffer();
  }
}

//------------------------------------------------------------------------------
void EmbeddedView::OnButton(int button, bool isPressed, const Pointer& pointer)
{
  unsigned long event = vtkCommand::NoEvent;
  switch (button)
  {
    case GLFW_MOUSE_BUTTON_LEFT:
      event = isPressed ? vtkCommand::LeftButtonPressEvent : vtkCommand::LeftButtonReleaseEvent;
      break;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      event = isPressed ? vtkCommand::MiddleButtonPressEvent : vtkCommand::MiddleButtonReleaseEvent;
      break;
    case GLFW_MOUSE_BUTTON_RIGHT:
      event = isPressed ? vtkCommand::RightButtonPressEvent : vtkCommand::RightButtonReleaseEvent;
      break;
    default:
      return;
  }
  this->Place(pointer);
  this->Interactor->InvokeEvent(event);
}

//------------------------------------------------------------------------------
void EmbeddedView::OnMove(const Pointer& pointer)
{
  this->Place(pointer);
  this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
}

//------------------------------------------------------------------------------
void EmbeddedView::OnScroll(double steps, const Pointer& pointer)
{
  this->Place(pointer);
  this->Scrolled += steps;
  const auto event =
    this->Scrolled > 0.0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent;
  const int whole = static_cast<int>(this->Scrolled);
  this->Scrolled -= whole;
  for (int step = 0; step < std::abs(whole); ++step)
  {
    this->Interactor->InvokeEvent(event);
  }
}

//------------------------------------------------------------------------------
void EmbeddedView::Place(const Pointer& pointer)
{
  this->Interactor->SetEventInformation(
    pointer.X, pointer.Y, pointer.Control ? 1 : 0, pointer.Shift ? 1 : 0);
}
}
