// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryReaderFactory
 * @brief   Choose the reader of a trajectory file by the file's content.
 *
 * Each reader of this module is asked in turn whether it can read the file; its name and suffix do
 * not matter. Readers that other modules add are not known.
 *
 * @par Reference
 * None: an interface.
 *
 * @sa vtkTrajectoryReader
 */

#ifndef vtkTrajectoryReaderFactory_h
#define vtkTrajectoryReaderFactory_h

#include "vtkObject.h"
#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkWrappingHints.h"         // for VTK_NEWINSTANCE

VTK_ABI_NAMESPACE_BEGIN
class vtkTrajectoryReader;

class VTKPELLUCIDFILTERS_EXPORT vtkTrajectoryReaderFactory : public vtkObject
{
public:
  static vtkTrajectoryReaderFactory* New();
  vtkTypeMacro(vtkTrajectoryReaderFactory, vtkObject);

  /**
   * A new reader, its file name set, of the kind whose CanReadFile() accepts the file; null,
   * without a message, if there is none. The caller owns it.
   */
  VTK_NEWINSTANCE static vtkTrajectoryReader* CreateReader(const char* fileName);

protected:
  vtkTrajectoryReaderFactory() = default;
  ~vtkTrajectoryReaderFactory() override = default;

private:
  vtkTrajectoryReaderFactory(const vtkTrajectoryReaderFactory&) = delete;
  void operator=(const vtkTrajectoryReaderFactory&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
