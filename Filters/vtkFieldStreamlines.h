// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFieldStreamlines
 * @brief   Seed a vector field and trace one streamline through every seed.
 *
 * Input: any vtkDataSet, or composite data of them, with a three-component array on the points or
 * the cells. The array is chosen with SetInputArrayToProcess(0, ...); by default it is the
 * active vectors or, where there are none, the first array of three components, on the points
 * before the cells.
 *
 * Output: vtkPolyData with one polyline of two or more points for each seed, its points in
 * flow direction, traced by vtkStreamTracer (Runge-Kutta 4/5, adaptive step). The parts upstream
 * and downstream of a seed are joined into one line, so that translucent lines have no
 * extra caps in their middle. The arrays are those of vtkStreamTracer:
 *
 * - point data: all point arrays of the input (with cell vectors: these too) and
 *   "IntegrationTime", in units of length over speed, 0 at the seed and negative upstream of it;
 * - cell data: "SeedIds", and "ReasonForTermination" in two components, where the line begins and
 *   where it ends (vtkStreamTracer::ReasonForTermination; NOT_INITIALIZED for a direction that
 *   is not traced).
 *
 * Seeding is deterministic: the same input and properties give the same bits, with any number
 * of threads. Cells that are blanked, that touch a blanked point, or that touch a
 * vector with a NaN or infinite component belong to the outside of the domain. Cells of two
 * dimensions keep their lines on the surface.
 *
 * A line that ends by circling a point, within 1/500 of the bounding box's diagonal of it and over
 * more than 4 times that length, is cut where it begins to: the rest would show as one dot of
 * thousands of layers.
 *
 * Errors: no vectors (the message names the arrays that exist). Warnings: no seed inside the
 * domain, no line of two points (a field that is zero at every seed); both leave an empty output.
 * Progress is reported, and an abort obeyed, at about every hundredth of the seeds.
 *
 * Limits: as vtkStreamTracer, coordinates are stored in single precision. Invalid cells cost a copy
 * of the valid ones as an unstructured grid.
 *
 * @par Reference
 * None: vtkStreamTracer traces; the seeds in a volume are the sequence of J. Halton, 1960.
 *
 * @sa vtkStreamTracer vtkTrajectoryMapper
 */

#ifndef vtkFieldStreamlines_h
#define vtkFieldStreamlines_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the seeds

#include <string> // for the array's name

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldVectors;
class vtkPoints;

class VTKPELLUCIDFILTERS_EXPORT vtkFieldStreamlines : public vtkPolyDataAlgorithm
{
public:
  static vtkFieldStreamlines* New();
  vtkTypeMacro(vtkFieldStreamlines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Where the seeds lie. */
  enum SeedingModes
  {
    VOLUME = 0, // the Halton sequence of the bounding box, as far as it lies inside cells
    POINTS = 1, // points of the input, evenly spread over their ids
    GRID = 2,   // a regular lattice of nearly cubic cells in the bounding box, as far as inside
    LINE = 3    // evenly spaced from Point1 to Point2
  };

  ///@{
  /**
   * Seeds to place, at least 1. VOLUME places exactly that many unless the cells fill less
   * than a thousandth of the bounding box, POINTS at most one at each point; GRID and LINE lose
   * those outside. Default is 1000. The time of tracing is proportional to it.
   */
  vtkSetClampMacro(NumberOfSeeds, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(NumberOfSeeds, vtkIdType);
  ///@}

  ///@{
  /**
   * Where the seeds lie. Default is VOLUME, the bases of the Halton sequence being 2, 3 and 5 (J.
   * H. Halton, Numerische Mathematik 2, 1960); on a curved surface, which has no volume, VOLUME
   * does what POINTS does.
   */
  vtkSetClampMacro(SeedingMode, int, VOLUME, LINE);
  vtkGetMacro(SeedingMode, int);
  void SetSeedingModeToVolume() { this->SetSeedingMode(VOLUME); }
  void SetSeedingModeToPoints() { this->SetSeedingMode(POINTS); }
  void SetSeedingModeToGrid() { this->SetSeedingMode(GRID); }
  void SetSeedingModeToLine() { this->SetSeedingMode(LINE); }
  ///@}

  ///@{
  /**
   * Elements of the sequence to skip, for another set of seeds of the same kind; VOLUME and POINTS
   * only. Default is 0.
   */
  vtkSetClampMacro(SeedOffset, vtkIdType, 0, VTK_INT_MAX);
  vtkGetMacro(SeedOffset, vtkIdType);
  ///@}

  ///@{
  /**
   * Ends of the seeding line in world coordinates; both the origin (the default) means the
   * diagonal of the bounding box. LINE only.
   */
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /**
   * vtkStreamTracer::FORWARD, BACKWARD or BOTH from the seed. Default is BOTH.
   */
  vtkSetClampMacro(IntegrationDirection, int, 0, 2);
  vtkGetMacro(IntegrationDirection, int);
  ///@}

  ///@{
  /**
   * Length in world units, at least 0, after which a line ends, in each direction from its seed; 0
   * (the default) is half the diagonal of the bounding box.
   */
  vtkSetClampMacro(MaximumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumLength, double);
  ///@}

  ///@{
  /**
   * Steps after which a line ends, in each direction from its seed, at least 1. Default is 2000.
   */
  vtkSetClampMacro(MaximumNumberOfSteps, vtkIdType, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfSteps, vtkIdType);
  ///@}

  ///@{
  /**
   * Speed below which a line ends, as a fraction of the greatest speed in the field, in [0, 1].
   * Default is 1e-6.
   */
  vtkSetClampMacro(TerminalSpeedFraction, double, 0.0, 1.0);
  vtkGetMacro(TerminalSpeedFraction, double);
  ///@}

  /** Name of the array that the last update traced; empty when there was none. */
  std::string GetVectorsName() { return this->VectorsName; }

protected:
  vtkFieldStreamlines();
  ~vtkFieldStreamlines() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFieldStreamlines(const vtkFieldStreamlines&) = delete;
  void operator=(const vtkFieldStreamlines&) = delete;

  vtkSmartPointer<vtkPoints> PlaceSeeds(const vtkFieldVectors& field);
  void Trace(vtkFieldVectors& field, vtkPoints* seeds, vtkPolyData* output);

  vtkIdType NumberOfSeeds = 1000;
  int SeedingMode = VOLUME;
  vtkIdType SeedOffset = 0;
  double Point1[3] = { 0.0, 0.0, 0.0 };
  double Point2[3] = { 0.0, 0.0, 0.0 };
  int IntegrationDirection = 2; // vtkStreamTracer::BOTH
  double MaximumLength = 0.0;
  vtkIdType MaximumNumberOfSteps = 2000;
  double TerminalSpeedFraction = 1e-6;
  std::string VectorsName;
};

VTK_ABI_NAMESPACE_END
#endif
