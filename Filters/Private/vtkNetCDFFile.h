// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNetCDFFile
 * @brief   A NetCDF file open for reading; closed when it goes.
 *
 * Private to the module. Variables are those of the root group. Everything throws
 * vtkTrajectoryFileError. The NetCDF library is not made for several threads.
 *
 * @sa vtkNetCDFTrajectories
 */

#ifndef vtkNetCDFFile_h
#define vtkNetCDFFile_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstdint> // for the length
#include <string>  // for names
#include <vector>  // for variables

VTK_ABI_NAMESPACE_BEGIN

class vtkNetCDFFile
{
public:
  struct Variable
  {
    int Id;
    std::string Name;
    int Type;                    // nc_type
    std::vector<int> Dimensions; // ids, slowest first
  };

  static constexpr int Global = -1; // stands for the variable where the file's attributes are meant

  explicit vtkNetCDFFile(const std::string& fileName);
  ~vtkNetCDFFile();
  vtkNetCDFFile(const vtkNetCDFFile&) = delete;
  vtkNetCDFFile& operator=(const vtkNetCDFFile&) = delete;

  /** Those of a numeric type. */
  const std::vector<Variable>& GetVariables() const { return this->Variables; }

  std::size_t GetLength(int dimension) const;
  std::string GetDimensionName(int dimension) const;

  /** "lon(time, id), p(time, id)": the variables; no more than 20. */
  std::string ListVariables() const;

  /** Text of an attribute without the blanks around it; empty where there is none. */
  std::string GetText(int variable, const char* attribute) const;

  /** Numbers of an attribute; none where there is none, or text. */
  std::vector<double> GetNumbers(int variable, const char* attribute) const;

  /** Throw unless a file of this length can hold all these variables. */
  void CheckSize(const std::vector<Variable>& variables) const;

  /**
   * Part of a variable in the file's order. vtkFloatArray for floats and integers of up to 16 bits,
   * else vtkDoubleArray; unpacked by scale_factor and add_offset; NaN where the value is
   * _FillValue (or the type's default), missing_value, or one of `missing`. Without the array's
   * name.
   */
  vtkSmartPointer<vtkDataArray> Read(const Variable& variable,
    const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
    std::vector<double> missing = {}) const;

private:
  template <typename Array, typename ReadFunction>
  vtkSmartPointer<vtkDataArray> ReadAs(ReadFunction read, const Variable& variable,
    const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
    const std::vector<double>& missing) const;

  int Id = -1;
  std::uint64_t FileLength;
  std::vector<Variable> Variables;
};

VTK_ABI_NAMESPACE_END
#endif
