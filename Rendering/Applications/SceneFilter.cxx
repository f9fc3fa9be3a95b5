// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneFilter.h"

#include "MessageLog.h"
#include "ProgressLine.h"
#include "RenderError.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>

namespace pellucid
{
//------------------------------------------------------------------------------
bool AnyPart(const std::vector<Drawable>& drawables, const PartTest& test)
{
  return std::any_of(drawables.begin(), drawables.end(),
    [&test](const Drawable& drawable)
    {
      const auto parts = drawable.GetLeaves();
      return std::any_of(parts.begin(), parts.end(), test);
    });
}

//------------------------------------------------------------------------------
void FilterParts(std::vector<Drawable>& drawables, const PartTest& takesPart, vtkAlgorithm* filter,
  const std::string& title)
{
  vtkNew<vtkMultiBlockDataSet> input;
  for (const Drawable& drawable : drawables)
  {
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      if (takesPart(part))
      {
        input->SetBlock(input->GetNumberOfBlocks(), part);
      }
    }
  }
  if (input->GetNumberOfBlocks() == 0)
  {
    return;
  }

  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  filter->SetInputDataObject(input);
  {
    const ProgressLine progress(filter, title);
    filter->Update();
  }
  if (log.HasErrors())
  {
    throw RenderError(title + ": " + log.GetFirstError());
  }
  log.PrintWarnings();

  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  unsigned int block = 0;
  for (Drawable& drawable : drawables)
  {
    std::vector<vtkDataSet*> parts;
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      parts.push_back(
        takesPart(part) ? vtkPolyData::SafeDownCast(output->GetBlock(block++)) : part);
    }
    drawable.Data = JoinParts(parts);
  }
}

//------------------------------------------------------------------------------
bool HasArray(vtkPolyData* part, const std::string& name)
{
  return part->GetPointData()->GetArray(name.c_str()) ||
    part->GetCellData()->GetArray(name.c_str());
}
}
