// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeographicLines
 * @brief   Lines on a map from trajectories: splits at gaps and at the map's edges.
 *
 * Private to the module. The lines are found once from the coordinates; then the values of any
 * variable are put into the order of their points, on all threads.
 *
 * @sa vtkGeographicTrajectoryReader vtkTrajectorySource
 */

#ifndef vtkGeographicLines_h
#define vtkGeographicLines_h

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTrajectorySource.h"
#include "vtkVector.h"

#include <vector> // for the lines

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class vtkGeographicLines
{
public:
  /** How longitudes become x: unwrapped, or cut at the edges of a map of 360 degrees. */
  struct Map
  {
    bool IsCut = false;
    double CentralLongitude = 0.0;
  };

  /** How the vertical coordinate becomes z. */
  struct VerticalAxis
  {
    bool LogPressure = true;
    double Unit = 1.0;  // in hPa or in km
    double Scale = 1.0; // degrees for each unit of -ln p or for each kilometre

    double operator()(double value) const;
  };

  struct Coordinates
  {
    vtkTrajectorySource::Samples Longitude;
    vtkTrajectorySource::Samples Latitude;
    vtkTrajectorySource::Samples Vertical;
  };

  /** Find the lines. */
  vtkGeographicLines(const vtkTrajectorySource& source, const Coordinates& coordinates,
    const Map& map, const VerticalAxis& verticalAxis);

  /**
   * Samples that are no gap of the file, but have a pressure of 0 or less, a z that is no float, or
   * lie beyond a pole or more than a hundred turns away.
   */
  vtkIdType GetNumberOfInvalidSamples() const { return this->NumberOfInvalidSamples; }

  vtkIdType GetNumberOfLines() const { return static_cast<vtkIdType>(this->Lines.size()); }

  /** The points and lines, and "TrajectoryId" of each line. */
  void MakeGeometry(vtkPolyData* output) const;

  /**
   * One value for each point; linear between samples at the edges of the map, where angles, in
   * degrees, go the shorter way round.
   */
  vtkSmartPointer<vtkDataArray> MakePointArray(
    const vtkTrajectorySource::Samples& samples, bool isAngle = false) const;

  /** One value for each line, from a variable per trajectory. */
  vtkSmartPointer<vtkDataArray> MakeCellArray(const vtkTrajectorySource::Samples& samples) const;

private:
  // Samples [FirstSample, EndSample) of a trajectory and, where the map's edges cut it, a point
  // between the sample at an end of the line and the neighbour of that sample beyond the edge.
  struct Line
  {
    static constexpr double NoPoint = -1.0;

    vtkIdType Trajectory;
    vtkIdType FirstSample;
    vtkIdType EndSample;
    vtkIdType FirstPoint;
    double Head = NoPoint; // fraction of the way from FirstSample to the sample before it
    double Tail = NoPoint; // fraction of the way from the last sample to EndSample
  };

  void AddTrajectory(vtkIdType trajectory, vtkIdType numberOfSamples);
  bool IsValid(vtkIdType trajectory, vtkIdType sample);
  vtkVector3d GetPosition(vtkIdType trajectory, vtkIdType sample) const;
  double GetEdge(double side) const;
  void BeginLine(vtkIdType trajectory, vtkIdType sample);
  void CutLine(const vtkVector3d& inside, const vtkVector3d& outside);

  // Call visit(line, point, sample, neighbour, fraction) for every point, the lines in parallel.
  template <typename Visitor>
  void ForEachPoint(Visitor&& visit) const;

  template <typename Array>
  vtkSmartPointer<vtkDataArray> GatherPoints(
    Array* values, const vtkTrajectorySource::Samples& samples, bool isAngle) const;

  Coordinates Source;
  Map Projection;
  VerticalAxis Axis;
  vtkNew<vtkPoints> Points;
  std::vector<Line> Lines;
  vtkIdType NumberOfInvalidSamples = 0;
};

VTK_ABI_NAMESPACE_END
#endif
