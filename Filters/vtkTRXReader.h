// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTRXReader
 * @brief   Read the tractograms of the TRX format (.trx).
 *
 * The file is a zip archive, stored or deflated, or a folder. Points are float (of float16 or
 * float32) or double (of float64), in mm, in the world's coordinates: x to the right, y to the
 * front, z up.
 *
 *  - Point data: dpv/NAME as NAME.
 *  - Cell data: "TrajectoryId" (vtkIdType), the number of the line in the file, from 0; dps/NAME as
 *    NAME; each group as "groups/NAME" (unsigned char, 1 for its lines, 0 for others).
 *  - Field data: dpg/GROUP/NAME as "dpg/GROUP/NAME", one tuple; "VOXEL_TO_RASMM" (double, 16
 *    components, row after row) and "DIMENSIONS" (double, 3 components) of the header, if it has
 * them.
 *
 * Arrays keep their type; float16 becomes float, and bit (one byte for each value) unsigned char. A
 * name that is taken gets "_2" appended. Lines of one point are kept; a line without points leaves
 * no cell, and its values are dropped, as the missing TrajectoryId tells. JSON files beside the
 * arrays are notes and not read.
 *
 * Errors: no header.json, or one without NB_STREAMLINES and NB_VERTICES; arrays that are missing,
 * have another size than the header tells, or a type that their place does not allow; offsets that
 * do not begin at 0, decrease, or go beyond the points; ids of lines that do not exist; coordinates
 * that are not finite; more than 4096 arrays; an archive that is cut off, declares more than it can
 * hold, is encrypted or otherwise compressed, or whose checksums differ. Warnings: files that are
 * not of the format are not read; groups are not read if, together, they would take more than 16
 * bytes for each byte of the file.
 *
 * Memory: the output, and float16 twice.
 *
 * @par Reference
 * TRX file format specification (tee-ar-ex/trx-spec).
 *
 * @sa vtkTrackVisReader vtkMRtrixTracksReader
 */

#ifndef vtkTRXReader_h
#define vtkTRXReader_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkTrajectoryReader.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDFILTERS_EXPORT vtkTRXReader : public vtkTrajectoryReader
{
public:
  static vtkTRXReader* New();
  vtkTypeMacro(vtkTRXReader, vtkTrajectoryReader);

  int CanReadFile(const char* fileName) override;
  const char* GetFileExtensions() override { return ".trx"; }
  const char* GetDescriptiveName() override { return "TRX tractogram"; }

protected:
  vtkTRXReader() = default;
  ~vtkTRXReader() override = default;

  void ReadTrajectories(
    const std::string& fileName, vtkInformation* outInfo, vtkPolyData* output) override;

private:
  vtkTRXReader(const vtkTRXReader&) = delete;
  void operator=(const vtkTRXReader&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
