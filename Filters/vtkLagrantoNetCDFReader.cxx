// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLagrantoNetCDFReader.h"

#include "Private/vtkNetCDFTrajectories.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkLagrantoNetCDFReader);

//------------------------------------------------------------------------------
int vtkLagrantoNetCDFReader::CanReadFile(const char* fileName)
{
  return vtkNetCDFTrajectories::CanRead(fileName, vtkNetCDFTrajectories::Layout::Lagranto) ? 1 : 0;
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkTrajectorySource> vtkLagrantoNetCDFReader::Open(const std::string& fileName)
{
  return std::make_unique<vtkNetCDFTrajectories>(fileName, vtkNetCDFTrajectories::Layout::Lagranto);
}

VTK_ABI_NAMESPACE_END
