// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PictureFile.h"

#include "MessageLog.h"
#include "RenderError.h"

#include "vtkBMPWriter.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFWriter.h"
#include "vtksys/SystemTools.hxx"

#include <filesystem>
#include <fstream>
#include <vector>

namespace pellucid
{
namespace
{
struct PictureFormat
{
  const char* Suffix;
  vtkSmartPointer<vtkImageWriter> (*MakeWriter)();
};

template <typename Writer>
vtkSmartPointer<vtkImageWriter> Make()
{
  return vtkSmartPointer<Writer>::New();
}

const std::vector<PictureFormat> Formats = { { ".png", Make<vtkPNGWriter> },
  { ".jpg", Make<vtkJPEGWriter> }, { ".tif", Make<vtkTIFFWriter> },
  { ".tiff", Make<vtkTIFFWriter> }, { ".bmp", Make<vtkBMPWriter> } };

//------------------------------------------------------------------------------
const PictureFormat* FindFormat(const std::string& fileName)
{
  const std::string suffix =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  for (const PictureFormat& format : Formats)
  {
    if (suffix == format.Suffix)
    {
      return &format;
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
bool IsPictureFileName(const std::string& fileName)
{
  return FindFormat(fileName) != nullptr;
}

//------------------------------------------------------------------------------
std::string ListPictureSuffixes()
{
  std::string list;
  for (const PictureFormat& format : Formats)
  {
    list += (list.empty() ? "" : ", ") + std::string(format.Suffix);
  }
  return list;
}

//------------------------------------------------------------------------------
void CheckWritable(const std::string& fileName)
{
  const bool existed = std::filesystem::exists(fileName);
  const bool isWritable = std::ofstream(fileName, std::ios::app).good();
  if (!isWritable)
  {
    throw RenderError(fileName + ": cannot be written; does the folder exist, and is it yours?");
  }
  if (!existed)
  {
    std::filesystem::remove(fileName);
  }
}

//------------------------------------------------------------------------------
void WritePicture(vtkImageData* picture, const std::string& fileName)
{
  MessageLog& log = MessageLog::GetInstance();
  log.Clear();
  const auto writer = FindFormat(fileName)->MakeWriter();
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(picture);
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError || log.HasErrors())
  {
    throw RenderError(fileName + ": cannot be written: " +
      (log.HasErrors() ? log.GetFirstError()
                       : vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())));
  }
}
}
