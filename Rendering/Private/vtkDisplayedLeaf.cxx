// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDisplayedLeaf.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
class LeafFinder
{
public:
  LeafFinder(vtkCompositeDataDisplayAttributes* attributes, unsigned int firstIndex)
    : Attributes(attributes)
    , FlatIndex(firstIndex)
  {
  }

  /** `display` is that of the parent. */
  void Visit(vtkDataObject* block, vtkBlockDisplay display)
  {
    const unsigned int flatIndex = this->FlatIndex++;
    this->Override(display, block);
    if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
    {
      for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
      {
        this->Visit(child, display);
      }
    }
    else if (auto* data = vtkPolyData::SafeDownCast(block))
    {
      if (data->GetNumberOfPoints() > 0)
      {
        this->Leaves.push_back({ data, flatIndex, display });
      }
    }
  }

  std::vector<vtkDisplayedLeaf> Leaves;

private:
  void Override(vtkBlockDisplay& display, vtkDataObject* block) const
  {
    if (!this->Attributes)
    {
      return;
    }
    if (this->Attributes->HasBlockVisibility(block))
    {
      display.Visible = this->Attributes->GetBlockVisibility(block);
    }
    if (this->Attributes->HasBlockPickability(block))
    {
      display.Pickable = this->Attributes->GetBlockPickability(block);
    }
    if (this->Attributes->HasBlockOpacity(block))
    {
      display.Opacity = this->Attributes->GetBlockOpacity(block);
    }
    if (this->Attributes->HasBlockColor(block))
    {
      const vtkColor3d color = this->Attributes->GetBlockColor(block);
      display.Color = { { color[0], color[1], color[2] } };
    }
  }

  vtkCompositeDataDisplayAttributes* Attributes;
  unsigned int FlatIndex;
};
}

//------------------------------------------------------------------------------
std::vector<vtkDisplayedLeaf> vtkFindDisplayedLeaves(
  vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes)
{
  LeafFinder finder(attributes, vtkDataObjectTree::SafeDownCast(data) ? 0 : 1);
  finder.Visit(data, vtkBlockDisplay());
  return finder.Leaves;
}

VTK_ABI_NAMESPACE_END
