// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNetCDFTrajectories.h"

#include "vtkArrayNames.h"
#include "vtkLagrantoConventions.h"
#include "vtkTrajectoryFileError.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
bool Contains(const std::vector<int>& dimensions, int dimension)
{
  return std::find(dimensions.begin(), dimensions.end(), dimension) != dimensions.end();
}

//------------------------------------------------------------------------------
bool HasDuplicates(std::vector<int> dimensions)
{
  std::sort(dimensions.begin(), dimensions.end());
  return std::adjacent_find(dimensions.begin(), dimensions.end()) != dimensions.end();
}

//------------------------------------------------------------------------------
const char* GetReader(vtkNetCDFTrajectories::Layout layout)
{
  return layout == vtkNetCDFTrajectories::Layout::Met3D ? "vtkMet3DReader"
                                                        : "vtkLagrantoNetCDFReader";
}
}

//------------------------------------------------------------------------------
vtkNetCDFTrajectories::vtkNetCDFTrajectories(const std::string& fileName, Layout layout)
  : File(fileName)
  , FileLayout(layout)
{
  this->FindCoordinates();
  this->FindDimensions();
  const Layout found = this->GetLayout();
  if (found != layout)
  {
    throw vtkTrajectoryFileError(std::string("has trajectories in another layout; read it with ") +
      GetReader(found) + " instead of " + GetReader(layout));
  }
  this->FindVariables();
  this->SetTimeUnits();

  const vtkIdType trajectories = this->GetNumberOfTrajectories();
  const vtkIdType times = this->GetNumberOfSamples(0);
  if (trajectories == 0 || times == 0 || this->GetNumberOfMembers() == 0)
  {
    throw vtkTrajectoryFileError("the file holds no positions: " + std::to_string(trajectories) +
      " trajectories, " + std::to_string(times) + " times, " +
      std::to_string(this->GetNumberOfMembers()) + " members");
  }
}

//------------------------------------------------------------------------------
bool vtkNetCDFTrajectories::CanRead(const char* fileName, Layout layout)
{
  if (!fileName || !vtksys::SystemTools::FileExists(fileName, true))
  {
    return false;
  }
  try
  {
    const vtkNetCDFTrajectories file(fileName, layout);
    return file.FindPressure() != None || file.FindHeight() != None;
  }
  catch (const std::exception&)
  {
    return false;
  }
}

//------------------------------------------------------------------------------
// The variable of one of the names or else of the standard name.
const vtkNetCDFFile::Variable* vtkNetCDFTrajectories::Find(const char* standardName,
  const std::vector<std::string>& names, std::size_t minimumRank, std::size_t maximumRank) const
{
  const auto& variables = this->File.GetVariables();
  const auto find = [&](const auto& isWanted) -> const FileVariable*
  {
    const auto found = std::find_if(variables.begin(), variables.end(),
      [&](const FileVariable& variable)
      {
        const std::size_t rank = variable.Dimensions.size();
        return rank >= minimumRank && rank <= maximumRank && isWanted(variable);
      });
    return found == variables.end() ? nullptr : &*found;
  };
  for (const std::string& name : names)
  {
    if (const auto* found =
          find([&](const FileVariable& variable) { return variable.Name == name; }))
    {
      return found;
    }
  }
  return find([&](const FileVariable& variable)
    { return this->File.GetText(variable.Id, "standard_name") == standardName; });
}

//------------------------------------------------------------------------------
void vtkNetCDFTrajectories::ThrowNoTrajectories() const
{
  throw vtkTrajectoryFileError(
    "has no trajectories: expected a variable 'time' over the times, and "
    "'lon' and 'lat' over trajectories and times; found " +
      this->File.ListVariables(),
    vtkErrorCode::UnrecognizedFileTypeError);
}

//------------------------------------------------------------------------------
void vtkNetCDFTrajectories::FindCoordinates()
{
  const std::string featureType =
    vtksys::SystemTools::LowerCase(this->File.GetText(vtkNetCDFFile::Global, "featureType"));
  this->Time = this->Find("time", { "time" }, 1, 1);
  this->Longitude = this->Find("longitude", { "lon", "longitude" }, 2, 3);
  this->Latitude = this->Find("latitude", { "lat", "latitude" }, 2, 3);
  if (!this->Time || !this->Longitude || !this->Latitude ||
    this->Longitude->Dimensions != this->Latitude->Dimensions ||
    HasDuplicates(this->Longitude->Dimensions) ||
    !Contains(this->Longitude->Dimensions, this->Time->Dimensions[0]) ||
    (!featureType.empty() && featureType != "trajectory"))
  {
    this->ThrowNoTrajectories();
  }
}

//------------------------------------------------------------------------------
void vtkNetCDFTrajectories::FindDimensions()
{
  std::vector<int> others = this->Longitude->Dimensions;
  this->TimeDimension = this->Time->Dimensions[0];
  others.erase(std::find(others.begin(), others.end(), this->TimeDimension));
  if (others.size() == 2)
  {
    const auto isMember = [this](int dimension)
    {
      const std::string name =
        vtksys::SystemTools::LowerCase(this->File.GetDimensionName(dimension));
      return name.rfind("ens", 0) == 0 || name == "member" || name == "realization";
    };
    auto member = std::find_if(others.begin(), others.end(), isMember);
    if (member == others.end())
    {
      // A grid that moves with time has three dimensions too.
      if (this->Longitude->Dimensions.back() != this->TimeDimension)
      {
        this->ThrowNoTrajectories();
      }
      member = others.begin();
    }
    this->MemberDimension = *member;
    others.erase(member);
  }
  this->TrajectoryDimension = others[0];
}

//------------------------------------------------------------------------------
vtkNetCDFTrajectories::Layout vtkNetCDFTrajectories::GetLayout() const
{
  const bool isTimeFirst = this->Longitude->Dimensions[0] == this->TimeDimension;
  const bool hasReferenceDate = !this->File.GetNumbers(vtkNetCDFFile::Global, "ref_year").empty();
  return this->MemberDimension < 0 && (isTimeFirst || hasReferenceDate) ? Layout::Lagranto
                                                                        : Layout::Met3D;
}

//------------------------------------------------------------------------------
void vtkNetCDFTrajectories::FindVariables()
{
  this->FileVariables = { *this->Longitude, *this->Latitude };
  for (const FileVariable& variable : this->File.GetVariables())
  {
    const bool isKnown = std::all_of(variable.Dimensions.begin(), variable.Dimensions.end(),
      [this](int dimension)
      {
        return dimension == this->TimeDimension || dimension == this->TrajectoryDimension ||
          dimension == this->MemberDimension;
      });
    const bool isOfTrajectories = Contains(variable.Dimensions, this->TimeDimension) ||
      Contains(variable.Dimensions, this->TrajectoryDimension);
    const bool isCoordinate = variable.Id == this->Time->Id || variable.Id == this->Longitude->Id ||
      variable.Id == this->Latitude->Id;
    if (isKnown && isOfTrajectories && !isCoordinate && !HasDuplicates(variable.Dimensions))
    {
      this->FileVariables.push_back(variable);
    }
  }
  vtkArrayNames::RequireNumber(this->FileVariables.size());
  this->File.CheckSize(this->FileVariables);
  this->File.CheckSize({ *this->Time });

  for (const FileVariable& variable : this->FileVariables)
  {
    std::string units = this->File.GetText(variable.Id, "units");
    if (units.empty() && this->FileLayout == Layout::Lagranto)
    {
      units = vtkLagrantoConventions::GetUnits(variable.Name);
    }
    this->Variables.push_back({ variable.Name, this->File.GetText(variable.Id, "standard_name"),
      units, !Contains(variable.Dimensions, this->TimeDimension) });
  }
}

//------------------------------------------------------------------------------
void vtkNetCDFTrajectories::SetTimeUnits()
{
  this->TimeUnits = this->File.GetText(this->Time->Id, "units");
  if (this->TimeUnits.empty() && this->FileLayout == Layout::Lagranto)
  {
    const auto get = [this](const char* name)
    {
      const auto numbers = this->File.GetNumbers(vtkNetCDFFile::Global, name);
      return numbers.empty() ? -1.0 : numbers[0];
    };
    this->TimeUnits = vtkLagrantoConventions::GetTimeUnits(
      get("ref_year"), get("ref_month"), get("ref_day"), get("ref_hour"), get("ref_min"));
  }
}

//------------------------------------------------------------------------------
int vtkNetCDFTrajectories::GetNumberOfMembers() const
{
  return this->MemberDimension < 0 ? 1
                                   : static_cast<int>(this->File.GetLength(this->MemberDimension));
}

//------------------------------------------------------------------------------
vtkIdType vtkNetCDFTrajectories::GetNumberOfTrajectories() const
{
  return static_cast<vtkIdType>(this->File.GetLength(this->TrajectoryDimension));
}

//------------------------------------------------------------------------------
vtkIdType vtkNetCDFTrajectories::GetNumberOfSamples(vtkIdType) const
{
  return static_cast<vtkIdType>(this->File.GetLength(this->TimeDimension));
}

//------------------------------------------------------------------------------
vtkTrajectorySource::Samples vtkNetCDFTrajectories::Read(std::size_t variable, int member)
{
  return this->ReadVariable(this->FileVariables[variable], static_cast<std::size_t>(member));
}

//------------------------------------------------------------------------------
vtkTrajectorySource::Samples vtkNetCDFTrajectories::ReadVariable(
  const FileVariable& variable, std::size_t member)
{
  const std::size_t rank = variable.Dimensions.size();
  std::vector<std::size_t> start(rank, 0);
  std::vector<std::size_t> count(rank, 1);
  vtkIdType trajectoryStride = 0;
  vtkIdType sampleStride = 0;
  vtkIdType stride = 1;
  for (std::size_t i = rank; i-- > 0;)
  {
    const int dimension = variable.Dimensions[i];
    if (dimension == this->MemberDimension)
    {
      start[i] = member;
      continue;
    }
    (dimension == this->TimeDimension ? sampleStride : trajectoryStride) = stride;
    count[i] = this->File.GetLength(dimension);
    stride *= static_cast<vtkIdType>(count[i]);
  }
  std::vector<double> missing;
  if (this->FileLayout == Layout::Lagranto)
  {
    missing.push_back(vtkLagrantoConventions::MissingValue);
  }
  return { this->File.Read(variable, start, count, missing), trajectoryStride, sampleStride };
}

//------------------------------------------------------------------------------
vtkTrajectorySource::Samples vtkNetCDFTrajectories::ReadTimes()
{
  const Samples read = this->ReadVariable(*this->Time, 0);
  vtkNew<vtkDoubleArray> times;
  times->DeepCopy(read.GetValues());
  if (this->FileLayout == Layout::Lagranto && this->File.GetText(this->Time->Id, "units").empty())
  {
    this->TimeWarning = vtkLagrantoConventions::ConvertToHours(times);
  }
  return { times, 0, 1 };
}

VTK_ABI_NAMESPACE_END
