// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLagrantoReader
 * @brief   Read trajectories from text files of LAGRANTO.
 *
 * The text begins with the reference date, the names of the columns (time, lon, lat, p or z, and
 * traced variables) and a line of dashes. Trajectories are separated by blank lines; in files
 * sorted by time, in which all rows between two blank lines have the same time, the times are.
 * Lines may be of any length and end with LF or CR LF. Columns of the same name get "_2", "_3" and
 * so on.
 *
 * After "Reference date YYYYMMDD_HHMM / Time range N min", times are in hh.mm: the fraction is
 * minutes, and "time" has hours in decimals, negative in backward trajectories. Times whose
 * fractions would be 60 minutes or more, or whose steps are more even in decimals (0, 0.5, 1), are
 * in decimals already, with a warning. After "time period YYYYMMDD HH UTC", in older files, they
 * are in decimals. The unit of "time" is "hours since" that date.
 * Longitude and latitude are in degrees, p in hPa and z in m; the text tells no other units.
 *
 * The value -999.99, NaN and numbers that did not fit their column (asterisks) are missing.
 *
 * Errors: no such header; a row with more or fewer columns than names, a word that is not a number
 * (the message tells the line); no row at all; times of different numbers of rows.
 *
 * The text is read and parsed once, by UpdateInformation(). Memory: the text while it is parsed,
 * and 4 bytes for each number until the update has ended, besides the output.
 *
 * @par Reference
 * M. Sprenger, H. Wernli: The LAGRANTO Lagrangian analysis tool - version 2.0. Geoscientific
 * Model Development 8, 2015.
 *
 * @sa vtkGeographicTrajectoryReader vtkLagrantoNetCDFReader
 */

#ifndef vtkLagrantoReader_h
#define vtkLagrantoReader_h

#include "vtkGeographicTrajectoryReader.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDFILTERS_EXPORT vtkLagrantoReader : public vtkGeographicTrajectoryReader
{
public:
  static vtkLagrantoReader* New();
  vtkTypeMacro(vtkLagrantoReader, vtkGeographicTrajectoryReader);

  int CanReadFile(const char* fileName) override;
  const char* GetFileExtensions() override { return ".lsl .1 .2 .tim .txt"; }
  const char* GetDescriptiveName() override { return "LAGRANTO trajectories (text)"; }

protected:
  vtkLagrantoReader() = default;
  ~vtkLagrantoReader() override = default;

  std::unique_ptr<vtkTrajectorySource> Open(const std::string& fileName) override;
  double GetOpeningShare() const override { return 0.9; }

private:
  vtkLagrantoReader(const vtkLagrantoReader&) = delete;
  void operator=(const vtkLagrantoReader&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
