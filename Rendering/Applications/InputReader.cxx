// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputReader.h"

#include "InputChecks.h"
#include "MessageLog.h"
#include "Plot3DFiles.h"
#include "PlyLength.h"
#include "ProgressLine.h"
#include "ReaderGuard.h"
#include "RenderError.h"

#include "vtkAlgorithm.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtksys/SystemTools.hxx"

#include <fstream>
#include <iterator>
#include <map>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
template <typename Reader>
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

using ReaderMaker = vtkSmartPointer<vtkAlgorithm> (*)(const std::string&);

const std::map<std::string, ReaderMaker> Readers = {
  { ".obj", MakeReader<vtkOBJReader> },
  { ".ply", MakeReader<vtkPLYReader> },
  { ".stl", MakeReader<vtkSTLReader> },
  { ".vtk", MakeReader<vtkGenericDataObjectReader> },
  { ".vti", MakeReader<vtkXMLGenericDataObjectReader> },
  { ".vtm", MakeReader<vtkXMLGenericDataObjectReader> },
  { ".vtp", MakeReader<vtkXMLGenericDataObjectReader> },
  { ".vtr", MakeReader<vtkXMLGenericDataObjectReader> },
  { ".vts", MakeReader<vtkXMLGenericDataObjectReader> },
  { ".vtu", MakeReader<vtkXMLGenericDataObjectReader> },
};

//------------------------------------------------------------------------------
std::string GetSuffix(const std::string& fileName)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
}

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
vtkSmartPointer<vtkDataObject> RunReader(vtkAlgorithm* reader, const std::string& fileName)
{
  const std::string failure =
    fileName + ": cannot be read, the file is empty, damaged or of another kind";
  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  {
    const ReaderGuard guard(failure);
    const ProgressLine progress(reader, "Reading " + fileName);
    reader->Update();
  }
  // The legacy reader only warns where a file ends too early.
  const bool isLegacy = vtkGenericDataObjectReader::SafeDownCast(reader) != nullptr;
  if (log.HasErrors() || (isLegacy && log.HasWarnings()))
  {
    const std::string reason = log.HasErrors() ? log.GetFirstError() : log.GetFirstWarning();
    throw RenderError(failure + (reason.empty() ? "" : " (" + reason + ")") + GetRemedy(fileName));
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (!data)
  {
    throw RenderError(failure);
  }
  log.PrintWarnings();
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadFile(const std::string& fileName)
{
  const auto maker = Readers.find(GetSuffix(fileName));
  if (maker == Readers.end())
  {
    throw RenderError(fileName +
      ": is of no known kind; known are .vtk .vtp .vtm .vtu .vts .vti .vtr .ply .stl .obj and "
      "PLOT3D's " +
      ListPlot3DSuffixes());
  }
  if (maker->first == ".stl")
  {
    CheckStlLength(fileName);
  }
  if (maker->first == ".ply")
  {
    CheckPlyLength(fileName);
  }
  return RunReader(maker->second(fileName), fileName);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadPlot3D(const Plot3DFiles& files)
{
  // VTK's number of the function that divides momentum by density.
  constexpr int velocity = 200;
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName(files.Grid.c_str());
  reader->SetQFileName(files.Solution.c_str());
  reader->AutoDetectFormatOn();
  reader->AddFunction(velocity);
  reader->SetVectorFunctionNumber(velocity);
  return RunReader(reader, files.Grid + " with " + files.Solution);
}
}

//------------------------------------------------------------------------------
std::vector<Input> ReadInputs(const std::vector<std::string>& fileNames)
{
  std::vector<Input> inputs;
  std::vector<std::string> remaining = fileNames;
  while (!remaining.empty())
  {
    const std::string fileName = remaining.front();
    CheckReadable(fileName);
    if (IsPlot3DFileName(fileName))
    {
      const Plot3DFiles files = TakePlot3DFiles(remaining);
      CheckReadable(files.Grid);
      CheckReadable(files.Solution);
      inputs.push_back({ fileName, ReadPlot3D(files) });
    }
    else
    {
      remaining.erase(remaining.begin());
      inputs.push_back({ fileName, ReadFile(fileName) });
    }
    CheckData(inputs.back().Data, fileName);
  }
  return inputs;
}
}
