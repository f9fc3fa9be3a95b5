// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTRXArchive.h"

#include "vtkTrajectoryFileError.h"

#include "vtksys/Directory.hxx"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr std::uint64_t LargestRatio = 1032;

// Folders in folders: dpg/GROUP/NAME.TYPE
constexpr int DeepestFolder = 2;

constexpr std::size_t BlockSize = 1 << 16;

using Zip = std::unique_ptr<archive, decltype(&archive_read_free)>;

//------------------------------------------------------------------------------
vtkTrajectoryFileError Damage(const std::string& name, const std::string& what)
{
  return vtkTrajectoryFileError("\"" + name + "\" in it: " + what);
}

//------------------------------------------------------------------------------
vtkTrajectoryFileError Truncation(const std::string& name, std::size_t expected, std::size_t found)
{
  return Damage(name,
    "expected " + std::to_string(expected) + " bytes, found " + std::to_string(found) +
      "; the file is cut off or damaged");
}

//------------------------------------------------------------------------------
std::string Reason(archive* zip)
{
  const char* reason = archive_error_string(zip);
  return reason ? reason : "no reason given";
}

//------------------------------------------------------------------------------
bool IsZip(const std::string& path)
{
  char magic[4] = {};
  vtksys::ifstream(path.c_str(), std::ios::in | std::ios::binary).read(magic, sizeof(magic));
  return std::string(magic, sizeof(magic)) == "PK\3\4";
}

//------------------------------------------------------------------------------
Zip OpenZip(const std::string& path)
{
  Zip zip(archive_read_new(), &archive_read_free);
  // Not the streaming variant, which takes the sizes from where they may be left out.
  archive_read_support_format_zip_seekable(zip.get());
  if (archive_read_open_filename(zip.get(), path.c_str(), BlockSize) != ARCHIVE_OK)
  {
    throw vtkTrajectoryFileError("expected a zip archive, which ends with its list of files, found "
                                 "a damaged or cut one (" +
      Reason(zip.get()) + ")");
  }
  return zip;
}

//------------------------------------------------------------------------------
// A name that the archive does not encode as it says is taken byte by byte.
std::string GetName(archive_entry* entry)
{
  const char* name = archive_entry_pathname_utf8(entry);
  name = name ? name : archive_entry_pathname(entry);
  const std::string text = name ? name : "";
  return text.compare(0, 2, "./") == 0 ? text.substr(2) : text;
}

//------------------------------------------------------------------------------
void RequirePlain(archive* zip, archive_entry* entry, const std::string& name)
{
  const std::string format = archive_format_name(zip) ? archive_format_name(zip) : "";
  const bool isPlain = format.find("(deflation)") != std::string::npos ||
    format.find("(uncompressed)") != std::string::npos;
  if (!isPlain || archive_entry_is_encrypted(entry))
  {
    throw Damage(name,
      "expected it stored or deflated, found " + format +
        (archive_entry_is_encrypted(entry) ? ", encrypted" : ""));
  }
  if (!archive_entry_size_is_set(entry) || archive_entry_size(entry) < 0)
  {
    throw Damage(name, "expected a size, found none");
  }
}

//------------------------------------------------------------------------------
bool VisitFile(
  const std::string& path, const std::string& name, const vtkTRXArchive::Visitor& visitor)
{
  vtksys::ifstream stream;
  const vtkTRXArchive::Source source = [&](void* bytes, std::size_t count)
  {
    if (!stream.is_open())
    {
      stream.open(path.c_str(), std::ios::in | std::ios::binary);
    }
    if (!stream.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count)))
    {
      throw Truncation(name, count, static_cast<std::size_t>(stream.gcount()));
    }
  };
  return visitor(name, vtksys::SystemTools::FileLength(path), source);
}

//------------------------------------------------------------------------------
bool VisitFolder(const std::string& folder, const std::string& prefix, int depth,
  const vtkTRXArchive::Visitor& visitor)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> names;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    names.emplace_back(directory.GetFile(i));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names)
  {
    if (name == "." || name == "..")
    {
      continue;
    }
    const std::string path = folder + "/" + name;
    if (vtksys::SystemTools::FileIsDirectory(path))
    {
      if (depth < DeepestFolder && !VisitFolder(path, prefix + name + "/", depth + 1, visitor))
      {
        return false;
      }
      continue;
    }
    if (!VisitFile(path, prefix + name, visitor))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
vtkTRXArchive::vtkTRXArchive(const std::string& path)
  : Path(path)
  , IsFolder(vtksys::SystemTools::FileIsDirectory(path))
{
  if (!this->IsFolder && !IsZip(path))
  {
    throw vtkTrajectoryFileError(
      "expected a zip archive or a folder, found neither", vtkErrorCode::UnrecognizedFileTypeError);
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkTRXArchive::GetLength() const
{
  if (!this->IsFolder)
  {
    return vtksys::SystemTools::FileLength(this->Path);
  }
  std::uint64_t length = 0;
  this->Visit(
    [&length](const std::string&, std::uint64_t size, const Source&)
    {
      length += size;
      return true;
    });
  return length;
}

//------------------------------------------------------------------------------
void vtkTRXArchive::Visit(const Visitor& visitor) const
{
  if (this->IsFolder)
  {
    VisitFolder(this->Path, "", 0, visitor);
  }
  else
  {
    this->VisitZip(visitor);
  }
}

//------------------------------------------------------------------------------
void vtkTRXArchive::VisitOne(const std::string& name, const Visitor& visitor) const
{
  if (!this->IsFolder)
  {
    this->VisitZip([&](const std::string& found, std::uint64_t size, const Source& source)
      { return found != name || visitor(found, size, source); });
    return;
  }
  const std::string path = this->Path + "/" + name;
  if (vtksys::SystemTools::FileExists(path, true))
  {
    VisitFile(path, name, visitor);
  }
}

//------------------------------------------------------------------------------
void vtkTRXArchive::VisitZip(const Visitor& visitor) const
{
  const Zip zip = OpenZip(this->Path);
  const std::uint64_t length = this->GetLength();
  std::uint64_t left = length * LargestRatio;
  for (;;)
  {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(zip.get(), &entry);
    if (status == ARCHIVE_EOF)
    {
      return;
    }
    if (status < ARCHIVE_WARN)
    {
      throw vtkTrajectoryFileError(
        "expected a zip archive, found a damaged one (" + Reason(zip.get()) + ")");
    }
    const std::string name = GetName(entry);
    if (archive_entry_filetype(entry) == AE_IFDIR)
    {
      continue;
    }
    RequirePlain(zip.get(), entry, name);
    const auto size = static_cast<std::uint64_t>(archive_entry_size(entry));
    if (size > left)
    {
      throw Damage(name,
        "declared as " + std::to_string(size) + " bytes, which is more than the archive of " +
          std::to_string(length) + " bytes can hold");
    }
    left -= size;

    std::uint64_t taken = 0;
    const Source source = [&](void* bytes, std::size_t count)
    {
      const la_ssize_t found = archive_read_data(zip.get(), bytes, count);
      if (found < 0)
      {
        throw Damage(name, Reason(zip.get()));
      }
      if (static_cast<std::size_t>(found) != count)
      {
        throw Truncation(name, count, static_cast<std::size_t>(found));
      }
      taken += count;
    };
    if (!visitor(name, size, source))
    {
      return;
    }
    // The checksum is compared at the end of the file.
    char more = 0;
    const la_ssize_t found = taken == size ? archive_read_data(zip.get(), &more, 1) : 0;
    if (found != 0)
    {
      throw Damage(name, found < 0 ? Reason(zip.get()) : "longer than declared");
    }
  }
}

VTK_ABI_NAMESPACE_END
