// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFieldVectors
 * @brief   The vector field of a data set, or of composite data: which array, and its valid cells.
 *
 * Private to the module.
 *
 * @sa vtkFieldStreamlines
 */

#ifndef vtkFieldVectors_h
#define vtkFieldVectors_h

#include "vtkDataSet.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string> // for names
#include <vector> // for the leaves

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;

class vtkFieldVectors
{
public:
  /**
   * Find the three-component array that `request`, the information of an input array to process,
   * asks for in `data`, and leave out the cells that are blanked or have vectors that are not
   * finite.
   */
  vtkFieldVectors(vtkDataObject* data, vtkInformation* request);

  /** Name of the array; empty when no leaf has it. */
  const std::string& GetName() const { return this->Name; }

  /** vtkDataObject::POINT or vtkDataObject::CELL. */
  int GetAssociation() const { return this->Association; }

  /** The data sets that have the array, reduced to their valid cells; at least one cell in each. */
  const std::vector<vtkDataSet*>& GetLeaves() const { return this->Leaves; }

  /** The leaves as one input of vtkStreamTracer. */
  vtkMultiBlockDataSet* GetDomain() { return this->Domain; }

  /** Greatest number of dimensions of a cell, 0..3. */
  int GetDimension() const { return this->Dimension; }

  /** Length of the greatest vector at a valid cell. */
  double GetMaximumMagnitude() const { return this->MaximumMagnitude; }

  /** Bounding box of the leaves. */
  const double* GetBounds() const { return this->Bounds; }

  /** "A (points, 3), B (cells, 1)": name, association and components of all arrays of `data`;
   * "none". */
  static std::string ListArrays(vtkDataObject* data);

private:
  bool Choose(vtkDataObject* data, vtkInformation* request);
  void Add(vtkDataSet* leaf);

  std::string Name;
  int Association = 0;
  int Dimension = 0;
  double MaximumMagnitude = 0.0;
  double Bounds[6] = { 0.0, -1.0, 0.0, -1.0, 0.0, -1.0 };
  std::vector<vtkDataSet*> Leaves;
  vtkNew<vtkMultiBlockDataSet> Domain;
};

VTK_ABI_NAMESPACE_END
#endif
