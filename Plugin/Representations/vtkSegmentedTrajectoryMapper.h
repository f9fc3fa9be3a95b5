// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentedTrajectoryMapper
 * @brief   A vtkTrajectoryMapper that divides the data objects it is given into segments.
 *
 * For a representation, which gives its mapper the delivered data in each frame: what has not
 * changed is not divided again. Here and not where the data come from, since these may be in parts.
 *
 * @par Reference
 * None: that of vtkTrajectoryMapper.
 */

#ifndef vtkSegmentedTrajectoryMapper_h
#define vtkSegmentedTrajectoryMapper_h

#include "vtkNew.h"                           // for the filter
#include "vtkPellucidRepresentationsModule.h" // for the export macro
#include "vtkTrajectoryMapper.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkSegmentedGeometry;

class VTKPELLUCIDREPRESENTATIONS_EXPORT vtkSegmentedTrajectoryMapper : public vtkTrajectoryMapper
{
public:
  static vtkSegmentedTrajectoryMapper* New();
  vtkTypeMacro(vtkSegmentedTrajectoryMapper, vtkTrajectoryMapper);

  /** The filter that divides; never null. */
  vtkSegmentedGeometry* GetSegments() { return this->Segments; }

  using vtkTrajectoryMapper::SetInputDataObject;
  void SetInputDataObject(int port, vtkDataObject* data) override;

protected:
  vtkSegmentedTrajectoryMapper();
  ~vtkSegmentedTrajectoryMapper() override;

private:
  vtkSegmentedTrajectoryMapper(const vtkSegmentedTrajectoryMapper&) = delete;
  void operator=(const vtkSegmentedTrajectoryMapper&) = delete;

  vtkNew<vtkSegmentedGeometry> Segments;
};

VTK_ABI_NAMESPACE_END
#endif
