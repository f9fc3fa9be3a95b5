// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeographicTrajectoryReader
 * @brief   Base of the readers of trajectories in the atmosphere or the ocean, drawn on a map.
 *
 * Output: polylines with x = longitude and y = latitude in degrees, z as VerticalAxis says, in
 * single precision unless the file's coordinates are in double precision.
 *
 * - Point data: every variable of the file that has a value for each position or each time, among
 *   them longitude, latitude and pressure or height, with the names, numbers and units
 *   (vtkDataArray::UNITS_LABEL()) of the file. Single precision, but double where the file has
 *   doubles or integers of 32 bits or more. And "time" in double precision, in the unit that its
 *   label tells, such as "hours since 2011-01-15 12:00:00".
 * - Cell data: "TrajectoryId", the number of the trajectory in the file, from 0; and every variable
 *   that has one value for each trajectory.
 * - Variables that are not numeric, or of another shape, are left out.
 *
 * Gaps: positions of which longitude, latitude or the vertical coordinate is missing, NaN or
 * infinite are left out and split the trajectory into several lines; so do, with a warning that
 * counts them, positions with a pressure of 0 or less, a latitude beyond the poles, a longitude
 * beyond +- 36000 degrees, or a z beyond single precision. No line leads through a gap. A single
 * position between two gaps is a polyline of one point. A trajectory without any position has no
 * line.
 *
 * Missing is what equals _FillValue or else the default fill value of its type, or missing_value;
 * LAGRANTO's -999.99.
 *
 * Errors, besides those of vtkTrajectoryReader: EnsembleMember is not in the file (the message
 * tells the members); no pressure and no height; no such HeightArray; a unit of pressure or height
 * that is not known (the messages tell what there is).
 *
 * The file that UpdateInformation() has opened stays open for the next Update(), and is closed
 * after it. The lines are kept until the reader changes, so that another time does not cost another
 * reading. Memory: the output and three to four variables. Progress is reported after each
 * variable.
 *
 * @par Reference
 * None: what the files hold is described at each reader.
 *
 * @sa vtkMet3DReader vtkLagrantoNetCDFReader vtkLagrantoReader
 */

#ifndef vtkGeographicTrajectoryReader_h
#define vtkGeographicTrajectoryReader_h

#include "vtkNew.h"                   // for the lines of all times
#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkTimeStamp.h"             // for the time of reading
#include "vtkTrajectoryReader.h"

#include <memory> // for the open file

VTK_ABI_NAMESPACE_BEGIN
class vtkTrajectorySource;

class VTKPELLUCIDFILTERS_EXPORT vtkGeographicTrajectoryReader : public vtkTrajectoryReader
{
public:
  vtkTypeMacro(vtkGeographicTrajectoryReader, vtkTrajectoryReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The member of the ensemble to read, from 0. Default is 0.
   */
  vtkSetClampMacro(EnsembleMember, int, 0, VTK_INT_MAX);
  vtkGetMacro(EnsembleMember, int);
  ///@}

  /** Members in the file, 1 where it has no ensemble; known after UpdateInformation(), before it 0.
   */
  vtkGetMacro(NumberOfEnsembleMembers, int);

  /** What z is. */
  enum VerticalAxes
  {
    LOG_PRESSURE = 0, // z = VerticalScale * ln(1000 hPa / p)
    HEIGHT = 1        // z = VerticalScale * height in kilometres
  };

  ///@{
  /**
   * What z is. Default is LOG_PRESSURE; a file without pressure is read as HEIGHT.
   *
   * Pressure is the variable of standard name air_pressure or else named pressure, p, P,
   * air_pressure or plev, in Pa or hPa (mbar) as its attribute `units` says, in hPa
   * where it says nothing. Units are known in small and capital letters.
   */
  vtkSetClampMacro(VerticalAxis, int, LOG_PRESSURE, HEIGHT);
  vtkGetMacro(VerticalAxis, int);
  void SetVerticalAxisToLogPressure() { this->SetVerticalAxis(LOG_PRESSURE); }
  void SetVerticalAxisToHeight() { this->SetVerticalAxis(HEIGHT); }
  ///@}

  ///@{
  /**
   * The variable that HEIGHT takes, in m (also gpm) or km as its units say, in m where they say
   * nothing. Default is none: the one of standard name altitude, height or geopotential_height, or
   * else named height, z, altitude, alt or geopotential_height.
   */
  vtkSetStringMacro(HeightArray);
  vtkGetStringMacro(HeightArray);
  ///@}

  ///@{
  /**
   * Degrees for each unit of ln(1000 hPa / p), or for each kilometre of height. Default is 0, which
   * stands for 10 with LOG_PRESSURE (100 hPa are drawn at 23 degrees) and for 1 with HEIGHT.
   */
  vtkSetClampMacro(VerticalScale, double, 0.0, 1e6);
  vtkGetMacro(VerticalScale, double);
  ///@}

  /** What becomes of lines that cross the edge of the map. */
  enum LongitudeModes
  {
    UNWRAP = 0, // lines go on beyond the edge of the map
    CUT = 1     // lines are cut at the edges of the map
  };

  ///@{
  /**
   * What becomes of lines that cross an edge of the map. Default is UNWRAP: x begins with the
   * longitude in the file and never changes by more than 180 degrees from one position to the next,
   * over gaps too. CUT: x is within CentralLongitude +- 180, and a line that leaves the map ends
   * with a point on its edge and goes on, as another line, from a point on the other edge. These
   * points have the linear interpolation of all arrays.
   */
  vtkSetClampMacro(LongitudeMode, int, UNWRAP, CUT);
  vtkGetMacro(LongitudeMode, int);
  void SetLongitudeModeToUnwrap() { this->SetLongitudeMode(UNWRAP); }
  void SetLongitudeModeToCut() { this->SetLongitudeMode(CUT); }
  ///@}

  ///@{
  /**
   * The middle of the map in degrees, -360..360. Default is 0. CUT only.
   */
  vtkSetClampMacro(CentralLongitude, double, -360.0, 360.0);
  vtkGetMacro(CentralLongitude, double);
  ///@}

  /** Which positions are drawn when a time is requested. */
  enum TimeSelections
  {
    ALL_TIMES = 0,      // whole trajectories whatever time is requested
    UNTIL_REQUESTED = 1 // positions up to the time that the pipeline requests
  };

  ///@{
  /**
   * Which positions the output has. Default is ALL_TIMES. UNTIL_REQUESTED leaves those of "time"
   * greater than, or not comparable with, the pipeline's UPDATE_TIME_STEP out; all are there where
   * it requests no time. The pipeline's TIME_STEPS are the different times in the file.
   *
   * ALL_TIMES gives the same lines at every time. Yet the pipeline, which knows only that there are
   * time steps, executes all filters after the reader again at every step of an animation: take
   * their output once where they are slow.
   */
  vtkSetClampMacro(TimeSelection, int, ALL_TIMES, UNTIL_REQUESTED);
  vtkGetMacro(TimeSelection, int);
  void SetTimeSelectionToAllTimes() { this->SetTimeSelection(ALL_TIMES); }
  void SetTimeSelectionToUntilRequested() { this->SetTimeSelection(UNTIL_REQUESTED); }
  ///@}

protected:
  vtkGeographicTrajectoryReader();
  ~vtkGeographicTrajectoryReader() override;

  void ReadInformation(const std::string& fileName, vtkInformation* outInfo) override;
  void ReadTrajectories(
    const std::string& fileName, vtkInformation* outInfo, vtkPolyData* output) override;

  /** Open a file of the reader's format, see vtkTrajectorySource (Private/). Throws. */
  virtual std::unique_ptr<vtkTrajectorySource> Open(const std::string& fileName) = 0;

  /** The part of the time of an update that Open() takes, and reports as progress. Default: 0. */
  virtual double GetOpeningShare() const { return 0.0; }

private:
  vtkGeographicTrajectoryReader(const vtkGeographicTrajectoryReader&) = delete;
  void operator=(const vtkGeographicTrajectoryReader&) = delete;

  // The variable that z is made of.
  std::size_t FindVertical(const vtkTrajectorySource& source, bool& isPressure) const;

  // Whether it was not aborted.
  bool ReadAllTimes(vtkTrajectorySource& source, vtkPolyData* output);

  std::unique_ptr<vtkTrajectorySource> OpenSource; // from information to data, then null
  int EnsembleMember = 0;
  int NumberOfEnsembleMembers = 0;
  int VerticalAxis = LOG_PRESSURE;
  char* HeightArray = nullptr;
  double VerticalScale = 0.0;
  int LongitudeMode = UNWRAP;
  double CentralLongitude = 0.0;
  int TimeSelection = ALL_TIMES;
  vtkNew<vtkPolyData> AllTimes;
  vtkTimeStamp ReadTime;
};

VTK_ABI_NAMESPACE_END
#endif
