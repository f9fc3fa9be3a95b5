// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTRXArray
 * @brief   What the name of a file in a TRX tractogram tells about the array that it holds.
 *
 * FOLDER/NAME.COMPONENTS.TYPE; one component may be left out. Types: int8 to int64, uint8 to
 * uint64, float16 (becomes float), float32, float64 and bit (one byte for each value, becomes
 * unsigned char). Little-endian, tuple after tuple.
 *
 * @sa vtkTRXReader
 */

#ifndef vtkTRXArray_h
#define vtkTRXArray_h

#include "vtkSmartPointer.h"
#include "vtkSystemIncludes.h"

#include <cstdint>
#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

class vtkTRXArray
{
public:
  enum Roles
  {
    POSITIONS,  // positions.3.TYPE
    OFFSETS,    // offsets.TYPE
    POINT_DATA, // dpv/
    LINE_DATA,  // dps/
    GROUP,      // groups/: ids of lines
    GROUP_DATA, // dpg/GROUP/: one tuple
    NOTE,       // header.json, and any other JSON beside the arrays
    UNKNOWN
  };

  /** Throws vtkTrajectoryFileError if a file that has to be an array is not named like one. */
  vtkTRXArray(const std::string& fileName, std::uint64_t bytes);

  Roles GetRole() const { return this->Role; }

  /** Whether the file is an array of the format. */
  bool IsArray() const { return this->Role != NOTE && this->Role != UNKNOWN; }

  /** Throws vtkTrajectoryFileError unless the file's bytes are so many tuples. */
  void RequireTuples(std::uint64_t tuples) const;

  std::uint64_t GetNumberOfTuples() const { return this->Tuples; }

  /**
   * A new array, named and filled. `read(bytes, count)` gives the next bytes of the file, and
   * returns false to give up; the result is null then.
   */
  vtkSmartPointer<vtkDataArray> Read(const std::function<bool(char*, std::uint64_t)>& read) const;

private:
  struct Type
  {
    const char* Name;
    int Id;
    unsigned int Size;
  };
  static const Type Types[];

  void RequireType(const std::string& expected, bool isExpected) const;

  std::string FileName;
  std::string Name;
  Roles Role = UNKNOWN;
  const Type* ValueType = nullptr;
  int Components = 1;
  std::uint64_t Tuples = 0;
};

VTK_ABI_NAMESPACE_END
#endif
