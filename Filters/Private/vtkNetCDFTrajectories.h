// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNetCDFTrajectories
 * @brief   Trajectories in a NetCDF file, in the layout of Met.3D or of LAGRANTO.
 *
 * Private to the module. Recognised are files with a variable "time" of one dimension and variables
 * "lon" and "lat" (or others with the standard names) of the same two or three dimensions, that of
 * the time among them; a second one counts the trajectories, a third one the members of an
 * ensemble. LAGRANTO's are those of two dimensions with the time first or with the global attribute
 * "ref_year"; all others are Met.3D's. The names of dimensions do not matter, but for telling
 * members from trajectories where the time does not come last.
 *
 * @sa vtkMet3DReader vtkLagrantoNetCDFReader
 */

#ifndef vtkNetCDFTrajectories_h
#define vtkNetCDFTrajectories_h

#include "vtkNetCDFFile.h"
#include "vtkTrajectorySource.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkNetCDFTrajectories : public vtkTrajectorySource
{
public:
  enum class Layout
  {
    Met3D,
    Lagranto
  };

  /** Throws unless the file has trajectories in this layout. */
  vtkNetCDFTrajectories(const std::string& fileName, Layout layout);

  /** Whether the file has trajectories in this layout, and pressure or height of them. */
  static bool CanRead(const char* fileName, Layout layout);

  int GetNumberOfMembers() const override;
  vtkIdType GetNumberOfTrajectories() const override;
  vtkIdType GetNumberOfSamples(vtkIdType trajectory) const override;
  Samples Read(std::size_t variable, int member) override;
  Samples ReadTimes() override;

private:
  using FileVariable = vtkNetCDFFile::Variable;

  const FileVariable* Find(const char* standardName, const std::vector<std::string>& names,
    std::size_t minimumRank, std::size_t maximumRank) const;
  [[noreturn]] void ThrowNoTrajectories() const;
  void FindCoordinates();
  void FindDimensions();
  void FindVariables();
  Layout GetLayout() const;
  void SetTimeUnits();
  Samples ReadVariable(const FileVariable& variable, std::size_t member);

  vtkNetCDFFile File;
  Layout FileLayout;
  const FileVariable* Time = nullptr;
  const FileVariable* Longitude = nullptr;
  const FileVariable* Latitude = nullptr;
  int TimeDimension = -1;
  int TrajectoryDimension = -1;
  int MemberDimension = -1;                // -1: none
  std::vector<FileVariable> FileVariables; // parallel to Variables
};

VTK_ABI_NAMESPACE_END
#endif
