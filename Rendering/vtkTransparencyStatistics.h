// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTransparencyStatistics
 * @brief   What a vtkExactTransparencyPass did in its last frame.
 *
 * A value object: the pass fills it at the end of every frame, everyone else reads it. All counts
 * belong to the last frame; a frame without translucent geometry leaves them at 0 and runs no
 * stage. VTK's timer log has the times too, one event for each stage, "Pellucid gather" for
 * example: seconds of GPU time.
 *
 * @par Reference
 * None: counts and times.
 *
 * @sa vtkExactTransparencyPass
 */

#ifndef vtkTransparencyStatistics_h
#define vtkTransparencyStatistics_h

#include "vtkObject.h"
#include "vtkPellucidRenderingModule.h" // for the export macro

#include <string>  // for stage names
#include <utility> // for std::pair
#include <vector>  // for the list of stages

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDRENDERING_EXPORT vtkTransparencyStatistics : public vtkObject
{
public:
  static vtkTransparencyStatistics* New();
  vtkTypeMacro(vtkTransparencyStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Forget the last frame: every count 0, no stage. */
  void Reset();

  ///@{
  /** Translucent fragments that were stored and composited. Default is 0. */
  vtkSetMacro(Fragments, vtkIdType);
  vtkGetMacro(Fragments, vtkIdType);
  ///@}

  ///@{
  /** Fragments whose opacity was optimised, of those. Default is 0. */
  vtkSetMacro(SolvedFragments, vtkIdType);
  vtkGetMacro(SolvedFragments, vtkIdType);
  ///@}

  ///@{
  /** Fragments in the fullest pixel. Default is 0. */
  vtkSetMacro(LongestList, vtkIdType);
  vtkGetMacro(LongestList, vtkIdType);
  ///@}

  ///@{
  /** Bytes of graphics memory that the pass holds: nodes, list heads, counters, copies of the
   * opaque colour and depth. Default is 0. */
  vtkSetMacro(BufferBytes, vtkIdType);
  vtkGetMacro(BufferBytes, vtkIdType);
  ///@}

  ///@{
  /** Rectangles of the image that were gathered and resolved one after the other; 1 when all
   * fragments fit into the memory limit. Default is 0. */
  vtkSetMacro(Tiles, int);
  vtkGetMacro(Tiles, int);
  ///@}

  ///@{
  /** Times that the geometry was drawn: Tiles, and one more for each time that a buffer
   * turned out to be too small. Default is 0. */
  vtkSetMacro(GatherPasses, int);
  vtkGetMacro(GatherPasses, int);
  ///@}

  ///@{
  /** Props whose mapper takes no part in render passes, drawn with plain blending over the exact
   * result; those of vtkActor2D, which have no depth, are not counted. Default is 0. */
  vtkSetMacro(BlendedProps, int);
  vtkGetMacro(BlendedProps, int);
  ///@}

  ///@{
  /** Whether opacities are still on their way to those of the view: another frame comes nearer. See
   * vtkExactTransparencyPass::SetFadeTime(). Default is false. */
  vtkSetMacro(Fading, bool);
  vtkGetMacro(Fading, bool);
  ///@}

  /** Add milliseconds to a stage; the first call for a name makes the stage. */
  void AddStage(const std::string& name, double milliseconds);

  ///@{
  /** The stages that ran, in the order in which they first ran: name and time in milliseconds. */
  int GetNumberOfStages();
  std::string GetStageName(int stage);
  double GetStageMilliseconds(int stage);
  ///@}

  /** Milliseconds of the stage of that name; 0 when it did not run. */
  double GetStageMilliseconds(const std::string& name);

protected:
  vtkTransparencyStatistics() = default;
  ~vtkTransparencyStatistics() override = default;

private:
  vtkTransparencyStatistics(const vtkTransparencyStatistics&) = delete;
  void operator=(const vtkTransparencyStatistics&) = delete;

  vtkIdType Fragments = 0;
  vtkIdType SolvedFragments = 0;
  vtkIdType LongestList = 0;
  vtkIdType BufferBytes = 0;
  int Tiles = 0;
  int GatherPasses = 0;
  int BlendedProps = 0;
  bool Fading = false;
  std::vector<std::pair<std::string, double>> Stages;
};

VTK_ABI_NAMESPACE_END
#endif
