// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ResultFile.h"

#include "PictureFile.h"
#include "RenderError.h"

#include <filesystem>
#include <system_error>

namespace pellucid
{
namespace benchmark
{
namespace
{
//------------------------------------------------------------------------------
// In the same folder, so that it can be renamed.
std::filesystem::path MakeNewName(const std::filesystem::path& fileName)
{
  const std::string name = fileName.stem().string() + ".partial" + fileName.extension().string();
  return fileName.parent_path() / name;
}
}

//------------------------------------------------------------------------------
void CheckReplaceable(const std::string& fileName)
{
  const auto status = std::filesystem::symlink_status(fileName);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    throw RenderError(fileName +
      ": expected a new file, or one to replace, found something else, such as a link or a folder");
  }
  CheckWritable(fileName);
  CheckWritable(MakeNewName(fileName).string());
}

//------------------------------------------------------------------------------
void ReplaceFile(
  const std::string& fileName, const std::function<void(const std::string& newName)>& write)
{
  const std::filesystem::path newName = MakeNewName(fileName);
  std::error_code error;
  try
  {
    write(newName.string());
    std::filesystem::rename(newName, fileName, error);
  }
  catch (...)
  {
    std::filesystem::remove(newName, error);
    throw;
  }
  if (error)
  {
    throw RenderError(fileName + ": cannot be written: " + error.message());
  }
}
}
}
