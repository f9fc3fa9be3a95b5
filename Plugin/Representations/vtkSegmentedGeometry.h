// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentedGeometry
 * @brief   Geometry of a representation, divided into the segments that opacities are found for.
 *
 * Input is vtkPolyData or composite data of it. Lines and vertices pass vtkTrajectorySegments,
 * leaves of surfaces vtkSurfaceSegments; in a leaf with both, the surfaces are one segment. Without
 * a name of the importance array the input passes as it is.
 *
 * @par Reference
 * None: that of the two filters.
 */

#ifndef vtkSegmentedGeometry_h
#define vtkSegmentedGeometry_h

#include "vtkNew.h" // for the filters
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPellucidRepresentationsModule.h" // for the export macro

#include <array>  // for the range
#include <string> // for the name
#include <vector> // for the leaves

VTK_ABI_NAMESPACE_BEGIN

class vtkPolyData;
class vtkSurfaceSegments;
class vtkTrajectorySegments;

class VTKPELLUCIDREPRESENTATIONS_EXPORT vtkSegmentedGeometry : public vtkPassInputTypeAlgorithm
{
public:
  static vtkSegmentedGeometry* New();
  vtkTypeMacro(vtkSegmentedGeometry, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the point array of one component; empty, the default: nothing is divided. Another name
   * divides nothing anew. */
  void SetImportanceArray(const std::string& name);
  vtkGetMacro(ImportanceArray, std::string);
  ///@}

  ///@{
  /** Of all lines together, at least 0, as vtkTrajectorySegments has it; 0, the default: chosen
   * from the data. */
  vtkSetClampMacro(NumberOfSegments, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfSegments, int);
  ///@}

  /**
   * Of the input: the 50th and the 99th percentile of all values of the importance array; 0 and 1
   * where there are none, or the array is called "Importance", as vtkImportance makes it.
   */
  const std::array<double, 2>& GetImportanceRange();

protected:
  vtkSegmentedGeometry();
  ~vtkSegmentedGeometry() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSegmentedGeometry(const vtkSegmentedGeometry&) = delete;
  void operator=(const vtkSegmentedGeometry&) = delete;

  void DivideLines(const std::vector<vtkPolyData*>& leaves);
  void DivideSurface(vtkPolyData* leaf);

  std::string ImportanceArray;
  std::array<double, 2> ImportanceRange{ { 0.0, 1.0 } };
  vtkTimeStamp RangeTime;
  bool RangeOutdated = true;
  int NumberOfSegments = 0;
  vtkNew<vtkTrajectorySegments> LineSegments;
  vtkNew<vtkSurfaceSegments> SurfaceSegments;
};

VTK_ABI_NAMESPACE_END
#endif
