// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   From inputs to what is drawn: streamlines in place of fields.
 */

#ifndef Drawables_h
#define Drawables_h

#include "InputReader.h"

#include "vtkPolyData.h"

#include <set>    // for names
#include <string> // for names
#include <vector> // for lists

namespace pellucid
{
struct RenderOptions;

/** Name of the point array of importance. */
constexpr const char* ImportanceArray = "Importance";

struct Drawable
{
  std::string Name;                    // of the input
  vtkSmartPointer<vtkDataObject> Data; // vtkPolyData or composite data of it
  std::string Speed;                   // name of the traced vectors; empty: nothing was traced
  std::set<std::string> Computed = {}; // names of arrays that we added
  bool HasImportance = false;          // each part has the point array Importance
  bool IsFaded = false;                // and it is a factor on the opacity
  bool IsSurface = false;              // its parts are surfaces, divided into segments
  bool IsMap = false;                  // x and y are degrees of longitude and latitude

  /** The parts that hold points. */
  std::vector<vtkPolyData*> GetLeaves() const;

  vtkIdType GetNumberOfPoints() const;
  vtkIdType GetNumberOfLines() const;
};

/** The part itself if there is one, else all as blocks. */
vtkSmartPointer<vtkDataObject> JoinParts(const std::vector<vtkDataSet*>& parts);

/** At least one drawable for each input. Throw RenderError for data that cannot be drawn. */
std::vector<Drawable> MakeDrawables(const std::vector<Input>& inputs, const RenderOptions& options);
}

#endif
