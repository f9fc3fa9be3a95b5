// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLeafCopies.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
std::vector<std::pair<vtkDataSet*, vtkDataSet*>> vtkCopyLeaves(
  vtkDataObject* input, vtkDataObject* output)
{
  std::vector<std::pair<vtkDataSet*, vtkDataSet*>> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(input);
    leaves.emplace_back(vtkDataSet::SafeDownCast(input), vtkDataSet::SafeDownCast(output));
    return leaves;
  }

  auto* compositeCopy = vtkCompositeDataSet::SafeDownCast(output);
  compositeCopy->CopyStructure(composite);
  compositeCopy->GetFieldData()->ShallowCopy(composite->GetFieldData());
  const auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    const auto copy = vtk::TakeSmartPointer(leaf->NewInstance());
    copy->ShallowCopy(leaf);
    compositeCopy->SetDataSet(iterator, copy);
    if (auto* dataSet = vtkDataSet::SafeDownCast(leaf))
    {
      leaves.emplace_back(dataSet, vtkDataSet::SafeDownCast(copy));
    }
  }
  return leaves;
}

VTK_ABI_NAMESPACE_END
