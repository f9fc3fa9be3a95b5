// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryAttributes.h"

#include "Private/vtkBatches.h"
#include "Private/vtkFieldVectors.h"
#include "Private/vtkFillOutput.h"
#include "Private/vtkPolylineAttributes.h"
#include "Private/vtkPolylineRanges.h"
#include "Private/vtkPolylines.h"
#include "Private/vtkTrajectoryParts.h"
#include "Private/vtkUnsharedPoints.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectoryAttributes);

namespace
{
using Self = vtkTrajectoryAttributes;

// Part of the progress that the attributes of points are.
constexpr double PointsProgress = 0.9;

enum class Role
{
  None,
  Pressure,
  Time
};

struct AttributeInformation
{
  const char* Name;
  int Association;
  Role Needs;
};

// In the order of vtkTrajectoryAttributes::Attributes.
constexpr AttributeInformation Catalogue[Self::NUMBER_OF_ATTRIBUTES] = {
  { "TotalPressureDifference", vtkDataObject::CELL, Role::Pressure },
  { "SegmentPressureDifference", vtkDataObject::POINT, Role::Pressure },
  { "SegmentHeightDifference", vtkDataObject::POINT, Role::None },
  { "TurningAngle", vtkDataObject::POINT, Role::None },
  { "Curvature", vtkDataObject::POINT, Role::None },
  { "SegmentLength", vtkDataObject::POINT, Role::None },
  { "Velocity", vtkDataObject::POINT, Role::Time },
  { "AngleOfAscent", vtkDataObject::POINT, Role::None },
};

const std::vector<std::string> PressureNames = { "pressure", "p", "air_pressure" };
const std::vector<std::string> TimeNames = { "time", "integrationtime" };

//------------------------------------------------------------------------------
bool IsAttribute(int attribute)
{
  return attribute >= 0 && attribute < Self::NUMBER_OF_ATTRIBUTES;
}

//------------------------------------------------------------------------------
std::string DescribeArrays(vtkPolyData* input)
{
  return " The input has the arrays (association, components): " +
    vtkFieldVectors::ListArrays(input) + ".";
}

//------------------------------------------------------------------------------
bool IsUsable(vtkPolyData* input, vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() >= input->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
// The array of that name; throws if there is none and the input has any points.
vtkDataArray* FindNamed(vtkPolyData* input, const std::string& name, const char* role)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!IsUsable(input, array) && input->GetNumberOfPoints() > 0)
  {
    throw std::invalid_argument("No point array named '" + name +
      "' has one component and a value for each point, as the " + role + " needs." +
      DescribeArrays(input));
  }
  return array;
}

//------------------------------------------------------------------------------
// The first usable array with one of these names, which are in small letters, or null.
vtkDataArray* FindWellKnown(vtkPolyData* input, const std::vector<std::string>& names)
{
  vtkPointData* pointData = input->GetPointData();
  for (const std::string& name : names)
  {
    for (int i = 0; i < pointData->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = pointData->GetArray(i);
      if (IsUsable(input, array) && array->GetName() &&
        vtksys::SystemTools::LowerCase(array->GetName()) == name)
      {
        return array;
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> MakeArray(int attribute, vtkIdType count, const char* unit)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(Catalogue[attribute].Name);
  array->SetNumberOfValues(count);
  if (unit)
  {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
  }
  return array;
}

//------------------------------------------------------------------------------
void FillWithMissing(vtkFloatArray* array)
{
  float* values = array->GetPointer(0);
  vtkSMPTools::Fill(
    values, values + array->GetNumberOfValues(), std::numeric_limits<float>::quiet_NaN());
}

//------------------------------------------------------------------------------
const char* GetUnit(vtkDataArray* array)
{
  return array && array->HasInformation()
    ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL())
    : nullptr;
}
}

//------------------------------------------------------------------------------
struct vtkTrajectoryAttributes::Arrays
{
  // An attribute of the same name takes their place in the output while they are needed.
  vtkSmartPointer<vtkDataArray> Pressure;
  vtkSmartPointer<vtkDataArray> Height; // null: the coordinate along UpAxis
  vtkSmartPointer<vtkDataArray> Time;
  bool IsComputed[NUMBER_OF_ATTRIBUTES];

  const char* GetUnitOf(int attribute) const
  {
    switch (attribute)
    {
      case TOTAL_PRESSURE_DIFFERENCE:
      case SEGMENT_PRESSURE_DIFFERENCE:
        return GetUnit(this->Pressure);
      case SEGMENT_HEIGHT_DIFFERENCE:
        return GetUnit(this->Height);
      case TURNING_ANGLE:
      case ANGLE_OF_ASCENT:
        return "degree";
      default:
        return nullptr;
    }
  }
};

//------------------------------------------------------------------------------
vtkTrajectoryAttributes::vtkTrajectoryAttributes()
{
  this->Statuses.fill(AUTOMATIC);
}

//------------------------------------------------------------------------------
const char* vtkTrajectoryAttributes::GetAttributeName(int attribute)
{
  return IsAttribute(attribute) ? Catalogue[attribute].Name : nullptr;
}

//------------------------------------------------------------------------------
int vtkTrajectoryAttributes::GetAttributeAssociation(int attribute)
{
  return IsAttribute(attribute) ? Catalogue[attribute].Association : -1;
}

//------------------------------------------------------------------------------
int vtkTrajectoryAttributes::GetAttributeIndex(const char* name)
{
  for (int attribute = 0; name && attribute < NUMBER_OF_ATTRIBUTES; ++attribute)
  {
    if (!std::strcmp(name, Catalogue[attribute].Name))
    {
      return attribute;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
void vtkTrajectoryAttributes::SetAttributeStatus(int attribute, int status)
{
  if (!IsAttribute(attribute))
  {
    vtkErrorMacro("There is no attribute number " << attribute << "; they are 0 to "
                                                  << NUMBER_OF_ATTRIBUTES - 1 << ".");
    return;
  }
  const int clamped = std::clamp<int>(status, OFF, AUTOMATIC);
  if (this->Statuses[attribute] != clamped)
  {
    this->Statuses[attribute] = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryAttributes::SetAttributeStatus(const char* name, int status)
{
  const int attribute = GetAttributeIndex(name);
  if (attribute < 0)
  {
    std::string names;
    for (const AttributeInformation& information : Catalogue)
    {
      names += (names.empty() ? "" : ", ") + std::string(information.Name);
    }
    vtkErrorMacro(
      "There is no attribute named '" << (name ? name : "") << "'; they are " << names << ".");
    return;
  }
  this->SetAttributeStatus(attribute, status);
}

//------------------------------------------------------------------------------
void vtkTrajectoryAttributes::SetAllAttributeStatuses(int status)
{
  for (int attribute = 0; attribute < NUMBER_OF_ATTRIBUTES; ++attribute)
  {
    this->SetAttributeStatus(attribute, status);
  }
}

//------------------------------------------------------------------------------
int vtkTrajectoryAttributes::GetAttributeStatus(int attribute)
{
  return IsAttribute(attribute) ? this->Statuses[attribute] : static_cast<int>(OFF);
}

//------------------------------------------------------------------------------
int vtkTrajectoryAttributes::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return vtkFillOutput(this, output,
    [&]
    {
      output->ShallowCopy(vtkUnsharedPoints::Make(input, vtkUnsharedPoints::LINES, this));
      const Arrays arrays = this->FindArrays(output);
      return this->ComputeOfPoints(arrays, output) &&
        this->ComputeTotalPressureDifference(arrays, output);
    });
}

//------------------------------------------------------------------------------
vtkTrajectoryAttributes::Arrays vtkTrajectoryAttributes::FindArrays(vtkPolyData* input) const
{
  Arrays arrays;
  arrays.Pressure = this->PressureArray.empty() ? FindWellKnown(input, PressureNames)
                                                : FindNamed(input, this->PressureArray, "pressure");
  arrays.Height =
    this->HeightArray.empty() ? nullptr : FindNamed(input, this->HeightArray, "height");
  arrays.Time = this->TimeArray.empty() ? FindWellKnown(input, TimeNames)
                                        : FindNamed(input, this->TimeArray, "time");
  for (int attribute = 0; attribute < NUMBER_OF_ATTRIBUTES; ++attribute)
  {
    arrays.IsComputed[attribute] = this->IsComputed(attribute, arrays, input);
  }
  return arrays;
}

//------------------------------------------------------------------------------
bool vtkTrajectoryAttributes::IsComputed(
  int attribute, const Arrays& arrays, vtkPolyData* input) const
{
  const AttributeInformation& information = Catalogue[attribute];
  const bool lacksPressure = information.Needs == Role::Pressure && !arrays.Pressure;
  const bool lacksTime = information.Needs == Role::Time && !arrays.Time;
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  if (this->Statuses[attribute] == ON && !isEmpty && (lacksPressure || lacksTime))
  {
    throw std::invalid_argument(std::string(information.Name) + " needs the " +
      (lacksPressure ? "pressure" : "time") +
      " of each point, and no array has a name that tells it. Choose one with Set" +
      (lacksPressure ? "Pressure" : "Time") + "Array(), or switch the attribute off." +
      DescribeArrays(input));
  }
  if (this->Statuses[attribute] == OFF || lacksPressure || lacksTime)
  {
    return false;
  }
  if (attribute == TOTAL_PRESSURE_DIFFERENCE && this->TimeWindow > 0.0 && !arrays.Time && !isEmpty)
  {
    throw std::invalid_argument(
      "A TimeWindow needs the time of each point, and no array has a name "
      "that tells it. Choose one with SetTimeArray(), or set TimeWindow "
      "to 0." +
      DescribeArrays(input));
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTrajectoryAttributes::ComputeOfPoints(const Arrays& arrays, vtkPolyData* output)
{
  const vtkIdType pointCount = output->GetNumberOfPoints();
  const vtkPolylines lines(output->GetLines());
  const vtkIdType positions = lines.GetNumberOfPositions();
  vtkDataArray* coordinates = output->GetPoints() ? output->GetPoints()->GetData() : nullptr;
  vtkPolylineAttributes attributes(
    lines, coordinates, this->UpAxis, arrays.Pressure, arrays.Height, arrays.Time);
  std::vector<vtkSmartPointer<vtkFloatArray>> results;
  for (int attribute = 0; attribute < NUMBER_OF_ATTRIBUTES; ++attribute)
  {
    if (arrays.IsComputed[attribute] && Catalogue[attribute].Association == vtkDataObject::POINT)
    {
      results.push_back(MakeArray(attribute, pointCount, arrays.GetUnitOf(attribute)));
      attributes.SetOutput(attribute, results.back()->GetPointer(0));
      if (positions < pointCount)
      {
        FillWithMissing(results.back());
      }
    }
  }

  // Threads share out blocks of positions, so that one long line keeps all of them busy.
  const vtkIdType blockSize = vtkPolylines::BlockSize;
  const vtkIdType blocks = (positions + blockSize - 1) / blockSize;
  std::vector<unsigned char> needsRepair(blocks);
  const auto compute = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType block = first; block < last; ++block)
    {
      needsRepair[block] =
        attributes.Compute(block * blockSize, std::min((block + 1) * blockSize, positions));
    }
  };
  const auto repair = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType block = first; block < last; ++block)
    {
      if (needsRepair[block])
      {
        attributes.Repair(block * blockSize, std::min((block + 1) * blockSize, positions));
      }
    }
  };
  const vtkIdType minimumBatch = 256;
  const bool finished =
    vtkBatches(this, 0.0, PointsProgress).ParallelFor(blocks, compute, minimumBatch);
  if (finished)
  {
    vtkSMPTools::For(0, blocks, repair);
  }
  for (const auto& result : results)
  {
    output->GetPointData()->AddArray(result);
  }
  return finished;
}

//------------------------------------------------------------------------------
bool vtkTrajectoryAttributes::ComputeTotalPressureDifference(
  const Arrays& arrays, vtkPolyData* output)
{
  if (!arrays.IsComputed[TOTAL_PRESSURE_DIFFERENCE])
  {
    return true;
  }
  const auto result = MakeArray(TOTAL_PRESSURE_DIFFERENCE, output->GetNumberOfCells(),
    arrays.GetUnitOf(TOTAL_PRESSURE_DIFFERENCE));
  FillWithMissing(result);
  output->GetCellData()->AddArray(result);

  const vtkPolylines lines(output->GetLines());
  const std::vector<vtkIdType> firstLines = vtkFindTrajectories(output);
  const vtkPolylineRanges ranges(lines, firstLines, arrays.Pressure,
    this->TimeWindow > 0.0 ? arrays.Time : nullptr, this->TimeWindow);
  // The cells of a poly data are numbered from the vertices on, then the lines.
  float* ofLines = result->GetPointer(0) + output->GetNumberOfVerts();
  const vtkIdType minimumBatch = 1024;
  return vtkBatches(this, PointsProgress, 1.0)
    .ParallelFor(
      static_cast<vtkIdType>(firstLines.size()) - 1,
      [&](vtkIdType first, vtkIdType last) { ranges.Compute(first, last, ofLines); }, minimumBatch);
}

//------------------------------------------------------------------------------
void vtkTrajectoryAttributes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (int attribute = 0; attribute < NUMBER_OF_ATTRIBUTES; ++attribute)
  {
    os << indent << Catalogue[attribute].Name << ": " << this->Statuses[attribute] << "\n";
  }
  os << indent << "PressureArray: " << this->PressureArray << "\n";
  os << indent << "HeightArray: " << this->HeightArray << "\n";
  os << indent << "TimeArray: " << this->TimeArray << "\n";
  os << indent << "UpAxis: " << this->UpAxis << "\n";
  os << indent << "TimeWindow: " << this->TimeWindow << "\n";
}

VTK_ABI_NAMESPACE_END
