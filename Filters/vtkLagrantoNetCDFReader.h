// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLagrantoNetCDFReader
 * @brief   Read trajectories from NetCDF files of LAGRANTO.
 *
 * The file has the variables time(ntim), lon, lat and p(ntim, ntra), or longitude, latitude and z
 * as COSMO writes them; the names of the dimensions do not matter. All further variables over these
 * dimensions are read.
 *
 * A time variable without a unit is in hh.mm, as LAGRANTO writes it: the fraction is minutes, and
 * "time" has hours in decimals, negative in backward trajectories. Times whose fractions would be
 * 60 minutes or more, or whose steps are more even in decimals (0, 0.5, 1), are in decimals
 * already, with a warning. The unit of "time" is "hours since" the reference date in the attributes
 * ref_year, ref_month, ref_day, ref_hour and ref_min. Longitude and latitude without a unit are in
 * degrees, p in hPa and z in m. The value -999.99 is missing.
 *
 * @par Reference
 * M. Sprenger, H. Wernli: The LAGRANTO Lagrangian analysis tool - version 2.0. Geoscientific
 * Model Development 8, 2015.
 *
 * @sa vtkGeographicTrajectoryReader vtkLagrantoReader
 */

#ifndef vtkLagrantoNetCDFReader_h
#define vtkLagrantoNetCDFReader_h

#include "vtkGeographicTrajectoryReader.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDFILTERS_EXPORT vtkLagrantoNetCDFReader : public vtkGeographicTrajectoryReader
{
public:
  static vtkLagrantoNetCDFReader* New();
  vtkTypeMacro(vtkLagrantoNetCDFReader, vtkGeographicTrajectoryReader);

  int CanReadFile(const char* fileName) override;
  const char* GetFileExtensions() override { return ".nc .4 .cdf"; }
  const char* GetDescriptiveName() override { return "LAGRANTO trajectories (NetCDF)"; }

protected:
  vtkLagrantoNetCDFReader() = default;
  ~vtkLagrantoNetCDFReader() override = default;

  std::unique_ptr<vtkTrajectorySource> Open(const std::string& fileName) override;

private:
  vtkLagrantoNetCDFReader(const vtkLagrantoNetCDFReader&) = delete;
  void operator=(const vtkLagrantoNetCDFReader&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
