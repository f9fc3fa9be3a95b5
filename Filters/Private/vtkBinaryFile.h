// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBinaryFile
 * @brief   The bytes of a file, and a place in them that numbers are taken from.
 *
 * Whatever would go beyond the end throws vtkTrajectoryFileError: "expected N bytes of WHAT at byte
 * P, found M". So no number in the file can make its reader allocate or touch what is not there.
 */

#ifndef vtkBinaryFile_h
#define vtkBinaryFile_h

#include "vtkByteSwap.h"
#include "vtkSystemIncludes.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkBinaryFile
{
public:
  /** The first `limit` bytes of the file, or all if it has fewer. Throws if it cannot be read. */
  explicit vtkBinaryFile(
    const std::string& fileName, std::uint64_t limit = std::numeric_limits<std::uint64_t>::max());

  ///@{
  /** Byte order of the numbers. Default is little-endian. */
  void SetBigEndian(bool bigEndian) { this->BigEndian = bigEndian; }
  ///@}

  const std::vector<char>& GetBytes() const { return this->Bytes; }

  ///@{
  /** The place, in bytes from the beginning, and what is left behind it. */
  std::uint64_t GetPosition() const { return this->Position; }
  std::uint64_t GetRemaining() const { return this->Bytes.size() - this->Position; }
  ///@}

  /** Go on behind `count` bytes; returns the first of them. `what` is for the message. */
  const char* Skip(std::uint64_t count, const char* what);

  /** Go to `position`, which may be the end, but not beyond it. */
  void Seek(std::uint64_t position, const char* what);

  ///@{
  /** Take one number, or `count` of them, in the byte order of the machine. */
  template <typename T>
  void Read(T* values, std::uint64_t count, const char* what)
  {
    const std::uint64_t limit = std::numeric_limits<std::uint64_t>::max() / sizeof(T);
    const std::uint64_t bytes = count < limit ? count * sizeof(T) : limit;
    const char* source = this->Skip(bytes, what);
    if (count == 0)
    {
      return; // no pointer is valid for memcpy() then
    }
    std::memcpy(values, source, bytes);
    this->BigEndian ? vtkByteSwap::SwapBERange(values, count)
                    : vtkByteSwap::SwapLERange(values, count);
  }
  template <typename T>
  T Read(const char* what)
  {
    T value;
    this->Read(&value, 1, what);
    return value;
  }
  ///@}

private:
  std::vector<char> Bytes;
  std::uint64_t Position = 0;
  bool BigEndian = false;
};

VTK_ABI_NAMESPACE_END
#endif
