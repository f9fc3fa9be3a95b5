// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpacityOptimization.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkOpacityOptimization);
vtkInformationKeyMacro(vtkOpacityOptimization, KEY, ObjectBase);

//------------------------------------------------------------------------------
vtkOpacityOptimization::vtkOpacityOptimization()
{
  this->SetImportanceArray("Importance");
}

//------------------------------------------------------------------------------
vtkOpacityOptimization::~vtkOpacityOptimization()
{
  this->SetImportanceArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::Attach(vtkActor* actor, vtkOpacityOptimization* optimization)
{
  if (!actor || vtkOpacityOptimization::Get(actor) == optimization)
  {
    return;
  }
  if (!actor->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    actor->SetPropertyKeys(keys);
  }
  actor->GetPropertyKeys()->Set(vtkOpacityOptimization::KEY(), optimization);
  actor->SetForceTranslucent(optimization != nullptr);
  actor->Modified();
}

//------------------------------------------------------------------------------
vtkOpacityOptimization* vtkOpacityOptimization::Get(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys ? vtkOpacityOptimization::SafeDownCast(keys->Get(vtkOpacityOptimization::KEY()))
              : nullptr;
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImportanceArray: " << (this->ImportanceArray ? this->ImportanceArray : "(none)")
     << "\n";
  os << indent << "OcclusionWeight: " << this->OcclusionWeight << "\n";
  os << indent << "ClutterWeight: " << this->ClutterWeight << "\n";
  os << indent << "Emphasis: " << this->Emphasis << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "SelfOcclusion: " << this->SelfOcclusion << "\n";
}

VTK_ABI_NAMESPACE_END
