// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PanelContext.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>

namespace pellucid
{
namespace
{
constexpr float FontSize = 13.0F; // of Dear ImGui's own font, in which it is sharp
}

//------------------------------------------------------------------------------
PanelContext::PanelContext(GLFWwindow* window, float scale)
{
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr; // leave no file behind
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 150");
  this->SetScale(scale);
}

//------------------------------------------------------------------------------
PanelContext::~PanelContext()
{
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

//------------------------------------------------------------------------------
void PanelContext::SetScale(float scale)
{
  if (scale == this->Scale)
  {
    return;
  }
  this->Scale = scale;
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.WindowRounding = 0.0F;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
  ImFontConfig font;
  font.SizePixels = std::round(FontSize * scale);
  ImGui::GetIO().Fonts->Clear();
  ImGui::GetIO().Fonts->AddFontDefault(&font);
#if IMGUI_VERSION_NUM < 19200 // newer ones do it by themselves
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

//------------------------------------------------------------------------------
void PanelContext::BeginFrame()
{
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

//------------------------------------------------------------------------------
void PanelContext::EndFrame()
{
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

//------------------------------------------------------------------------------
bool PanelContext::CloseLists()
{
  if (!ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
  {
    return false;
  }
  ImGui::SetWindowFocus(nullptr); // a list without focus closes
  return true;
}

//------------------------------------------------------------------------------
bool PanelContext::WantsMouse() const
{
  return ImGui::GetIO().WantCaptureMouse;
}

//------------------------------------------------------------------------------
bool PanelContext::WantsKeyboard() const
{
  return ImGui::GetIO().WantTextInput;
}
}
