// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPellucidRepresentation.h"

#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTransparencyInstaller.h"

// Only a ParaView with MPI has it.
#if __has_include("vtkIceTCompositePass.h")
#include "vtkIceTCompositePass.h"
#define PELLUCID_HAS_ICET
#endif

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// On several ranks the pass that composites their pictures holds the one that draws them.
void AddCompositePass()
{
#ifdef PELLUCID_HAS_ICET
  vtkTransparencyInstaller::AddHolder(
    "vtkIceTCompositePass",
    [](vtkRenderPass* holder) -> vtkRenderPass*
    { return vtkIceTCompositePass::SafeDownCast(holder)->GetRenderPass(); },
    [](vtkRenderPass* holder, vtkRenderPass* delegate)
    { vtkIceTCompositePass::SafeDownCast(holder)->SetRenderPass(delegate); });
#endif
}
}

vtkStandardNewMacro(vtkPellucidRepresentation);

//------------------------------------------------------------------------------
vtkPellucidRepresentation::vtkPellucidRepresentation()
{
  this->Mapper->Delete();
  this->LODMapper->Delete();
  this->Mapper = vtkTrajectoryMapper::New();
  this->LODMapper = vtkTrajectoryMapper::New();
  this->SetupDefaults();
  AddCompositePass();
}

//------------------------------------------------------------------------------
vtkPellucidRepresentation::~vtkPellucidRepresentation() = default;

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View.GetPointer() << "\n";
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetRadius(double radius)
{
  for (vtkMapper* mapper : { this->Mapper, this->LODMapper })
  {
    vtkTrajectoryMapper::SafeDownCast(mapper)->SetRadius(radius);
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetRadiusArray(const char* name)
{
  for (vtkMapper* mapper : { this->Mapper, this->LODMapper })
  {
    vtkTrajectoryMapper::SafeDownCast(mapper)->SetRadiusArray(name);
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateTransparency();
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  this->View = vtkPVRenderView::SafeDownCast(view);
  this->UpdateTransparency();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::RemoveFromView(vtkView* view)
{
  if (this->View == view)
  {
    vtkTransparencyInstaller::Uninstall(this->View->GetRenderer(), this);
  }
  this->View = nullptr;
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdateTransparency()
{
  // ParaView keeps one representation of each kind for a source and shows one of them: being in the
  // view does not mean being visible.
  if (!this->View)
  {
    return;
  }
  if (this->GetVisibility())
  {
    vtkTransparencyInstaller::Install(this->View->GetRenderer(), this);
  }
  else
  {
    vtkTransparencyInstaller::Uninstall(this->View->GetRenderer(), this);
  }
}
VTK_ABI_NAMESPACE_END
