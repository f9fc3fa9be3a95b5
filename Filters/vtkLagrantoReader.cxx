// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLagrantoReader.h"

#include "Private/vtkLagrantoText.h"

#include "vtkObjectFactory.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkLagrantoReader);

namespace
{
// In bytes. LAGRANTO writes up to 1100.
constexpr std::size_t GreatestHeader = 65536;

//------------------------------------------------------------------------------
std::string ReadBeginning(const std::string& fileName, std::size_t length)
{
  vtksys::ifstream stream(fileName.c_str(), std::ios::in | std::ios::binary);
  std::string text(length, '\0');
  stream.read(&text[0], static_cast<std::streamsize>(length));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}
}

//------------------------------------------------------------------------------
int vtkLagrantoReader::CanReadFile(const char* fileName)
{
  return fileName && vtksys::SystemTools::FileExists(fileName, true) &&
      vtkLagrantoText::CanRead(ReadBeginning(fileName, GreatestHeader))
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkTrajectorySource> vtkLagrantoReader::Open(const std::string& fileName)
{
  const std::string text = ReadBeginning(fileName, vtksys::SystemTools::FileLength(fileName));
  return std::make_unique<vtkLagrantoText>(text,
    [this](double progress)
    {
      this->UpdateProgress(this->GetOpeningShare() * progress);
      return !this->CheckAbort();
    });
}

VTK_ABI_NAMESPACE_END
