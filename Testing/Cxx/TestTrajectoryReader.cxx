// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whatever a reader throws becomes one error message with the file's name, an error code, and an
 * empty output; both while the lines are read and before.
 */

#include "ReferenceTesting.h"
#include "TrajectoryTesting.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkTrajectoryReader.h"

#include <functional>
#include <new>
#include <stdexcept>

namespace
{
const std::string File = __FILE__;

/** Makes a line, and fails as it is told. */
class FailingReader : public vtkTrajectoryReader
{
public:
  static FailingReader* New();
  vtkTypeMacro(FailingReader, vtkTrajectoryReader);

  int CanReadFile(const char*) override { return 0; }
  const char* GetFileExtensions() override { return ""; }
  const char* GetDescriptiveName() override { return ""; }

  std::function<void()> FailAtInformation = [] {};
  std::function<void()> FailAtTrajectories = [] {};

protected:
  void ReadInformation(const std::string&, vtkInformation*) override { this->FailAtInformation(); }

  void ReadTrajectories(const std::string&, vtkInformation*, vtkPolyData* output) override
  {
    output->ShallowCopy(MakeTrajectories({ { { 0, 0, 0 }, { 1, 0, 0 } } }));
    this->FailAtTrajectories();
  }
};
vtkStandardNewMacro(FailingReader);

void CheckErrors(Checks& checks, const std::function<void()>& fail, const std::string& message)
{
  for (const bool atInformation : { true, false })
  {
    vtkNew<FailingReader> reader;
    reader->SetFileName(File.c_str());
    checks.True("no error at first", GetUpdateErrors(reader).empty());
    checks.Near("a line", reader->GetOutput()->GetNumberOfLines(), 1, 0);

    (atInformation ? reader->FailAtInformation : reader->FailAtTrajectories) = fail;
    const std::string errors = GetUpdateErrors(reader);
    checks.True(
      "expected \"" + message + "\", found " + errors, Contains(errors, File + ": " + message));
    checks.Near("code", reader->GetErrorCode(), vtkErrorCode::UnknownError, 0);
    checks.Near("points", reader->GetOutput()->GetNumberOfPoints(), 0, 0);
    checks.Near("lines", reader->GetOutput()->GetNumberOfLines(), 0, 0);
  }
}
}

//------------------------------------------------------------------------------
int TestTrajectoryReader(int, char*[])
{
  Checks checks;
  CheckErrors(
    checks, [] { throw std::bad_alloc(); },
    "its lines do not fit into memory; free some, or split the file");
  CheckErrors(
    checks, [] { std::vector<char>().at(1); }, "cannot be read: ");
  CheckErrors(
    checks, [] { throw std::length_error("too long"); }, "cannot be read: too long");
  return checks.Result();
}
