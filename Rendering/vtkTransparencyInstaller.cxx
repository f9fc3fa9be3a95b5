// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTransparencyInstaller.h"

#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkExactTransparencyPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTransparencyInstaller);
vtkInformationKeyMacro(vtkTransparencyInstaller, KEY, ObjectBase);

namespace
{
// After observers with the default priority, which may set up passes of their own.
constexpr float ObserverPriority = -1.0f;

// How a class of passes gives and takes the one that it holds.
struct HolderClass
{
  std::string Name;
  vtkTransparencyInstaller::GetDelegateFunction Get;
  vtkTransparencyInstaller::SetDelegateFunction Set;
};

template <typename HolderT>
HolderClass MakeHolderClass(const char* name)
{
  return { name,
    [](vtkRenderPass* holder) { return static_cast<HolderT*>(holder)->GetDelegatePass(); },
    [](vtkRenderPass* holder, vtkRenderPass* delegate)
    { static_cast<HolderT*>(holder)->SetDelegatePass(delegate); } };
}

// A sequence holds a pass where it has no other, as PyVista's chains have.
vtkRenderPass* GetOnlyPass(vtkRenderPass* holder)
{
  vtkRenderPassCollection* passes = static_cast<vtkSequencePass*>(holder)->GetPasses();
  return passes && passes->GetNumberOfItems() == 1 ? passes->GetLastRenderPass() : nullptr;
}

void SetOnlyPass(vtkRenderPass* holder, vtkRenderPass* delegate)
{
  static_cast<vtkSequencePass*>(holder)->GetPasses()->ReplaceItem(0, delegate);
}

std::vector<HolderClass>& GetHolderClasses()
{
  static std::vector<HolderClass> classes{ MakeHolderClass<vtkCameraPass>("vtkCameraPass"),
    MakeHolderClass<vtkImageProcessingPass>("vtkImageProcessingPass"),
    MakeHolderClass<vtkSSAAPass>("vtkSSAAPass"),
    HolderClass{ "vtkSequencePass", GetOnlyPass, SetOnlyPass } };
  return classes;
}

// Null where the pass is known to hold no other.
const HolderClass* FindHolderClass(vtkRenderPass* pass)
{
  const std::vector<HolderClass>& classes = GetHolderClasses();
  const auto found = std::find_if(classes.rbegin(), classes.rend(),
    [pass](const HolderClass& holder) { return pass->IsA(holder.Name.c_str()); });
  return found == classes.rend() ? nullptr : &*found;
}

vtkRenderPass* GetDelegate(vtkRenderPass* pass)
{
  const HolderClass* holder = FindHolderClass(pass);
  return holder ? holder->Get(pass) : nullptr;
}

// By name: ParaView's class is not known here.
bool IsDefaultPass(vtkRenderPass* pass)
{
  return pass->IsA("vtkDefaultPass") || pass->IsA("vtkPVDefaultPass");
}

bool IsOfClass(vtkRenderPass* pass, const char* name)
{
  return pass && std::string(pass->GetClassName()) == name;
}

// The steps of VTK's default drawing, camera included, with none exchanged by the application.
bool IsDefaultSteps(vtkRenderPass* pass)
{
  auto* steps = vtkRenderStepsPass::SafeDownCast(pass);
  return steps && IsOfClass(steps->GetCameraPass(), "vtkCameraPass") &&
    IsOfClass(steps->GetLightsPass(), "vtkLightsPass") &&
    IsOfClass(steps->GetOpaquePass(), "vtkOpaquePass") &&
    IsOfClass(steps->GetTranslucentPass(), "vtkTranslucentPass") &&
    IsOfClass(steps->GetVolumetricPass(), "vtkVolumetricPass") &&
    IsOfClass(steps->GetOverlayPass(), "vtkOverlayPass") && !steps->GetPostProcessPass();
}
}

//------------------------------------------------------------------------------
vtkTransparencyInstaller::vtkTransparencyInstaller()
{
  this->CameraPass->SetDelegatePass(this->Pass);
}

//------------------------------------------------------------------------------
vtkTransparencyInstaller::~vtkTransparencyInstaller()
{
  this->StopObserving();
  // Mappers may keep the pass alive for longer than the renderer.
  this->Pass->FreeGraphicsMemory();
}

//------------------------------------------------------------------------------
vtkTransparencyInstaller* vtkTransparencyInstaller::Find(vtkRenderer* renderer)
{
  vtkInformation* information = renderer ? renderer->GetInformation() : nullptr;
  return information
    ? static_cast<vtkTransparencyInstaller*>(information->Get(vtkTransparencyInstaller::KEY()))
    : nullptr;
}

//------------------------------------------------------------------------------
vtkExactTransparencyPass* vtkTransparencyInstaller::Install(vtkRenderer* renderer, vtkObject* owner)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("Exact transparency was not installed: expected a vtkRenderer, found "
                           "none. Pass the renderer that draws the scene.");
    return nullptr;
  }
  if (!vtkTransparencyInstaller::Find(renderer))
  {
    if (!renderer->GetInformation())
    {
      vtkNew<vtkInformation> information;
      renderer->SetInformation(information);
    }
    vtkNew<vtkTransparencyInstaller> installer;
    installer->Observe(renderer);
    renderer->GetInformation()->Set(vtkTransparencyInstaller::KEY(), installer);
  }
  vtkTransparencyInstaller* installer = vtkTransparencyInstaller::Find(renderer);
  installer->Owners.insert(owner);
  return installer->Pass;
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::Uninstall(vtkRenderer* renderer, vtkObject* owner)
{
  const vtkSmartPointer<vtkTransparencyInstaller> installer =
    vtkTransparencyInstaller::Find(renderer);
  if (!installer || installer->Owners.erase(owner) == 0 || !installer->Owners.empty())
  {
    return;
  }
  installer->LeaveFrame();
  installer->StopObserving();
  if (renderer->GetPass() == installer->CameraPass)
  {
    renderer->SetPass(nullptr);
  }
  renderer->GetInformation()->Remove(vtkTransparencyInstaller::KEY());
}

//------------------------------------------------------------------------------
vtkExactTransparencyPass* vtkTransparencyInstaller::GetPass(vtkRenderer* renderer)
{
  vtkTransparencyInstaller* installer = vtkTransparencyInstaller::Find(renderer);
  return installer ? installer->Pass.GetPointer() : nullptr;
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::AddHolder(
  const std::string& className, GetDelegateFunction get, SetDelegateFunction set)
{
  std::vector<HolderClass>& classes = GetHolderClasses();
  classes.erase(std::remove_if(classes.begin(), classes.end(),
                  [&](const HolderClass& holder) { return holder.Name == className; }),
    classes.end());
  classes.push_back({ className, get, set });
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::Observe(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  this->StartTag = renderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkTransparencyInstaller::EnterFrame, ObserverPriority);
  this->EndTag = renderer->AddObserver(
    vtkCommand::EndEvent, this, &vtkTransparencyInstaller::LeaveFrame, ObserverPriority);
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::StopObserving()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->StartTag);
    this->Renderer->RemoveObserver(this->EndTag);
  }
  this->Renderer = nullptr;
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::EnterFrame()
{
  // Only a frame that was broken off has left something to do.
  this->LeaveFrame();
  if (!this->Renderer->GetPass())
  {
    this->Renderer->SetPass(this->CameraPass);
  }
  vtkRenderPass* holder = nullptr;
  vtkRenderPass* leaf = this->Renderer->GetPass();
  while (vtkRenderPass* delegate = GetDelegate(leaf))
  {
    holder = leaf;
    leaf = delegate;
  }
  if (vtkExactTransparencyPass::SafeDownCast(leaf))
  {
    return;
  }
  const bool isDefaultSteps = IsDefaultSteps(leaf);
  if (!isDefaultSteps && !IsDefaultPass(leaf))
  {
    if (!this->WarnedOfLeaf)
    {
      vtkWarningMacro("Exact transparency is off while "
        << leaf->GetClassName()
        << " draws the renderer; expected VTK's or ParaView's default pass at the end of the chain "
           "of render passes. Remove that pass to get exact transparency.");
      this->WarnedOfLeaf = true;
    }
    return;
  }
  this->Holder = holder;
  this->ReplacedLeaf = leaf;
  this->Replacement = this->Pass;
  if (isDefaultSteps)
  {
    this->Replacement = this->CameraPass;
  }
  this->Replace(leaf, this->Replacement);
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::LeaveFrame()
{
  if (this->ReplacedLeaf)
  {
    this->Replace(this->Replacement, this->ReplacedLeaf);
    this->Holder = nullptr;
    this->ReplacedLeaf = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::Replace(vtkRenderPass* expected, vtkRenderPass* leaf)
{
  // What was set meanwhile by others stays.
  if (this->Holder)
  {
    if (GetDelegate(this->Holder) == expected)
    {
      FindHolderClass(this->Holder)->Set(this->Holder, leaf);
    }
  }
  else if (this->Renderer->GetPass() == expected)
  {
    this->Renderer->SetPass(leaf);
  }
}

//------------------------------------------------------------------------------
void vtkTransparencyInstaller::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.GetPointer() << "\n";
  os << indent << "Pass:\n";
  this->Pass->PrintSelf(os, indent.GetNextIndent());
}

VTK_ABI_NAMESPACE_END
