// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMet3DReader.h"

#include "Private/vtkNetCDFTrajectories.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkMet3DReader);

//------------------------------------------------------------------------------
int vtkMet3DReader::CanReadFile(const char* fileName)
{
  return vtkNetCDFTrajectories::CanRead(fileName, vtkNetCDFTrajectories::Layout::Met3D) ? 1 : 0;
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkTrajectorySource> vtkMet3DReader::Open(const std::string& fileName)
{
  return std::make_unique<vtkNetCDFTrajectories>(fileName, vtkNetCDFTrajectories::Layout::Met3D);
}

VTK_ABI_NAMESPACE_END
