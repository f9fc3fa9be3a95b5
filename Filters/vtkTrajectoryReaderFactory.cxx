// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryReaderFactory.h"

#include "vtkLagrantoNetCDFReader.h"
#include "vtkLagrantoReader.h"
#include "vtkMRtrixTracksReader.h"
#include "vtkMet3DReader.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTRXReader.h"
#include "vtkTrackVisReader.h"
#include "vtkTrajectoryReader.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectoryReaderFactory);

namespace
{
//------------------------------------------------------------------------------
template <typename Reader>
vtkSmartPointer<vtkTrajectoryReader> Make()
{
  return vtkSmartPointer<Reader>::New();
}

using Maker = vtkSmartPointer<vtkTrajectoryReader> (*)();

const std::vector<Maker> Makers = {
  Make<vtkMet3DReader>,
  Make<vtkLagrantoNetCDFReader>,
  Make<vtkLagrantoReader>,
  Make<vtkTrackVisReader>,
  Make<vtkMRtrixTracksReader>,
  Make<vtkTRXReader>,
};
}

//------------------------------------------------------------------------------
vtkTrajectoryReader* vtkTrajectoryReaderFactory::CreateReader(const char* fileName)
{
  for (const Maker make : Makers)
  {
    vtkSmartPointer<vtkTrajectoryReader> reader = make();
    if (reader->CanReadFile(fileName))
    {
      reader->SetFileName(fileName);
      reader->Register(nullptr);
      return reader;
    }
  }
  return nullptr;
}

VTK_ABI_NAMESPACE_END
