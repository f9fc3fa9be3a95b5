// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTRXArchive
 * @brief   The files of a TRX tractogram: in a zip archive, stored or deflated, or in a folder.
 *
 * Their names are keys; nothing is written to disk. The sizes that a zip archive declares are no
 * larger in total than its length can hold: deflate reaches 1032 to 1 at most.
 */

#ifndef vtkTRXArchive_h
#define vtkTRXArchive_h

#include "vtkSystemIncludes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkTRXArchive
{
public:
  /** Take the next bytes of a file. Throws if it has fewer, or if they are damaged. */
  using Source = std::function<void(void* bytes, std::size_t count)>;

  /** What to do with a file; false ends the visit. */
  using Visitor =
    std::function<bool(const std::string& name, std::uint64_t size, const Source& source)>;

  /** Throws vtkTrajectoryFileError if `path` is neither a folder nor a zip archive. */
  explicit vtkTRXArchive(const std::string& path);

  /** Bytes of the zip archive, or of all files in the folder. */
  std::uint64_t GetLength() const;

  /**
   * Go through all files in the order of the archive. Names are relative, with '/' between folders.
   * Throws vtkTrajectoryFileError.
   */
  void Visit(const Visitor& visitor) const;

  /** Go to the file of that name, which need not be there; a folder is not searched. */
  void VisitOne(const std::string& name, const Visitor& visitor) const;

private:
  void VisitZip(const Visitor& visitor) const;

  std::string Path;
  bool IsFolder = false;
};

VTK_ABI_NAMESPACE_END
#endif
