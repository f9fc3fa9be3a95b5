// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLagrantoText
 * @brief   Trajectories in LAGRANTO's text format, parsed.
 *
 * Private to the module. Time linear in the length of the text, memory of 4 bytes for each number.
 *
 * @sa vtkLagrantoReader
 */

#ifndef vtkLagrantoText_h
#define vtkLagrantoText_h

#include "vtkNew.h"
#include "vtkTrajectorySource.h"

#include <functional>  // for progress
#include <string_view> // for the text

VTK_ABI_NAMESPACE_BEGIN

class vtkLagrantoText : public vtkTrajectorySource
{
public:
  /** Told the part of the text that is parsed, about every hundredth; stops when it returns false.
   */
  using Progress = std::function<bool(double)>;

  /** Throws vtkTrajectoryFileError. After a stop, the trajectories so far. */
  vtkLagrantoText(std::string_view text, const Progress& progress);

  /** Whether a text begins as this format does: names of columns, then a line of dashes. */
  static bool CanRead(std::string_view text);

  vtkIdType GetNumberOfTrajectories() const override;
  vtkIdType GetNumberOfSamples(vtkIdType trajectory) const override;
  Samples Read(std::size_t variable, int member) override;
  Samples ReadTimes() override;

private:
  void ReadRow(std::string_view line, std::size_t lineNumber);
  void FindOrder();
  vtkIdType GetNumberOfBlocks() const { return static_cast<vtkIdType>(this->Blocks->size()) - 1; }
  Samples MakeSamples(vtkDataArray* values, vtkIdType columns, vtkIdType column) const;

  // The first row of each run of rows without a blank line, and behind the last row.
  std::shared_ptr<std::vector<vtkIdType>> Blocks;
  bool IsByTime = false;        // each block holds a time, not a trajectory
  vtkNew<vtkDoubleArray> Times; // of each row
  vtkNew<vtkFloatArray> Values; // of each row, the other columns
};

VTK_ABI_NAMESPACE_END
#endif
