// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrajectoryFiles.h"

#include "RenderOptions.h"

#include "vtkGeographicTrajectoryReader.h"
#include "vtkTrajectoryReaderFactory.h"

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
void Apply(const RenderOptions& options, vtkGeographicTrajectoryReader* reader)
{
  reader->SetEnsembleMember(options.EnsembleMember);
  reader->SetVerticalAxis(static_cast<int>(options.VerticalAxis));
  reader->SetVerticalScale(options.VerticalScale);
  reader->SetLongitudeMode(static_cast<int>(options.LongitudeMode));
  reader->SetCentralLongitude(options.CentralLongitude);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTrajectoryReader> MakeTrajectoryReader(
  const std::string& fileName, const RenderOptions& options)
{
  auto reader = vtk::TakeSmartPointer(vtkTrajectoryReaderFactory::CreateReader(fileName.c_str()));
  if (auto* geographic = vtkGeographicTrajectoryReader::SafeDownCast(reader))
  {
    Apply(options, geographic);
  }
  return reader;
}
}
