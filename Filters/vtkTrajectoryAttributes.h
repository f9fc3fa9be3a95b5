// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryAttributes
 * @brief   What tells one trajectory, or one part of it, from another: ascent, bending, velocity.
 *
 * Input: vtkPolyData (or composite data of them, block by block) with polylines. Output: the same
 * with these arrays of one component in single precision, after M. Bandle, "Opacity-Based Rendering
 * of Lagrangian Particle Trajectories in Met.3D", 2016, section 3.1:
 *
 * - "TotalPressureDifference", cell data, in the unit of the pressure: greatest minus least
 *   pressure of the trajectory, or with a TimeWindow of any two of its points at most that far
 *   apart in time;
 * - "SegmentPressureDifference", point data, in the unit of the pressure: pressure at the start
 *   minus pressure at the end of the segment; positive where it rises;
 * - "SegmentHeightDifference", point data, in the unit of the height: height at the end minus
 *   height at the start of the segment;
 * - "TurningAngle", point data, degree, 0 to 180: between the segments before and after the point,
 *   0 at both ends of a line;
 * - "Curvature", point data, 1 / length: the turning angle in radian divided by the mean length of
 *   these two segments;
 * - "SegmentLength", point data, length;
 * - "Velocity", point data, length / time: the segment's length divided by its time step;
 * - "AngleOfAscent", point data, degree, -90 to 90: between the segment and the plane normal to
 *   UpAxis, positive upwards. Always of the coordinates, also where a height array is chosen.
 *
 * Readers divide a trajectory at gaps and at the edges of a map, and write which one a line is part
 * of: successive lines with the same "TrajectoryId" in the cell data count as one trajectory, of
 * which "TotalPressureDifference" has one value for all of them. Without that array, of one
 * component, each line is a trajectory. The attributes of points are those of the line.
 *
 * Lengths are those of the coordinates. On a map, the output of vtkGeographicTrajectoryReader, x
 * and y are degrees and z is what its VerticalScale makes of the height: there "SegmentLength",
 * "Velocity", "Curvature" and "AngleOfAscent", and "SegmentHeightDifference" without a HeightArray,
 * are in units of the map, change with that scale and with latitude, and are no physical
 * quantities. Pressure differences, and heights from a HeightArray such as "geopotential_height",
 * are.
 *
 * A value of a segment is stored at the point where the segment begins; the last point of a line
 * repeats that of the last segment. Cells that are not lines, and points that belong to no line,
 * have NaN. An array's vtkDataArray::UNITS_LABEL() is set where the unit is known. Arrays of the
 * same name in the input are replaced.
 *
 * Points that coincide with their neighbours: a segment without length has length, velocity and
 * angle of ascent 0; its points share one turning angle, that of the nearest segments with a length
 * on either side. A length without a time step has the largest float as its velocity, and so have
 * other results beyond the range of float. A line of one point has 0 everywhere. So finite input
 * gives finite output.
 *
 * Missing values: where a coordinate, pressure, height or time is NaN or infinite, the attributes
 * that need it are NaN at the point and, for those of segments, at the point before. Turning angle
 * and curvature take a point without position for an end of the line; "TotalPressureDifference"
 * leaves missing pressures out, and is NaN only for a trajectory without any.
 *
 * Points that lines share, or that a line uses twice such as a closed one, cannot hold the values
 * of both: then the output has a copy, with all point data, for each use but the first, after the
 * points of the input, without the point arrays that are too short to be copied, of which a
 * warning tells; else the geometry is passed by reference.
 *
 * Cost: one parallel pass over the points and one over the lines, all together in about twice the
 * time that a copy of the arrays takes (Testing/Benchmark/attributes.py). A trajectory whose
 * times are not in order is sorted for a TimeWindow. Same bits with any number of threads. Errors:
 * an array that is named or needed and does not exist, a cell with a point that does not exist.
 * Nothing is then computed.
 *
 * @par Reference
 * M. Bandle: Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D, 2016,
 * section 3.1.
 *
 * @sa vtkTrajectorySegments vtkTrajectoryReader
 */

#ifndef vtkTrajectoryAttributes_h
#define vtkTrajectoryAttributes_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <array>  // for the statuses
#include <string> // for names of arrays

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

class VTKPELLUCIDFILTERS_EXPORT vtkTrajectoryAttributes : public vtkPolyDataAlgorithm
{
public:
  static vtkTrajectoryAttributes* New();
  vtkTypeMacro(vtkTrajectoryAttributes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What can be computed, in the order of the list above. */
  enum Attributes
  {
    TOTAL_PRESSURE_DIFFERENCE,
    SEGMENT_PRESSURE_DIFFERENCE,
    SEGMENT_HEIGHT_DIFFERENCE,
    TURNING_ANGLE,
    CURVATURE,
    SEGMENT_LENGTH,
    VELOCITY,
    ANGLE_OF_ASCENT,
    NUMBER_OF_ATTRIBUTES
  };

  /** Whether an attribute is computed. */
  enum Statuses
  {
    OFF = 0,      // not computed
    ON = 1,       // computed; an error if that needs an array that does not exist
    AUTOMATIC = 2 // computed if the arrays that it needs exist
  };

  /** Axes of the coordinates. */
  enum Axes
  {
    X = 0,
    Y = 1,
    Z = 2
  };

  ///@{
  /**
   * The attributes: how many, the name of the array of each, where it is (vtkDataObject::POINT or
   * vtkDataObject::CELL), and the number of the one with a name, -1 if there is none.
   */
  static int GetNumberOfAttributes() { return NUMBER_OF_ATTRIBUTES; }
  static const char* GetAttributeName(int attribute);
  static int GetAttributeAssociation(int attribute);
  static int GetAttributeIndex(const char* name);
  ///@}

  ///@{
  /**
   * Which attributes are computed, by number or by the name of the array. Default is AUTOMATIC for
   * each: without arrays of pressure and time, those of the geometry.
   */
  void SetAttributeStatus(int attribute, int status);
  void SetAttributeStatus(const char* name, int status);
  void SetAllAttributeStatuses(int status);
  int GetAttributeStatus(int attribute);
  ///@}

  ///@{
  /**
   * Name of the point array, of one component, that is the pressure. Default is none: then the
   * first of "pressure", "p", "air_pressure" that exists, in small or capital letters.
   */
  vtkSetStdStringFromCharMacro(PressureArray);
  vtkGetCharFromStdStringMacro(PressureArray);
  ///@}

  ///@{
  /**
   * Name of the point array, of one component, that is the height. Default is none: then the
   * coordinate along UpAxis.
   */
  vtkSetStdStringFromCharMacro(HeightArray);
  vtkGetCharFromStdStringMacro(HeightArray);
  ///@}

  ///@{
  /**
   * Name of the point array, of one component, that is the time; it may decrease along a line.
   * Default is none: then the first of "time", "IntegrationTime" that exists, in small or
   * capital letters.
   */
  vtkSetStdStringFromCharMacro(TimeArray);
  vtkGetCharFromStdStringMacro(TimeArray);
  ///@}

  ///@{
  /**
   * The axis that points upwards, from X (0) to Z (2). Default is Z.
   */
  vtkSetClampMacro(UpAxis, int, X, Z);
  vtkGetMacro(UpAxis, int);
  void SetUpAxisToX() { this->SetUpAxis(X); }
  void SetUpAxisToY() { this->SetUpAxis(Y); }
  void SetUpAxisToZ() { this->SetUpAxis(Z); }
  ///@}

  ///@{
  /**
   * Greatest distance in time of the two points that TotalPressureDifference compares, in the unit
   * of the time array, which has to exist; up to a millionth more counts as equal. 0, the default,
   * is the whole trajectory. Warm conveyor belts are found with 48 hours (Bandle 2016,
   * section 3.1.1).
   */
  vtkSetClampMacro(TimeWindow, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeWindow, double);
  ///@}

protected:
  vtkTrajectoryAttributes();
  ~vtkTrajectoryAttributes() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTrajectoryAttributes(const vtkTrajectoryAttributes&) = delete;
  void operator=(const vtkTrajectoryAttributes&) = delete;

  struct Arrays;

  Arrays FindArrays(vtkPolyData* input) const;
  bool IsComputed(int attribute, const Arrays& arrays, vtkPolyData* input) const;
  bool ComputeOfPoints(const Arrays& arrays, vtkPolyData* output);
  bool ComputeTotalPressureDifference(const Arrays& arrays, vtkPolyData* output);

  std::array<int, NUMBER_OF_ATTRIBUTES> Statuses;
  std::string PressureArray;
  std::string HeightArray;
  std::string TimeArray;
  int UpAxis = Z;
  double TimeWindow = 0.0;
};

VTK_ABI_NAMESPACE_END
#endif
