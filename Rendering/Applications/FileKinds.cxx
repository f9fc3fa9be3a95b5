// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FileKinds.h"

#include "InputChecks.h"
#include "Plot3DFiles.h"
#include "PlyLength.h"

#include "vtkGenericDataObjectReader.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <fstream>
#include <map>
#include <vector>

namespace pellucid
{
namespace
{
constexpr std::size_t HeadSize = 4096;

//------------------------------------------------------------------------------
std::string ReadHead(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  std::string head(HeadSize, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

//------------------------------------------------------------------------------
bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

//------------------------------------------------------------------------------
bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

//------------------------------------------------------------------------------
template <typename Reader>
vtkSmartPointer<vtkAlgorithm> Make(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

struct FileKind
{
  std::vector<std::string> Suffixes;
  bool (*HasContent)(const std::string& fileName, const std::string& head);
  vtkSmartPointer<vtkAlgorithm> (*MakeReader)(const std::string& fileName);
  void (*Check)(const std::string& fileName);
};

void CheckNothing(const std::string&) {}

const std::vector<FileKind> Kinds = {
  { { ".vtk" },
    [](const std::string&, const std::string& head) { return BeginsWith(head, "# vtk DataFile"); },
    Make<vtkGenericDataObjectReader>, CheckNothing },
  { { ".vti", ".vtm", ".vtp", ".vtr", ".vts", ".vtu" },
    [](const std::string&, const std::string& head) { return Contains(head, "<VTKFile"); },
    Make<vtkXMLGenericDataObjectReader>, CheckNothing },
  { { ".ply" },
    [](const std::string&, const std::string& head)
    { return BeginsWith(head, "ply\n") || BeginsWith(head, "ply\r"); },
    Make<vtkPLYReader>, CheckPlyLength },
  { { ".stl" },
    [](const std::string& fileName, const std::string& head)
    { return (BeginsWith(head, "solid") && Contains(head, "facet")) || IsBinaryStl(fileName); },
    Make<vtkSTLReader>, CheckStlLength },
  { { ".obj" }, [](const std::string&, const std::string&) { return false; }, Make<vtkOBJReader>,
    CheckNothing },
};

// What the suffixes of trajectory files promise.
const std::map<std::string, std::string> TrajectorySuffixes = {
  { ".nc", "NetCDF" },
  { ".lsl", "LAGRANTO's text format" },
  { ".trk", "TrackVis" },
  { ".tck", "MRtrix" },
  { ".trx", "TRX" },
};

//------------------------------------------------------------------------------
std::string GetSuffix(const std::string& fileName)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeFileReader(const std::string& fileName)
{
  const std::string head = ReadHead(fileName);
  const std::string suffix = GetSuffix(fileName);
  auto kind = std::find_if(Kinds.begin(), Kinds.end(),
    [&](const FileKind& candidate) { return candidate.HasContent(fileName, head); });
  if (kind == Kinds.end())
  {
    kind = std::find_if(Kinds.begin(), Kinds.end(),
      [&suffix](const FileKind& candidate)
      { return std::count(candidate.Suffixes.begin(), candidate.Suffixes.end(), suffix) != 0; });
  }
  if (kind == Kinds.end())
  {
    return nullptr;
  }
  kind->Check(fileName);
  return kind->MakeReader(fileName);
}

//------------------------------------------------------------------------------
std::string ListFileKinds()
{
  return R"(  trajectories              Met.3D and LAGRANTO NetCDF (.nc), LAGRANTO text (.lsl .1)
  tractograms               TrackVis (.trk), MRtrix (.tck), TRX (.trx, or its folder)
  lines, points, surfaces   .vtk .vtp .vtm .ply .stl .obj
  vector fields             .vtk .vts .vti .vtr .vtu .vtm, PLOT3D grid and solution
                            (of combxyz.bin the partner combq.bin is found by its name):
                            )" +
    ListPlot3DSuffixes();
}

//------------------------------------------------------------------------------
std::string ExplainUnknownFile(const std::string& fileName)
{
  const std::string head = ReadHead(fileName);
  if (BeginsWith(head, "CDF") || BeginsWith(head, "\x89HDF"))
  {
    return fileName +
      ": is NetCDF or HDF5 without trajectories as we know them, or damaged; expected the "
      "variables "
      "time, lon, lat and pressure of Met.3D (ensemble, trajectory, time) or time, lon, lat and p "
      "of LAGRANTO (time, trajectory)";
  }
  const auto promise = TrajectorySuffixes.find(GetSuffix(fileName));
  if (promise != TrajectorySuffixes.end())
  {
    return fileName + ": is named as " + promise->second +
      " but does not begin so, it is damaged or of another kind";
  }
  return fileName +
    ": is of no known kind; known are .vtk .vtp .vtm .vtu .vts .vti .vtr .ply .stl .obj, "
    "trajectories of Met.3D and LAGRANTO, tractograms .trk .tck .trx and PLOT3D's " +
    ListPlot3DSuffixes();
}
}
