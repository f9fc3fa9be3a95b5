// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputReader.h"

#include "MessageLog.h"
#include "Plot3DFiles.h"
#include "ProgressLine.h"
#include "RenderError.h"

#include "vtkAlgorithm.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtksys/SystemTools.hxx"

#include <filesystem>
#include <fstream>
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
void CheckReadable(const std::string& fileName)
{
  if (!std::filesystem::exists(fileName))
  {
    throw RenderError(fileName + ": there is no such file");
  }
  if (std::filesystem::is_directory(fileName))
  {
    throw RenderError(fileName + ": is a folder, not a file");
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw RenderError(fileName + ": cannot be opened; may you read it?");
  }
  if (file.peek() == std::ifstream::traits_type::eof())
  {
    throw RenderError(fileName + ": the file is empty");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> RunReader(vtkAlgorithm* reader, const std::string& fileName)
{
  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  const ProgressLine progress(reader, "Reading " + fileName);
  reader->Update();
  if (log.HasErrors())
  {
    throw RenderError(fileName + ": cannot be read, the file is damaged or of another kind (" +
      log.GetFirstError() + ")");
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (!data)
  {
    throw RenderError(fileName + ": cannot be read, the file holds no data of a known kind");
  }
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

//------------------------------------------------------------------------------
void CheckNotEmpty(const Input& input)
{
  if (input.Data->GetNumberOfElements(vtkDataObject::POINT) == 0)
  {
    throw RenderError(input.Name + ": is empty, it holds no points");
  }
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
    CheckNotEmpty(inputs.back());
  }
  return inputs;
}
}
