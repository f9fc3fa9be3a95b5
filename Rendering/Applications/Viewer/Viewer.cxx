// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Viewer.h"

#include "MessageLog.h"
#include "PictureFile.h"
#include "PictureWindow.h"
#include "Program.h"
#include "RenderError.h"
#include "ViewOptions.h"

#include "vtkExactTransparencyPass.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <utility>

namespace pellucid
{
namespace
{
// Dear ImGui answers an event in the frame after it, and some changes of layout one later.
constexpr int FramesOfAnEvent = 3;

//------------------------------------------------------------------------------
// "pellucid-view-1.png", or the next number that is free.
std::string MakePictureName()
{
  std::string name;
  int number = 0;
  do
  {
    name = "pellucid-view-" + std::to_string(++number) + ".png";
  } while (std::filesystem::exists(name));
  return name;
}
}

//------------------------------------------------------------------------------
Viewer::Viewer(const RenderOptions& options)
  : Scene(options)
  , Window(options.Size, options.Output.empty(), *this)
  , View(this->Window)
  , Panel(this->Window.GetHandle(), this->Window.GetScale())
{
  this->CheckOpenGL();
  if (!this->Scene.Options.Inputs.empty())
  {
    this->Scene.Open();
    this->ShowScene();
  }
}

//------------------------------------------------------------------------------
// Do the work; where it fails the window says why, and the program goes on.
template <typename Work>
void Viewer::Try(const Work& work)
{
  this->Contents.Error.clear();
  this->Contents.Message.clear();
  try
  {
    work();
    const std::string warning = MessageLog::GetInstance().TakePrintedWarning();
    if (!warning.empty())
    {
      this->Contents.Error = warning;
    }
  }
  catch (const std::bad_alloc&)
  {
    this->ShowError("out of memory; the input may be damaged, or too large");
  }
  catch (const std::exception& error)
  {
    this->ShowError(error.what());
  }
  this->OnRefresh();
}

//------------------------------------------------------------------------------
// In the window, and once on the terminal.
void Viewer::ShowError(const std::string& text)
{
  if (text != this->Contents.Error)
  {
    PrintError(text);
  }
  this->Contents.Error = text;
}

//------------------------------------------------------------------------------
void Viewer::CheckOpenGL()
{
  const std::string reason =
    vtkExactTransparencyPass::GetReasonUnsupported(this->View.GetRenderWindow());
  if (reason.empty())
  {
    return;
  }
  if (!this->Scene.Options.Output.empty() && this->Scene.Options.RenderMethod == Method::Pellucid)
  {
    throw RenderError(reason + "; --method vtk draws without exactness");
  }
  this->Contents.Unsupported = "VTK's own transparency is used, because " + reason;
  if (this->Scene.Options.RenderMethod == Method::Pellucid)
  {
    this->Scene.Options.RenderMethod = Method::VTK;
  }
}

//------------------------------------------------------------------------------
void Viewer::ShowScene()
{
  this->View.SetRenderer(this->Scene.GetRenderer());
  const auto& inputs = this->Scene.Options.Inputs;
  this->Window.SetTitle(std::filesystem::path(inputs.front()).filename().string() +
    (inputs.size() > 1 ? " and " + std::to_string(inputs.size() - 1) + " more" : "") +
    " - Pellucid");
}

//------------------------------------------------------------------------------
int Viewer::GetPanelWidth() const
{
  if (!this->IsPanelShown)
  {
    return 0;
  }
  // A narrow window is all panel but for one column.
  const int width =
    static_cast<int>(PanelWidth * this->Window.GetScale() * this->Window.GetDensity());
  const int pixels = this->Window.GetSize()[0];
  return std::clamp(width, 0, std::max(0, pixels - 1));
}

//------------------------------------------------------------------------------
// Where the mouse has just come there, the panel itself knows only after the next frame.
bool Viewer::IsOverPanel(const Pointer& pointer) const
{
  return this->Panel.WantsMouse() || pointer.X >= this->Window.GetSize()[0] - this->GetPanelWidth();
}

//------------------------------------------------------------------------------
void Viewer::Run()
{
  const auto& size = this->Scene.Options.Size; // of the picture
  this->Window.SetSize({ size[0] + this->GetPanelWidth(), size[1] });
  this->OnRefresh();
  while (!this->Window.IsClosed())
  {
    if (this->FramesToDraw > 0 || this->View.NeedsRender())
    {
      this->DrawFrame();
      if (std::exchange(this->IsSaving, false) && this->IsDrawn)
      {
        this->Try([this] { this->SavePicture(); });
      }
    }
    if (!this->Dropped.empty())
    {
      this->OpenDropped(); // after a frame that says so: reading may take long
    }
    const bool isAtRest = this->FramesToDraw == 0 && !this->View.NeedsRender() && !this->IsFading();
    this->Window.HandleEvents(isAtRest || this->IsHidden());
    if (this->IsFading())
    {
      this->View.Invalidate();
    }
  }
}

//------------------------------------------------------------------------------
// Minimised windows have no pixels.
bool Viewer::IsHidden() const
{
  const auto pixels = this->Window.GetSize();
  return pixels[0] == 0 || pixels[1] == 0;
}

//------------------------------------------------------------------------------
void Viewer::DrawFrame()
{
  if (this->IsHidden())
  {
    this->FramesToDraw = 0;
    return;
  }
  this->FramesToDraw = std::max(0, this->FramesToDraw - 1);
  const auto pixels = this->Window.GetSize();
  this->Panel.SetScale(this->Window.GetScale());
  const int panelWidth = this->GetPanelWidth();
  this->View.SetSize(pixels[0] - panelWidth, pixels[1]);
  try
  {
    this->Scene.SetSize(pixels[0] - panelWidth, pixels[1]);
    this->DrawView(this->FadeTime);
  }
  catch (const RenderError& error)
  {
    this->ShowError(error.what());
  }

  this->Panel.BeginFrame();
  const PanelRequest request = this->DrawControls();
  this->Panel.EndFrame();
  this->Window.SwapBuffers();
  this->Obey(request);
}

//------------------------------------------------------------------------------
// The panel, and what is said over the picture.
PanelRequest Viewer::DrawControls()
{
  const float density = this->Window.GetDensity(); // the panel knows units of the desktop
  const auto panelWidth = static_cast<float>(this->GetPanelWidth()) / density;
  const float pictureWidth = static_cast<float>(this->Window.GetSize()[0]) / density - panelWidth;
  if (!this->Scene.GetRenderer())
  {
    DrawHint(std::string("Drop files here to open them.\n\n") + Controls, pictureWidth);
  }
  if (this->IsPanelShown)
  {
    return DrawPanel(this->Scene, this->FadeTime, this->Contents, panelWidth);
  }
  if (!this->Contents.Error.empty())
  {
    DrawError(this->Contents.Error, pictureWidth);
  }
  return {};
}

//------------------------------------------------------------------------------
void Viewer::DrawView(double fadeTime)
{
  if (!this->View.NeedsRender())
  {
    this->View.Draw();
    return;
  }
  this->IsDrawn = false;
  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  if (vtkExactTransparencyPass* pass = this->Scene.GetPass())
  {
    pass->SetFadeTime(fadeTime);
  }
  const auto start = std::chrono::steady_clock::now();
  this->View.Draw();
  this->View.GetRenderWindow()->WaitForCompletion();
  const std::chrono::duration<double, std::milli> elapsed =
    std::chrono::steady_clock::now() - start;
  this->TakeStatistics();
  this->Contents.Statistics.Stages.emplace_back("frame", elapsed.count());
  if (log.HasErrors())
  {
    throw RenderError("the picture cannot be drawn: " + log.GetFirstError());
  }
  this->IsDrawn = true;
  if (log.HasWarnings())
  {
    log.PrintWarnings();
    this->Contents.Error = log.TakePrintedWarning();
  }
}

//------------------------------------------------------------------------------
void Viewer::TakeStatistics()
{
  FrameStatistics statistics;
  statistics.Renderer = GetOpenGLProperty(this->View.GetRenderWindow(), "OpenGL renderer string");
  statistics.OpenGL = GetOpenGLProperty(this->View.GetRenderWindow(), "OpenGL version string");
  if (this->Scene.GetPass())
  {
    statistics.Take(this->Scene.GetPass()->GetStatistics());
  }
  this->Contents.Statistics = statistics;
}

//------------------------------------------------------------------------------
bool Viewer::IsFading() const
{
  vtkExactTransparencyPass* pass = this->Scene.GetPass();
  return pass && pass->GetStatistics()->GetFading();
}

//------------------------------------------------------------------------------
void Viewer::Obey(const PanelRequest& request)
{
  if (request.Changed != Change::None)
  {
    this->Try([&] { this->Scene.Update(request.Changed); });
    this->View.SetRenderer(this->Scene.GetRenderer());
  }
  if (request.ResetsCamera)
  {
    this->OnKey(GLFW_KEY_R);
  }
  if (request.SavesPicture)
  {
    this->OnKey(GLFW_KEY_S);
  }
}

//------------------------------------------------------------------------------
// What the fade ends with, in a file, and on the terminal how pellucid-render makes it.
void Viewer::SavePicture()
{
  if (!this->Scene.GetRenderer())
  {
    throw RenderError("there is no picture yet; drop a file onto this window");
  }
  if (this->IsFading())
  {
    this->View.Invalidate();
    this->DrawView(0.0);
  }
  const std::string name = MakePictureName();
  CheckWritable(name);
  WritePicture(GrabPicture(this->View.GetRenderWindow(), false), name);
  this->Contents.Message = "Written: " + std::filesystem::absolute(name).string();
  std::cout << name << ": " << this->Scene.DescribeView() << std::endl;
}

//------------------------------------------------------------------------------
void Viewer::WriteScreenshot()
{
  const std::string& name = this->Scene.Options.Output;
  CheckWritable(name);
  this->View.SetSize(this->Scene.Options.Size[0], this->Scene.Options.Size[1]);
  this->DrawView(0.0);
  if (!this->Contents.Error.empty())
  {
    throw RenderError(this->Contents.Error);
  }
  WritePicture(GrabPicture(this->View.GetRenderWindow(), false), name);
}

//------------------------------------------------------------------------------
void Viewer::OpenDropped()
{
  const auto fileNames = std::exchange(this->Dropped, {});
  this->Try(
    [&]
    {
      this->Scene.Open(fileNames);
      this->ShowScene();
    });
}

//------------------------------------------------------------------------------
void Viewer::OnButton(int button, bool isPressed, const Pointer& pointer)
{
  this->FramesToDraw = FramesOfAnEvent;
  if (isPressed && this->DraggingButton < 0 && !this->IsOverPanel(pointer))
  {
    this->DraggingButton = button;
    this->View.OnButton(button, true, pointer);
  }
  else if (!isPressed && button == this->DraggingButton)
  {
    this->DraggingButton = -1;
    this->View.OnButton(button, false, pointer);
  }
}

//------------------------------------------------------------------------------
void Viewer::OnMove(const Pointer& pointer)
{
  this->FramesToDraw = FramesOfAnEvent;
  if (this->DraggingButton >= 0)
  {
    this->View.OnMove(pointer);
  }
}

//------------------------------------------------------------------------------
void Viewer::OnScroll(double steps, const Pointer& pointer)
{
  this->FramesToDraw = FramesOfAnEvent;
  if (!this->IsOverPanel(pointer))
  {
    this->View.OnScroll(steps, pointer);
  }
}

//------------------------------------------------------------------------------
void Viewer::OnKey(int key)
{
  this->FramesToDraw = FramesOfAnEvent;
  if (this->Panel.WantsKeyboard())
  {
    return;
  }
  switch (key)
  {
    case GLFW_KEY_R:
      this->Try([this] { this->Scene.ResetCamera(); });
      this->View.Invalidate();
      break;
    case GLFW_KEY_S:
      this->IsSaving = true; // what the next frame shows: other keys may wait for it too
      if (!this->IsDrawn)
      {
        this->View.Invalidate(); // and tell again what is wrong
      }
      break;
    case GLFW_KEY_TAB:
      this->IsPanelShown = !this->IsPanelShown;
      break;
    case GLFW_KEY_ESCAPE:
      if (!this->Panel.CloseLists())
      {
        this->Window.Close();
      }
      break;
    case GLFW_KEY_Q:
      this->Window.Close();
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
void Viewer::OnDrop(const std::vector<std::string>& fileNames)
{
  if (fileNames.empty())
  {
    return; // links of a browser, for example
  }
  this->Dropped = fileNames;
  this->Contents.Error.clear();
  this->Contents.Message = "Reading " + fileNames.front();
  this->OnRefresh();
}

//------------------------------------------------------------------------------
void Viewer::OnRefresh()
{
  this->FramesToDraw = FramesOfAnEvent;
}
}
