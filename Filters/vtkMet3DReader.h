// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMet3DReader
 * @brief   Read trajectories from NetCDF files in the layout of Met.3D.
 *
 * The file has the variables time(time), lon, lat and pressure(ensemble, trajectory, time), or
 * others with the standard names time, longitude, latitude and air_pressure; the ensemble may lack,
 * and so may the pressure where there is a height. All further variables over these dimensions are
 * read, whether marked as auxiliary_data or not. Dimensions are recognised by what lies over them:
 * that of "time" counts the times, and where there are three, the one whose name begins with "ens"
 * or is "member" or "realization" counts the members, else the first. Of files in which time comes
 * first and that have no ensemble, vtkLagrantoNetCDFReader is the reader.
 *
 * Times are given in the unit of the file, such as "hours since 2011-01-15 12:00:00".
 *
 * Files of NetCDF-3 (CDF-1, CDF-2, CDF-5) and NetCDF-4 are read, one variable of one member at a
 * time. The NetCDF library, and below it HDF5, decodes them: a damaged file of NetCDF-4 is as safe
 * to open as that library.
 *
 * @par Reference
 * Met.3D user documentation, "Trajectory data in NetCDF format", University of Hamburg,
 * https://collaboration.cen.uni-hamburg.de/display/Met3D/Trajectory+data+in+NetCDF+format, of which
 * more files are read here than it allows; and the CF conventions for the standard names.
 *
 * @sa vtkGeographicTrajectoryReader
 */

#ifndef vtkMet3DReader_h
#define vtkMet3DReader_h

#include "vtkGeographicTrajectoryReader.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDFILTERS_EXPORT vtkMet3DReader : public vtkGeographicTrajectoryReader
{
public:
  static vtkMet3DReader* New();
  vtkTypeMacro(vtkMet3DReader, vtkGeographicTrajectoryReader);

  int CanReadFile(const char* fileName) override;
  const char* GetFileExtensions() override { return ".nc .nc4 .cdf"; }
  const char* GetDescriptiveName() override { return "Met.3D trajectories"; }

protected:
  vtkMet3DReader() = default;
  ~vtkMet3DReader() override = default;

  std::unique_ptr<vtkTrajectorySource> Open(const std::string& fileName) override;

private:
  vtkMet3DReader(const vtkMet3DReader&) = delete;
  void operator=(const vtkMet3DReader&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
