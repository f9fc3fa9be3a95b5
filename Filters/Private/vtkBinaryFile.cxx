// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBinaryFile.h"

#include "vtkTrajectoryFileError.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkBinaryFile::vtkBinaryFile(const std::string& fileName, std::uint64_t limit)
  : Bytes(std::min<std::uint64_t>(vtksys::SystemTools::FileLength(fileName), limit))
{
  vtksys::ifstream stream(fileName.c_str(), std::ios::in | std::ios::binary);
  if (!stream.read(this->Bytes.data(), static_cast<std::streamsize>(this->Bytes.size())))
  {
    throw vtkTrajectoryFileError("expected " + std::to_string(this->Bytes.size()) +
        " bytes, but only " + std::to_string(stream.gcount()) + " can be read",
      vtkErrorCode::PrematureEndOfFileError);
  }
}

//------------------------------------------------------------------------------
const char* vtkBinaryFile::Skip(std::uint64_t count, const char* what)
{
  if (count > this->GetRemaining())
  {
    throw vtkTrajectoryFileError("expected " + std::to_string(count) + " bytes of " + what +
        " at byte " + std::to_string(this->Position) + ", found " +
        std::to_string(this->GetRemaining()) + "; the file is cut off or damaged",
      vtkErrorCode::PrematureEndOfFileError);
  }
  const char* bytes = this->Bytes.data() + this->Position;
  this->Position += count;
  return bytes;
}

//------------------------------------------------------------------------------
void vtkBinaryFile::Seek(std::uint64_t position, const char* what)
{
  this->Position = 0;
  this->Skip(position, what);
}

VTK_ABI_NAMESPACE_END
