// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMRtrixTracksReader
 * @brief   Read the tractograms of MRtrix (.tck).
 *
 * Points are float or double, as in the file, in mm, in the world's coordinates: x to the right, y
 * to the front, z up. Cell data: "TrajectoryId" (vtkIdType), the number of the line in the file,
 * from 0. The format has no other arrays; entries of the header that are not named here are not
 * kept.
 *
 * The header tells the type of the numbers, "datatype: Float32LE", Float32BE, Float64LE or
 * Float64BE (without an ending: LE), and where they begin, "file: . OFFSET". A row of three NaN
 * ends a line, a row of three infinities the file. Lines of one point are kept; a line without
 * points leaves no cell, as the missing TrajectoryId tells.
 *
 * Errors: no such header, or one without these entries; numbers in another file; an offset in the
 * header or beyond the file; a row that is not finite in part; no row of infinities: the file is
 * cut off. Warnings: another number of lines than "count" in the header, which writers may leave
 * behind; bytes behind the row of infinities, which are ignored.
 *
 * Memory: the file and the output.
 *
 * @par Reference
 * MRtrix3's documentation: Tracks file format (.tck).
 *
 * @sa vtkTrackVisReader vtkTRXReader
 */

#ifndef vtkMRtrixTracksReader_h
#define vtkMRtrixTracksReader_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkTrajectoryReader.h"

#include <vector> // for the lines' offsets

VTK_ABI_NAMESPACE_BEGIN
class vtkBinaryFile;

class VTKPELLUCIDFILTERS_EXPORT vtkMRtrixTracksReader : public vtkTrajectoryReader
{
public:
  static vtkMRtrixTracksReader* New();
  vtkTypeMacro(vtkMRtrixTracksReader, vtkTrajectoryReader);

  int CanReadFile(const char* fileName) override;
  const char* GetFileExtensions() override { return ".tck"; }
  const char* GetDescriptiveName() override { return "MRtrix tracks"; }

protected:
  vtkMRtrixTracksReader() = default;
  ~vtkMRtrixTracksReader() override = default;

  void ReadTrajectories(
    const std::string& fileName, vtkInformation* outInfo, vtkPolyData* output) override;

private:
  vtkMRtrixTracksReader(const vtkMRtrixTracksReader&) = delete;
  void operator=(const vtkMRtrixTracksReader&) = delete;

  // Fill `coordinates`, and return where the points of each line begin; nothing if aborted.
  template <typename Array>
  std::vector<vtkIdType> ReadRows(vtkBinaryFile& file, Array* coordinates);
};

VTK_ABI_NAMESPACE_END
#endif
