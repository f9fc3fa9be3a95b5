// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectorySegments
 * @brief   Divide lines into segments of nearly equal length, which opacities are optimised for.
 *
 * The preprocess of T. Guenther, H. Theisel and M. Gross, "Decoupled Opacity Optimization for
 * Points, Lines and Surfaces", 2017, section 5. Each line gets a number of segments in proportion
 * to its length, max(1, round(length / target)), all of one length in it; each point of a vertex
 * cell is a segment of its own. Segments are numbered from 0 in the order of the cells, vertices
 * before lines, and along each line.
 *
 * Input: vtkPolyData, or composite data, whose leaves of other classes pass. The target length is
 * one for all leaves; the segments of each leaf are numbered from 0. Output: the same with
 *
 * - point data "SegmentBase", integers, and "SegmentWeight", single precision, in [0, 1): with
 *   values a[] of the segments, such as opacities, the value at the point is
 *
 *       (1 - SegmentWeight) a[SegmentBase] + SegmentWeight a[SegmentBase + 1],
 *
 *   which is linear in the length along the line between the centres of segments, and constant
 *   before the first and behind the last centre. Segments of two lines are never mixed: at the last
 *   segment of a line the weight is 0. SegmentBase + SegmentWeight does not decrease along a line,
 * and may be interpolated between two neighbouring points. Points that belong to no line or vertex
 *   have -1 and 0;
 * - cell data "FirstSegment" and "NumberOfSegments", integers; -1 and 0 for surface cells, which
 *   are not divided here;
 * - field data "TotalNumberOfSegments", one integer, the number of segments of the leaf.
 *
 * A line of one point, without length or with a coordinate that is NaN or infinite is one segment.
 * Points that lines share, or that a line uses twice such as a closed one, belong to several
 * segments: then the output has a copy, with all point data, for each use but the first, after the
 * points of the input, without the point arrays that are too short to be copied, of which a
 * warning tells; else the geometry is passed by reference.
 *
 * Lengths are added up in double precision. Cost: two passes over the points, parallel over the
 * lines; same bits with any number of threads. Errors: a cell with a point that does not exist,
 * more than VTK_INT_MAX segments of all leaves. An error or an abort leaves an empty output.
 *
 * @par Reference
 * T. Guenther, H. Theisel, M. Gross: Decoupled Opacity Optimization for Points, Lines and
 * Surfaces. Computer Graphics Forum 36(2), 2017, section 5.
 *
 * @sa vtkTrajectoryAttributes
 */

#ifndef vtkTrajectorySegments_h
#define vtkTrajectorySegments_h

#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPellucidFiltersModule.h" // for the export macro

#include <vector> // for the leaves

VTK_ABI_NAMESPACE_BEGIN
class vtkBatches;

class VTKPELLUCIDFILTERS_EXPORT vtkTrajectorySegments : public vtkPassInputTypeAlgorithm
{
public:
  static vtkTrajectorySegments* New();
  vtkTypeMacro(vtkTrajectorySegments, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many segments all lines together are to have: the target length is the length of all lines
   * divided by it. As each line has one segment or more, and whole ones, the result differs by up
   * to half the number of lines, and lines shorter than the target add to it. Points of vertex
   * cells are not counted.
   *
   * 0, the default, makes about 20000, but none with a target below 1/128 of the diagonal of the
   * bounds of all lines, which is some ten pixels where these fill the picture: a few lines in
   * 20000 segments would be too short to be seen, and smoothing moves an opacity by one segment in
   * each step.
   */
  vtkSetClampMacro(NumberOfSegments, vtkIdType, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfSegments, vtkIdType);
  ///@}

  ///@{
  /**
   * Target length of a segment in world units, at least 0; 0, the default, goes by NumberOfSegments
   * instead.
   */
  vtkSetClampMacro(SegmentLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SegmentLength, double);
  ///@}

  /** How many segments the last update made in all leaves, those of vertices included. */
  vtkGetMacro(TotalNumberOfSegments, vtkIdType);

protected:
  vtkTrajectorySegments() = default;
  ~vtkTrajectorySegments() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTrajectorySegments(const vtkTrajectorySegments&) = delete;
  void operator=(const vtkTrajectorySegments&) = delete;

  struct Leaf;

  bool Divide(vtkDataObject* input, vtkDataObject* output);
  static bool MeasureLines(const vtkBatches& batches, Leaf& leaf);
  double ChooseLength(const std::vector<Leaf>& leaves) const;
  static vtkIdType NumberSegments(const Leaf& leaf, double target);
  static bool PlacePoints(const vtkBatches& batches, const Leaf& leaf);

  vtkIdType NumberOfSegments = 0;
  double SegmentLength = 0.0;
  vtkIdType TotalNumberOfSegments = 0;
};

VTK_ABI_NAMESPACE_END
#endif
