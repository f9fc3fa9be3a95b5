// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputReader.h"

#include "FileKinds.h"
#include "InputChecks.h"
#include "MessageLog.h"
#include "Plot3DFiles.h"
#include "ProgressLine.h"
#include "ReaderGuard.h"
#include "RenderError.h"
#include "RenderOptions.h"
#include "TrajectoryFiles.h"

#include "vtkAlgorithm.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGeographicTrajectoryReader.h"
#include "vtkMultiBlockPLOT3DReader.h"

#include <fstream>
#include <iterator>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
// XML files whose arrays follow as one raw block. The expat of some systems, Debian 12 among them,
// breaks VTK's reader there.
bool HasAppendedData(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return text.find("<VTKFile") != std::string::npos &&
    text.find("<AppendedData") != std::string::npos;
}

//------------------------------------------------------------------------------
std::string GetRemedy(const std::string& fileName)
{
  return HasAppendedData(fileName)
    ? ". Its data are appended, which VTK cannot read with the XML parser of some "
      "systems: write it with data mode binary or ascii, or as legacy .vtk"
    : "";
}

//------------------------------------------------------------------------------
// What is said of a file when its reader gives no better reason.
std::string GetFailure(const std::string& fileName)
{
  return fileName + ": cannot be read, the file is empty, damaged or of another kind";
}

//------------------------------------------------------------------------------
// Run the reader and return its output; `explain` makes the message for the user of its first
// complaint, which may be empty.
template <typename Explain>
vtkSmartPointer<vtkDataObject> RunReader(
  vtkAlgorithm* reader, const std::string& fileName, const Explain& explain)
{
  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  {
    const ReaderGuard guard(GetFailure(fileName));
    const ProgressLine progress(reader, "Reading " + fileName);
    reader->Update();
  }
  // The legacy reader only warns where a file ends too early.
  const bool isLegacy = vtkGenericDataObjectReader::SafeDownCast(reader) != nullptr;
  if (log.HasErrors() || (isLegacy && log.HasWarnings()))
  {
    throw RenderError(explain(log.HasErrors() ? log.GetFirstError() : log.GetFirstWarning()));
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (!data)
  {
    throw RenderError(GetFailure(fileName));
  }
  log.PrintWarnings();
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> RunVTKReader(vtkAlgorithm* reader, const std::string& fileName)
{
  return RunReader(reader, fileName,
    [&fileName](const std::string& reason)
    {
      return GetFailure(fileName) + (reason.empty() ? "" : " (" + reason + ")") +
        GetRemedy(fileName);
    });
}

//------------------------------------------------------------------------------
// Without data if the file or folder holds no trajectories.
Input ReadTrajectories(const std::string& fileName, const RenderOptions& options)
{
  vtkSmartPointer<vtkTrajectoryReader> reader;
  {
    const ReaderGuard guard(GetFailure(fileName));
    reader = MakeTrajectoryReader(fileName, options);
  }
  if (!reader)
  {
    return { fileName, nullptr };
  }
  // Our readers' messages begin with the name of the file and say it all.
  const auto data = RunReader(reader, fileName, [](const std::string& reason) { return reason; });
  return { fileName, data, vtkGeographicTrajectoryReader::SafeDownCast(reader) != nullptr };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadPlot3D(const Plot3DFiles& files)
{
  // VTK's number of the function that divides momentum by density.
  constexpr int velocity = 200;
  CheckReadable(files.Grid);
  CheckReadable(files.Solution);
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName(files.Grid.c_str());
  reader->SetQFileName(files.Solution.c_str());
  reader->AutoDetectFormatOn();
  reader->AddFunction(velocity);
  reader->SetVectorFunctionNumber(velocity);
  return RunVTKReader(reader, files.Grid + " with " + files.Solution);
}

//------------------------------------------------------------------------------
// Read the first file, and its partner if it needs one, and take them out of the list.
Input TakeInput(std::vector<std::string>& fileNames, const RenderOptions& options)
{
  const std::string fileName = fileNames.front();
  CheckReadable(fileName);
  Input input = ReadTrajectories(fileName, options);
  if (!input.Data)
  {
    CheckNoFolder(fileName);
    if (const auto reader = MakeFileReader(fileName))
    {
      input.Data = RunVTKReader(reader, fileName);
    }
    else if (IsPlot3DFileName(fileName))
    {
      input.Data = ReadPlot3D(TakePlot3DFiles(fileNames));
      return input;
    }
    else
    {
      throw RenderError(ExplainUnknownFile(fileName));
    }
  }
  fileNames.erase(fileNames.begin());
  return input;
}
}

//------------------------------------------------------------------------------
std::vector<Input> ReadInputs(const RenderOptions& options)
{
  std::vector<Input> inputs;
  std::vector<std::string> remaining = options.Inputs;
  while (!remaining.empty())
  {
    inputs.push_back(TakeInput(remaining, options));
    CheckData(inputs.back().Data, inputs.back().Name);
  }
  return inputs;
}
}
