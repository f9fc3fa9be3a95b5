// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPellucidRepresentationProxy.h"

#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPellucidRepresentation.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSMPellucidRepresentationProxy);

//------------------------------------------------------------------------------
void vtkSMPellucidRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  auto* display = vtkPellucidRepresentation::SafeDownCast(this->GetClientSideObject());
  const auto location = this->Location;
  if (display && display->IsDrawnOnServer())
  {
    this->Location = vtkPVSession::RENDER_SERVER;
  }
  this->Superclass::UpdatePropertyInformationInternal(property);
  this->Location = location;
}
VTK_ABI_NAMESPACE_END
