// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrackVisReader
 * @brief   Read the tractograms of TrackVis (.trk).
 *
 * Points are float, in mm. Where the header has the matrix vox_to_ras (version 2 or later, and its
 * last element is not 0), they are in the world's coordinates, x to the right, y to the front, z
 * up, with the centre of voxel (0, 0, 0) where the matrix puts it; axes of voxel_order that the
 * matrix names otherwise are permuted and flipped (no voxel_order means LPS). Without the matrix
 * the points stay as they are in the file: voxel-millimetres, whose origin is the corner of the
 * first voxel.
 *
 * Point data: the scalars of the header, float. Cell data: its properties, float, and
 * "TrajectoryId" (vtkIdType), the number of the line in the file, from 0. A name followed by a zero
 * byte and a number, as NiBabel writes it, is one array of that many components. Values behind the
 * last name are one array "scalars" or "properties"; an unnamed value before a named one is
 * "scalars_N" or "properties_N", where N is its number, from 0. A name that is taken gets "_2"
 * appended. Both byte orders are read. Lines of one point are kept; a line without points leaves no
 * cell, and its properties are dropped, as the missing TrajectoryId tells.
 *
 * Errors: not a TrackVis file or not version 1 to 3; a header that contradicts itself; negative
 * counts; a file that ends within a line or before n_count lines (0: up to the end of the file), or
 * goes on behind them; coordinates that are not finite.
 *
 * Memory: the file and the output.
 *
 * @par Reference
 * TrackVis: TrackVis file format, version 2.
 *
 * @sa vtkMRtrixTracksReader vtkTRXReader
 */

#ifndef vtkTrackVisReader_h
#define vtkTrackVisReader_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkTrajectoryReader.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDFILTERS_EXPORT vtkTrackVisReader : public vtkTrajectoryReader
{
public:
  static vtkTrackVisReader* New();
  vtkTypeMacro(vtkTrackVisReader, vtkTrajectoryReader);

  int CanReadFile(const char* fileName) override;
  const char* GetFileExtensions() override { return ".trk"; }
  const char* GetDescriptiveName() override { return "TrackVis"; }

protected:
  vtkTrackVisReader() = default;
  ~vtkTrackVisReader() override = default;

  void ReadTrajectories(
    const std::string& fileName, vtkInformation* outInfo, vtkPolyData* output) override;

private:
  vtkTrackVisReader(const vtkTrackVisReader&) = delete;
  void operator=(const vtkTrackVisReader&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
