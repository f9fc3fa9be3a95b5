// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectorySource
 * @brief   An open file of geographic trajectories: what it holds, and its values on demand.
 *
 * Private to the module. A file has trajectories of samples, each sample at a time, and variables
 * that have one value for each sample or for each trajectory. Everything throws
 * vtkTrajectoryFileError.
 *
 * @sa vtkGeographicTrajectoryReader vtkGeographicLines
 */

#ifndef vtkTrajectorySource_h
#define vtkTrajectorySource_h

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

#include <memory> // for the shared rows
#include <string> // for names
#include <vector> // for the variables

VTK_ABI_NAMESPACE_BEGIN

class vtkTrajectorySource
{
public:
  struct Variable
  {
    std::string Name;
    std::string StandardName; // of the CF conventions; empty: none
    std::string Units;        // empty: none
    bool PerTrajectory = false;
  };

  /** The values of one variable in the order of the file; a missing one is NaN. */
  class Samples
  {
  public:
    /** Those of a variable whose values lie evenly in `values`, vtkFloatArray or vtkDoubleArray. */
    Samples(vtkDataArray* values, vtkIdType trajectoryStride, vtkIdType sampleStride,
      vtkIdType offset = 0)
      : Values(values)
      , TrajectoryStride(trajectoryStride)
      , SampleStride(sampleStride)
      , Offset(offset)
    {
      auto* floats = vtkFloatArray::SafeDownCast(values);
      auto* doubles = vtkDoubleArray::SafeDownCast(values);
      this->Floats = floats ? floats->GetPointer(0) : nullptr;
      this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
    }

    /** The same with trajectories that begin at any multiple of the stride, not at their number. */
    void SetStarts(const std::shared_ptr<const std::vector<vtkIdType>>& starts)
    {
      this->Starts = starts;
    }

    vtkIdType GetIndex(vtkIdType trajectory, vtkIdType sample) const
    {
      const vtkIdType start = this->Starts ? (*this->Starts)[trajectory] : trajectory;
      return this->Offset + start * this->TrajectoryStride + sample * this->SampleStride;
    }

    double Get(vtkIdType trajectory, vtkIdType sample) const
    {
      const vtkIdType index = this->GetIndex(trajectory, sample);
      return this->Floats ? this->Floats[index] : this->Doubles[index];
    }

    vtkDataArray* GetValues() const { return this->Values; }
    bool IsDouble() const { return this->Doubles != nullptr; }

  private:
    vtkSmartPointer<vtkDataArray> Values;
    const float* Floats;
    const double* Doubles;
    vtkIdType TrajectoryStride;
    vtkIdType SampleStride;
    vtkIdType Offset;
    std::shared_ptr<const std::vector<vtkIdType>> Starts;
  };

  virtual ~vtkTrajectorySource() = default;

  virtual int GetNumberOfMembers() const { return 1; }
  virtual vtkIdType GetNumberOfTrajectories() const = 0;
  virtual vtkIdType GetNumberOfSamples(vtkIdType trajectory) const = 0;

  /** Longitude and latitude first, then all others but time. */
  const std::vector<Variable>& GetVariables() const { return this->Variables; }

  /** The values of a variable for one member of the ensemble; of variables per trajectory at sample
   * 0. */
  virtual Samples Read(std::size_t variable, int member) = 0;

  /** Double precision. */
  virtual Samples ReadTimes() = 0;

  /** The different finite times, in ascending order. */
  static std::vector<double> FindTimeSteps(vtkDoubleArray* times);

  /** Such as "hours since 2011-01-15 12:00:00"; empty: not known. */
  const std::string& GetTimeUnits() const { return this->TimeUnits; }

  /** What about the times, once read, may surprise; empty: nothing. */
  const std::string& GetTimeWarning() const { return this->TimeWarning; }

  static constexpr std::size_t Longitude = 0;
  static constexpr std::size_t Latitude = 1;
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  ///@{
  /**
   * The variable that is pressure or height by its standard name or, where none says so, by a
   * usual name; None.
   */
  std::size_t FindPressure() const;
  std::size_t FindHeight() const;
  ///@}

  /** The variable per sample of a name; None. */
  std::size_t Find(const std::string& name) const;

  /** "lon, lat, p": the names of the variables per sample. */
  std::string ListVariables() const;

protected:
  std::vector<Variable> Variables;
  std::string TimeUnits;
  std::string TimeWarning;

private:
  std::size_t FindAny(
    const std::vector<std::string>& standardNames, const std::vector<std::string>& names) const;
};

VTK_ABI_NAMESPACE_END
#endif
