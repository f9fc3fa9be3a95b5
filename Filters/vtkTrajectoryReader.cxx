// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryReader.h"

#include "Private/vtkTrajectoryFileError.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtksys/SystemTools.hxx"

#include <exception>
#include <new>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
void ClearOutput(vtkInformation* outInfo)
{
  if (vtkPolyData* output = vtkPolyData::GetData(outInfo))
  {
    output->Initialize();
  }
}
}

//------------------------------------------------------------------------------
vtkTrajectoryReader::vtkTrajectoryReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkTrajectoryReader::~vtkTrajectoryReader()
{
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
template <typename Function>
bool vtkTrajectoryReader::Attempt(Function&& read)
{
  const std::string fileName = this->FileName ? this->FileName : "";
  std::string message;
  unsigned long code = vtkErrorCode::UnknownError;
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    if (fileName.empty())
    {
      throw vtkTrajectoryFileError(
        "no file name is set; call SetFileName()", vtkErrorCode::NoFileNameError);
    }
    if (!vtksys::SystemTools::PathExists(fileName))
    {
      throw vtkTrajectoryFileError("there is no such file", vtkErrorCode::FileNotFoundError);
    }
    if (!vtksys::SystemTools::TestFileAccess(fileName, vtksys::TEST_FILE_READ))
    {
      throw vtkTrajectoryFileError(
        "cannot be opened; may you read it?", vtkErrorCode::CannotOpenFileError);
    }
    if (vtksys::SystemTools::FileExists(fileName, true) &&
      vtksys::SystemTools::FileLength(fileName) == 0)
    {
      throw vtkTrajectoryFileError("the file is empty", vtkErrorCode::PrematureEndOfFileError);
    }
    read(fileName);
    return true;
  }
  catch (const vtkTrajectoryFileError& error)
  {
    message = error.what();
    code = error.GetCode();
  }
  catch (const std::bad_alloc&)
  {
    message = "its lines do not fit into memory; free some, or split the file";
  }
  catch (const std::exception& error)
  {
    message = std::string("cannot be read: ") + error.what();
  }
  this->SetErrorCode(code);
  vtkErrorMacro(<< (fileName.empty() ? "" : fileName + ": ") << message);
  return false;
}

//------------------------------------------------------------------------------
int vtkTrajectoryReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  const bool success =
    this->Attempt([&](const std::string& fileName) { this->ReadInformation(fileName, outInfo); });
  if (!success)
  {
    // RequestData() is not called: the lines of an earlier file would stay.
    ClearOutput(outInfo);
  }
  return success;
}

//------------------------------------------------------------------------------
int vtkTrajectoryReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  const bool success = this->Attempt([&](const std::string& fileName)
    { this->ReadTrajectories(fileName, outInfo, vtkPolyData::GetData(outInfo)); });
  if (!success)
  {
    ClearOutput(outInfo);
  }
  return success;
}

//------------------------------------------------------------------------------
void vtkTrajectoryReader::ReadInformation(const std::string&, vtkInformation*) {}

//------------------------------------------------------------------------------
void vtkTrajectoryReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

VTK_ABI_NAMESPACE_END
