// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryReader
 * @brief   Base of the readers of trajectory files.
 *
 * Output: vtkPolyData with one polyline for each trajectory, or for each part of one that a gap in
 * the file splits, and each variable of the file as an array whose unit, where the file tells it,
 * is its vtkDataArray::UNITS_LABEL(). A value that the file marks as missing is NaN.
 *
 * Every file is untrusted. What it claims to hold is compared with its length before anything is
 * allocated. A file that cannot be read whole gives one error, "FILE: what was expected and what
 * was found", an error code of vtkErrorCode, and an empty output; never a part of its lines.
 *
 * @par Reference
 * None: an interface.
 *
 * @sa vtkTrajectoryReaderFactory
 */

#ifndef vtkTrajectoryReader_h
#define vtkTrajectoryReader_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the file's name

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDFILTERS_EXPORT vtkTrajectoryReader : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkTrajectoryReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default is none, which is an error at the update.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 if the content of the file, whatever its name, is of the kind that this reader reads, else 0.
   * Looks at its beginning only and gives no message.
   */
  virtual int CanReadFile(const char* fileName) = 0;

  /** File name extensions with their dots, separated by spaces, such as ".trk". */
  virtual const char* GetFileExtensions() = 0;

  /** What the files are called, such as "TrackVis". */
  virtual const char* GetDescriptiveName() = 0;

protected:
  vtkTrajectoryReader();
  ~vtkTrajectoryReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * Tell the pipeline what can be told without reading the lines, such as time steps. Throws as
   * ReadTrajectories() does. Default: nothing.
   */
  virtual void ReadInformation(const std::string& fileName, vtkInformation* outInfo);

  /**
   * Fill `output`. Throws vtkTrajectoryFileError (Private/), whose message does not repeat the
   * file's name; any other std::exception becomes an error of the file too.
   */
  virtual void ReadTrajectories(
    const std::string& fileName, vtkInformation* outInfo, vtkPolyData* output) = 0;

private:
  vtkTrajectoryReader(const vtkTrajectoryReader&) = delete;
  void operator=(const vtkTrajectoryReader&) = delete;

  // Run `read`, turn what it throws into one error message, and return whether it threw nothing.
  template <typename Function>
  bool Attempt(Function&& read);

  char* FileName = nullptr;
};

VTK_ABI_NAMESPACE_END
#endif
