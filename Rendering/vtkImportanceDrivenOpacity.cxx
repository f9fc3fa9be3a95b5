// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkImportanceDrivenOpacity.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"

VTK_ABI_NAMESPACE_BEGIN

vtkInformationKeyMacro(vtkImportanceDrivenOpacity, KEY, ObjectBase);

//------------------------------------------------------------------------------
vtkImportanceDrivenOpacity::vtkImportanceDrivenOpacity()
{
  this->SetImportanceArray("Importance");
}

//------------------------------------------------------------------------------
vtkImportanceDrivenOpacity::~vtkImportanceDrivenOpacity()
{
  this->SetImportanceArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkImportanceDrivenOpacity::Attach(vtkActor* actor, vtkImportanceDrivenOpacity* parameters)
{
  if (!actor || vtkImportanceDrivenOpacity::Get(actor) == parameters)
  {
    return;
  }
  if (!actor->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    actor->SetPropertyKeys(keys);
  }
  actor->GetPropertyKeys()->Set(vtkImportanceDrivenOpacity::KEY(), parameters);
  actor->SetForceTranslucent(parameters != nullptr);
  actor->Modified();
}

//------------------------------------------------------------------------------
vtkImportanceDrivenOpacity* vtkImportanceDrivenOpacity::Get(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys
    ? vtkImportanceDrivenOpacity::SafeDownCast(keys->Get(vtkImportanceDrivenOpacity::KEY()))
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkImportanceDrivenOpacity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImportanceArray: " << (this->ImportanceArray ? this->ImportanceArray : "(none)")
     << "\n";
  os << indent << "ImportanceRange: " << this->ImportanceRange[0] << " " << this->ImportanceRange[1]
     << "\n";
}

VTK_ABI_NAMESPACE_END
