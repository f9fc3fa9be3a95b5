// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGeographicTrajectoryReader.h"

#include "Private/vtkGeographicLines.h"
#include "Private/vtkTrajectoryFileError.h"
#include "Private/vtkTrajectoryLines.h"
#include "Private/vtkTrajectorySource.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtksys/SystemTools.hxx"

#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr const char* TimeName = "time";

using Variable = vtkTrajectorySource::Variable;
using Samples = vtkTrajectorySource::Samples;

//------------------------------------------------------------------------------
void Add(vtkDataSetAttributes* attributes, vtkDataArray* array, const std::string& name,
  const std::string& units)
{
  array->SetName(name.c_str());
  if (!units.empty())
  {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
  }
  attributes->AddArray(array);
}

//------------------------------------------------------------------------------
using Units = std::vector<std::pair<const char*, double>>;

//------------------------------------------------------------------------------
// Of a variable without a unit: the first.
double FindUnit(const Variable& variable, const Units& units)
{
  std::string list;
  for (const auto& unit : units)
  {
    if (variable.Units.empty() ||
      vtksys::SystemTools::Strucmp(variable.Units.c_str(), unit.first) == 0)
    {
      return unit.second;
    }
    list += (list.empty() ? "" : ", ") + std::string(unit.first);
  }
  throw vtkTrajectoryFileError("the unit '" + variable.Units + "' of '" + variable.Name +
    "' is not known; expected one of " + list);
}

//------------------------------------------------------------------------------
// In hPa.
double FindPressureUnit(const Variable& variable)
{
  return FindUnit(variable,
    { { "hPa", 1.0 }, { "mbar", 1.0 }, { "mb", 1.0 }, { "millibar", 1.0 }, { "millibars", 1.0 },
      { "Pa", 0.01 }, { "pascal", 0.01 } });
}

//------------------------------------------------------------------------------
// In kilometres.
double FindHeightUnit(const Variable& variable)
{
  return FindUnit(variable,
    { { "m", 0.001 }, { "gpm", 0.001 }, { "meter", 0.001 }, { "meters", 0.001 }, { "metre", 0.001 },
      { "metres", 0.001 }, { "km", 1.0 } });
}

//------------------------------------------------------------------------------
// The parts of the lines with times up to this one.
void ExtractUntil(vtkPolyData* lines, double time, vtkPolyData* output)
{
  vtkDataArray* times = lines->GetPointData()->GetArray(TimeName);
  vtkNew<vtkIdList> points;
  vtkNew<vtkIdList> cells;
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdList> line;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    lines->GetCellPoints(cell, line);
    bool isOpen = false;
    for (const vtkIdType point : *line)
    {
      const bool isKept = times->GetComponent(point, 0) <= time;
      if (isKept && !isOpen)
      {
        offsets->InsertNextValue(points->GetNumberOfIds());
        cells->InsertNextId(cell);
      }
      if (isKept)
      {
        points->InsertNextId(point);
      }
      isOpen = isKept;
    }
  }
  offsets->InsertNextValue(points->GetNumberOfIds());

  vtkNew<vtkPoints> positions;
  positions->SetDataType(lines->GetPoints()->GetDataType());
  positions->SetNumberOfPoints(points->GetNumberOfIds());
  lines->GetPoints()->GetPoints(points, positions);
  vtkTrajectoryLines::SetGeometry(output, positions, offsets);
  output->GetPointData()->CopyAllocate(lines->GetPointData(), points->GetNumberOfIds());
  output->GetPointData()->CopyData(lines->GetPointData(), points);
  output->GetCellData()->CopyAllocate(lines->GetCellData(), cells->GetNumberOfIds());
  output->GetCellData()->CopyData(lines->GetCellData(), cells);
}
}

//------------------------------------------------------------------------------
vtkGeographicTrajectoryReader::vtkGeographicTrajectoryReader() = default;

//------------------------------------------------------------------------------
vtkGeographicTrajectoryReader::~vtkGeographicTrajectoryReader()
{
  this->SetHeightArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkGeographicTrajectoryReader::ReadInformation(
  const std::string& fileName, vtkInformation* outInfo)
{
  this->NumberOfEnsembleMembers = 0;
  this->OpenSource = nullptr;
  outInfo->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  outInfo->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());

  auto source = this->Open(fileName);
  this->NumberOfEnsembleMembers = source->GetNumberOfMembers();
  if (this->EnsembleMember >= this->NumberOfEnsembleMembers)
  {
    throw vtkTrajectoryFileError("EnsembleMember is " + std::to_string(this->EnsembleMember) +
      ", but the file has members 0 to " + std::to_string(this->NumberOfEnsembleMembers - 1));
  }
  const Samples times = source->ReadTimes();
  const std::vector<double> steps =
    vtkTrajectorySource::FindTimeSteps(vtkDoubleArray::SafeDownCast(times.GetValues()));
  if (!steps.empty())
  {
    const double range[2] = { steps.front(), steps.back() };
    outInfo->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    outInfo->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  if (!this->CheckAbort())
  {
    this->OpenSource = std::move(source);
  }
}

//------------------------------------------------------------------------------
void vtkGeographicTrajectoryReader::ReadTrajectories(
  const std::string& fileName, vtkInformation* outInfo, vtkPolyData* output)
{
  auto source = std::move(this->OpenSource);
  if (this->ReadTime < this->GetMTime())
  {
    this->AllTimes->Initialize();
    if (!source)
    {
      source = this->Open(fileName);
    }
    if (!this->ReadAllTimes(*source, this->AllTimes))
    {
      return;
    }
    this->ReadTime.Modified();
  }
  const bool hasRequest = outInfo->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  const double time =
    hasRequest ? outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()) : 0.0;
  if (hasRequest && this->TimeSelection == UNTIL_REQUESTED)
  {
    ExtractUntil(this->AllTimes, time, output);
  }
  else
  {
    output->ShallowCopy(this->AllTimes);
  }
  if (hasRequest)
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkGeographicTrajectoryReader::FindVertical(
  const vtkTrajectorySource& source, bool& isPressure) const
{
  const std::size_t pressure = source.FindPressure();
  isPressure = this->VerticalAxis == LOG_PRESSURE && pressure != vtkTrajectorySource::None;
  if (isPressure)
  {
    return pressure;
  }
  const bool isChosen = this->HeightArray && *this->HeightArray;
  const std::size_t height = isChosen ? source.Find(this->HeightArray) : source.FindHeight();
  if (height == vtkTrajectorySource::None)
  {
    throw vtkTrajectoryFileError(
      (isChosen ? "there is no variable '" + std::string(this->HeightArray) + "' to take as height"
          : pressure != vtkTrajectorySource::None
          ? std::string("no variable is known as height; set HeightArray or take LOG_PRESSURE")
          : std::string("no variable is known as pressure or height; set HeightArray")) +
      ". The variables are " + source.ListVariables());
  }
  return height;
}

//------------------------------------------------------------------------------
bool vtkGeographicTrajectoryReader::ReadAllTimes(vtkTrajectorySource& source, vtkPolyData* output)
{
  const auto& variables = source.GetVariables();
  bool isPressure = true;
  const std::size_t vertical = this->FindVertical(source, isPressure);
  const vtkGeographicLines::VerticalAxis axis{ isPressure,
    isPressure ? FindPressureUnit(variables[vertical]) : FindHeightUnit(variables[vertical]),
    this->VerticalScale > 0.0 ? this->VerticalScale
      : isPressure            ? 10.0
                              : 1.0 };
  if (this->CheckAbort())
  {
    return false;
  }

  const int member = this->EnsembleMember;
  const vtkGeographicLines::Coordinates coordinates{ source.Read(
                                                       vtkTrajectorySource::Longitude, member),
    source.Read(vtkTrajectorySource::Latitude, member), source.Read(vertical, member) };
  const vtkGeographicLines lines(
    source, coordinates, { this->LongitudeMode == CUT, this->CentralLongitude }, axis);
  if (lines.GetNumberOfInvalidSamples() > 0)
  {
    vtkWarningMacro(<< this->GetFileName() << ": " << lines.GetNumberOfInvalidSamples()
                    << " positions have a pressure of 0 or less, a latitude beyond the poles, a "
                       "longitude beyond 36000 degrees, or a height beyond the floats; they are "
                       "taken as gaps.");
  }
  if (lines.GetNumberOfLines() == 0)
  {
    vtkWarningMacro(<< this->GetFileName()
                    << ": all positions are missing values; there is no line.");
  }
  lines.MakeGeometry(output);

  const double start = this->GetOpeningShare();
  for (std::size_t i = 0; i < variables.size() && !this->CheckAbort(); ++i)
  {
    const Samples samples = i == vtkTrajectorySource::Longitude ? coordinates.Longitude
      : i == vtkTrajectorySource::Latitude                      ? coordinates.Latitude
      : i == vertical                                           ? coordinates.Vertical
                                                                : source.Read(i, member);
    if (variables[i].PerTrajectory)
    {
      Add(
        output->GetCellData(), lines.MakeCellArray(samples), variables[i].Name, variables[i].Units);
    }
    else
    {
      Add(output->GetPointData(),
        lines.MakePointArray(samples, i == vtkTrajectorySource::Longitude), variables[i].Name,
        variables[i].Units);
    }
    this->UpdateProgress(
      start + (1.0 - start) * static_cast<double>(i + 1) / static_cast<double>(variables.size()));
  }
  Add(output->GetPointData(), lines.MakePointArray(source.ReadTimes()), TimeName,
    source.GetTimeUnits());
  if (!source.GetTimeWarning().empty())
  {
    vtkWarningMacro(<< this->GetFileName() << ": " << source.GetTimeWarning() << ".");
  }
  return !this->CheckAbort();
}

//------------------------------------------------------------------------------
void vtkGeographicTrajectoryReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EnsembleMember: " << this->EnsembleMember << "\n";
  os << indent << "NumberOfEnsembleMembers: " << this->NumberOfEnsembleMembers << "\n";
  os << indent << "VerticalAxis: " << this->VerticalAxis << "\n";
  os << indent << "HeightArray: " << (this->HeightArray ? this->HeightArray : "(none)") << "\n";
  os << indent << "VerticalScale: " << this->VerticalScale << "\n";
  os << indent << "LongitudeMode: " << this->LongitudeMode << "\n";
  os << indent << "CentralLongitude: " << this->CentralLongitude << "\n";
  os << indent << "TimeSelection: " << this->TimeSelection << "\n";
}

VTK_ABI_NAMESPACE_END
