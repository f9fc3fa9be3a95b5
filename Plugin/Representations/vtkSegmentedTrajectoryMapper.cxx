// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentedTrajectoryMapper.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkSegmentedGeometry.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSegmentedTrajectoryMapper);

//------------------------------------------------------------------------------
vtkSegmentedTrajectoryMapper::vtkSegmentedTrajectoryMapper() = default;

//------------------------------------------------------------------------------
vtkSegmentedTrajectoryMapper::~vtkSegmentedTrajectoryMapper() = default;

//------------------------------------------------------------------------------
void vtkSegmentedTrajectoryMapper::SetInputDataObject(int port, vtkDataObject* data)
{
  this->Segments->SetInputDataObject(port, data);
  this->SetInputConnection(port, data ? this->Segments->GetOutputPort() : nullptr);
}

VTK_ABI_NAMESPACE_END
