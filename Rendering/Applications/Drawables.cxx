// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Drawables.h"

#include "MessageLog.h"
#include "ProgressLine.h"
#include "RenderError.h"
#include "RenderOptions.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldStreamlines.h"
#include "vtkMultiBlockDataSet.h"

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
Drawable Trace(const std::string& name, vtkDataObject* field, const RenderOptions& options)
{
  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  vtkNew<vtkFieldStreamlines> tracer;
  tracer->SetInputData(field);
  tracer->SetNumberOfSeeds(options.Seeds);
  tracer->SetSeedingMode(static_cast<int>(options.SeedingMode));
  tracer->SetSeedOffset(options.SeedOffset);
  tracer->SetMaximumLength(options.MaximumLength);
  if (options.SeedLineFirst && options.SeedLineLast)
  {
    tracer->SetPoint1(options.SeedLineFirst->data());
    tracer->SetPoint2(options.SeedLineLast->data());
  }
  if (!options.Vectors.empty())
  {
    tracer->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, options.Vectors.c_str());
  }
  {
    const ProgressLine progress(tracer, "Tracing streamlines");
    tracer->Update();
  }
  if (log.HasErrors())
  {
    throw RenderError(name + ": " + log.GetFirstError());
  }
  if (tracer->GetOutput()->GetNumberOfLines() == 0)
  {
    throw RenderError(name + ": " + log.GetFirstWarning());
  }
  return { name, tracer->GetOutput(), tracer->GetVectorsName() };
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> JoinParts(const std::vector<vtkDataSet*>& parts)
{
  if (parts.size() == 1)
  {
    return parts.front();
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (vtkDataSet* part : parts)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), part);
  }
  return blocks;
}

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> Drawable::GetLeaves() const
{
  return vtkCompositeDataSet::GetDataSets<vtkPolyData>(this->Data);
}

//------------------------------------------------------------------------------
vtkIdType Drawable::GetNumberOfPoints() const
{
  return this->Data->GetNumberOfElements(vtkDataObject::POINT);
}

//------------------------------------------------------------------------------
vtkIdType Drawable::GetNumberOfLines() const
{
  vtkIdType lines = 0;
  for (vtkPolyData* leaf : this->GetLeaves())
  {
    lines += leaf->GetNumberOfLines();
  }
  return lines;
}

//------------------------------------------------------------------------------
std::vector<Drawable> MakeDrawables(const std::vector<Input>& inputs, const RenderOptions& options)
{
  std::vector<Drawable> drawables;
  for (const Input& input : inputs)
  {
    std::vector<vtkDataSet*> geometry;
    std::vector<vtkDataSet*> fields;
    for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(input.Data))
    {
      (vtkPolyData::SafeDownCast(leaf) ? geometry : fields).push_back(leaf);
    }
    if (!geometry.empty())
    {
      drawables.push_back({ input.Name, JoinParts(geometry), std::string() });
      drawables.back().IsMap = input.IsMap;
    }
    if (!fields.empty())
    {
      drawables.push_back(Trace(input.Name, JoinParts(fields), options));
    }
  }
  return drawables;
}
}
