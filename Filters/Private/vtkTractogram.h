// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTractogram
 * @brief   What the readers of tractograms have in common: the way to a vtkPolyData.
 *
 * A line of the file that has no points leaves no cell, since few filters expect a line without
 * points; its number is missing in the cell array "TrajectoryId", and its values in all others.
 * An array whose name is taken gets "_2", "_3" and so on appended to it.
 */

#ifndef vtkTractogram_h
#define vtkTractogram_h

#include "vtkArrayNames.h"

#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFieldData;
class vtkIdTypeArray;
class vtkPolyData;

class vtkTractogram
{
public:
  /** For CanReadFile(): what `isOfKind` returns; 0 if there is no name or if it throws. */
  static int Recognize(
    const char* fileName, const std::function<bool(const std::string&)>& isOfKind);

  /**
   * Make the output's points and lines. Points offsets[i] to offsets[i + 1] - 1 are those of line i
   * of the file. Adds the cell array "TrajectoryId" (vtkIdType, that i). Throws
   * vtkTrajectoryFileError if a coordinate is not finite. The coordinates (3 components) are float
   * or double, in mm.
   */
  vtkTractogram(
    vtkPolyData* output, vtkDataArray* coordinates, const std::vector<vtkIdType>& offsets);

  /** Add an array with a tuple for each point. */
  void AddPointArray(vtkDataArray* array);

  /** Add an array with a tuple for each line of the file to the cell data. */
  void AddLineArray(vtkDataArray* array);

  /** Add an array to the field data. */
  void AddFieldArray(vtkDataArray* array);

private:
  static void Add(vtkDataArray* array, vtkFieldData* data, vtkArrayNames& names);

  vtkPolyData* Output;
  vtkIdTypeArray* LineIds; // the output's
  vtkArrayNames PointNames;
  vtkArrayNames LineNames;
  vtkArrayNames FieldNames;
};

VTK_ABI_NAMESPACE_END
#endif
