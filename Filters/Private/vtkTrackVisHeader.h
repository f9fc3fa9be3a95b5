// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrackVisHeader
 * @brief   The first 1000 bytes of a TrackVis file, checked.
 *
 * @sa vtkTrackVisReader, which documents the meaning
 */

#ifndef vtkTrackVisHeader_h
#define vtkTrackVisHeader_h

#include "vtkBinaryFile.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkTrackVisHeader
{
public:
  static constexpr std::uint64_t Size = 1000;

  /** Whether these are the first bytes of a TrackVis file. */
  static bool IsBeginning(vtkBinaryFile& file);

  /** Take the header from `file`, whose byte order it sets. Throws vtkTrajectoryFileError. */
  explicit vtkTrackVisHeader(vtkBinaryFile& file);

  /** Some of the floats that a point or a line has. */
  struct Values
  {
    std::string Name;
    int First = 0;
    int Components = 1;
  };

  /** The arrays that all values of a point, or of a line, make; in order, and without a gap. */
  std::vector<Values> Scalars;
  std::vector<Values> Properties;

  /** Values of a point beside its coordinates, and of a line. */
  int NumberOfScalars = 0;
  int NumberOfProperties = 0;

  /** 0: not stored. */
  std::int32_t NumberOfLines = 0;

  /** Rows of the matrix from the coordinates of the file to those of the output. */
  std::array<std::array<double, 4>, 3> Transform = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 },
    { 0, 0, 1, 0 } } };

private:
  void ReadTransform(vtkBinaryFile& file);
};

VTK_ABI_NAMESPACE_END
#endif
