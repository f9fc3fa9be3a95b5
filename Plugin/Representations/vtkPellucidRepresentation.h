// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPellucidRepresentation
 * @brief   ParaView's representation "Pellucid": trajectories as tubes, transparency exact, and
 *          opacities that show what is important.
 *
 * Lines are drawn as tubes and vertices as spheres by vtkTrajectoryMapper, polygons as always.
 * Colouring, opacity, lighting, blocks, selection and delivery of data are those of the superclass.
 *
 * A render view that shows at least one visible representation of this kind draws all its
 * translucent geometry exactly, that of other representations too: its renderer is installed by
 * vtkTransparencyInstaller when the first of them becomes visible, and given back to ParaView when
 * the last one is hidden or removed.
 *
 * With an importance array, what hides more important things fades. The data are then divided into
 * segments where they are drawn, once (vtkSegmentedGeometry), levels of detail are off, since they
 * have other segments, and everything else is settings of the next frame. The parameters are those
 * of vtkOpacityOptimization and vtkOcclusionAvoidance, which describe them.
 *
 * Where a server of several processes renders and one of these representations is translucent, the
 * first process draws all geometry of the view, that of other representations too: only so the
 * picture is the exact one, and opacities follow from all fragments. It costs that all processes,
 * and a client, get all of the data. Without that (SetDrawOnOneProcess()) each process draws its
 * own part and ParaView composites the pictures: layers of different parts may come in the wrong
 * order, and importance counts only within a part. GetSeesAllFragments() tells, and a warning.
 *
 * What concerns the whole view (gather scale, memory limit, what the view shows) may be set in any
 * of its visible representations: what is not the default counts, of several values the greatest.
 *
 * @par Reference
 * None: an interface to the classes that it names, which name theirs.
 *
 * @sa vtkTrajectoryMapper vtkTransparencyInstaller vtkOpacityOptimization vtkOcclusionAvoidance
 */

#ifndef vtkPellucidRepresentation_h
#define vtkPellucidRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h"                           // for the parameters
#include "vtkPellucidRepresentationsModule.h" // for the export macro
#include "vtkWeakPointer.h"                   // for the view

#include <array>  // for the range
#include <string> // for texts
#include <vector> // for the displays of a view

VTK_ABI_NAMESPACE_BEGIN

class vtkExactTransparencyPass;
class vtkOcclusionAvoidance;
class vtkOpacityOptimization;
class vtkPVRenderView;
class vtkSegmentedGeometry;
class vtkSegmentedTrajectoryMapper;
class vtkTransparencyStatistics;

class VTKPELLUCIDREPRESENTATIONS_EXPORT vtkPellucidRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkPellucidRepresentation* New();
  vtkTypeMacro(vtkPellucidRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Radius of tubes and spheres in world units, >= 0; 0 (default): chosen from the extent of the
   * data and the number of lines. */
  void SetRadius(double radius);

  /** Point array with one component that holds the radius in world units; empty or "None"
   * (default): the constant Radius. */
  void SetRadiusArray(const char* name);

  /**
   * Point array with one component that tells how important each point is; empty or "None"
   * (default): opacities stay as they are. Only the name counts of the arguments.
   */
  void SetImportanceArray(int, int, int, int, const char* name);

  ///@{
  /**
   * Values of the array that mean importance 0 and 1; reversed, small values are important. While
   * AutomaticImportanceRange is on (default), it is the 50th to the 99th percentile of the array,
   * or 0 to 1 if the array is called "Importance". GetUsedImportanceRange() is what was drawn last.
   */
  void SetImportanceRange(double first, double second)
  {
    this->ImportanceRange = { first, second };
  }
  void SetAutomaticImportanceRange(bool automatic) { this->AutomaticImportanceRange = automatic; }
  double* GetUsedImportanceRange() VTK_SIZEHINT(2) { return this->UsedImportanceRange.data(); }
  ///@}

  /** How opacities follow from importance. */
  enum OpacityMethods
  {
    OPTIMIZATION = 0,
    PENALTY = 1,
    WEIGHTING = 2
  };
  /** Default is OPTIMIZATION. */
  void SetOpacityMethod(int method) { this->OpacityMethod = method; }

  ///@{
  /**
   * Settings of the optimisation: one of those of vtkOpacityOptimization::GetPresetName(), which
   * surfaces take with fewer smoothing steps, or, with the number behind the last, the four below
   * as they are. Default is 0. The strength, at least 0 (the panel ends at 10), is a factor on q
   * and r; default 1.
   */
  void SetOpacityPreset(int preset) { this->OpacityPreset = preset; }
  void SetOpacityStrength(double strength) { this->OpacityStrength = strength; }
  ///@}

  ///@{
  /** Of vtkOpacityOptimization, with its ranges and defaults; the first four have an effect without
   * a preset. */
  void SetOcclusionWeight(double weight);
  void SetClutterWeight(double weight);
  void SetEmphasis(double emphasis);
  void SetSmoothingIterations(int iterations);
  void SetSelfOcclusion(bool occludes);
  ///@}

  ///@{
  /** Of vtkOcclusionAvoidance, with its ranges and defaults. */
  void SetPenalty(double penalty);
  void SetImportanceWeight(double weight);
  void SetCoverageWeight(double weight);
  void SetDirectionalVarianceWeight(double weight);
  void SetDepthWeight(double weight);
  void SetImportanceExponent(double exponent);
  void SetGlobalOpacity(double opacity);
  void SetSmoothAttributes(bool smooth);
  ///@}

  /** Of all lines together; 0 (default): chosen from the data. */
  void SetNumberOfSegments(int segments);

  /** Whether one of several rendering processes draws all where this is translucent. Default is on.
   * Without effect where other processes (pvdataserver) have the data. */
  void SetDrawOnOneProcess(bool one) { this->DrawOnOneProcess = one; }

  ///@{
  /** Of vtkExactTransparencyPass, with its ranges and defaults, for the whole view. */
  void SetGatherScale(int scale) { this->Settings.GatherScale = scale; }
  void SetMemoryLimit(int mebibytes) { this->Settings.MemoryLimit = mebibytes; }
  void SetPictureView(int view) { this->Settings.PictureView = view; }
  void SetPictureLayer(int layer) { this->Settings.PictureLayer = layer; }
  ///@}

  ///@{
  /** Of the view's last frame in this process (vtkSMPellucidRepresentationProxy asks the one that
   * draws); 0 before the first, and while it is not exact. */
  vtkIdType GetFragments();
  vtkIdType GetSolvedFragments();
  vtkIdType GetLongestList();
  vtkIdType GetBufferBytes();
  ///@}

  /** Stages of the view's last frame and their milliseconds, such as "gather 12.1, sort 3.4". */
  const char* GetStageTimes();

  /** Whether the view's last frame was drawn by a server, if there is one. */
  bool IsDrawnOnServer() const;

  /** Whether one process has had all fragments of the view's last frame. */
  bool GetSeesAllFragments();

  void SetVisibility(bool visible) override;
  void SetSuppressLOD(bool suppress) override;

  /** Selections are by ids: names of arrays are refused, with a warning. (The superclass of
   * ParaView 5.11 takes its mapper for one of VTK's.) */
  void SetArrayIdNames(const char* points, const char* cells) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* type, vtkInformation* input, vtkInformation* output) override;

protected:
  vtkPellucidRepresentation();
  ~vtkPellucidRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  bool NeedsOrderedCompositing() override;

private:
  vtkPellucidRepresentation(const vtkPellucidRepresentation&) = delete;
  void operator=(const vtkPellucidRepresentation&) = delete;

  vtkSegmentedTrajectoryMapper* GetMapper();
  vtkSegmentedGeometry* GetSegments();
  bool HasImportance();
  struct ViewSettings
  {
    int GatherScale = 1;
    int MemoryLimit = 1024;
    int PictureView = 0;
    int PictureLayer = 1;

    void Merge(const ViewSettings& other);
  };

  void LeaveView();
  void UpdateTransparency();
  vtkExactTransparencyPass* GetPass();
  vtkTransparencyStatistics* GetStatistics();
  vtkIdType GetStatistic(vtkIdType (vtkTransparencyStatistics::*get)());
  void UpdatePass();
  bool DrawsElsewhere() const;
  void ChooseProcess(vtkInformation* input);
  void ReleaseOtherDisplays();
  std::vector<vtkPellucidRepresentation*> GetDisplays();
  void UpdateBounds(vtkInformation* input);
  double GetLargestRadius(double diagonal);
  void UpdateBlocks(bool changed);
  void UpdateOpacity();
  void UpdateOptimization();
  void WarnOfOtherProcesses();

  vtkWeakPointer<vtkPVRenderView> View;
  vtkNew<vtkOpacityOptimization> Optimization;
  vtkNew<vtkOpacityOptimization> OwnOptimization; // without a preset
  vtkNew<vtkOcclusionAvoidance> Avoidance;

  std::array<double, 2> ImportanceRange{ { 0.0, 1.0 } };
  std::array<double, 2> UsedImportanceRange{ { 0.0, 1.0 } };
  bool AutomaticImportanceRange = true;
  int OpacityMethod = OPTIMIZATION;
  int OpacityPreset = 0;
  double OpacityStrength = 1.0;
  ViewSettings Settings;
  bool WantsNoLOD = false;
  bool DrawOnOneProcess = true;
  bool DrawsOnFirst = false; // of several processes, in this frame

  // Of the mapper and the one for levels of detail: when the attributes of blocks were set.
  std::array<vtkTimeStamp, 2> BlockTimes;
  std::array<bool, 2> BlocksOutdated{};

  bool WarnedOfOtherProcesses = false;
  std::string StageTimes;
};

VTK_ABI_NAMESPACE_END
#endif
