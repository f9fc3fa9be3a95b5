// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The actors of a frame whose opacities follow from importance, and their segments, as tables for
 * the shaders of vtkSegmentOpacities. Needs no OpenGL.
 *
 * Opacities are numbered through all actors: number 0 is that of everything that takes no part,
 * then follow the segments of each actor, then the corners of all triangles that interpolate
 * between segments. A part of an actor with vtkOcclusionAvoidance is one segment, with no
 * neighbours and no corners, through which its fragments find their actor.
 */

#ifndef vtkOptimizedScene_h
#define vtkOptimizedScene_h

#include "vtkType.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkAbstractMapper;
class vtkImportanceDrivenOpacity;
class vtkMapper;
class vtkPolyData;
class vtkProp;

class vtkOptimizedScene
{
public:
  /** Of Parameters::Avoids; 0 where the opacities of the actor are optimised. */
  enum AvoidanceBits : std::uint32_t
  {
    AvoidsByPenalty = 1,
    AvoidsByWeighting = 2,
    SmoothsAttributes = 4
  };

  /** Parameters of one actor, as glsl/vtkSegmentTablesDec.glsl has them. */
  struct Parameters
  {
    ///@{
    /** Of vtkOpacityOptimization. */
    float OcclusionWeight = 0.0f;
    float ClutterWeight = 0.0f;
    float Exponent = 1.0f;
    std::uint32_t SmoothingIterations = 0;
    std::uint32_t SelfOcclusion = 0;
    ///@}

    ///@{
    /** Of vtkOcclusionAvoidance. */
    std::uint32_t Avoids = 0;
    float Penalty = 1.0f;
    float ImportanceWeight = 0.0f;
    float CoverageWeight = 0.0f;
    float VarianceWeight = 0.0f;
    float DepthWeight = 0.0f;
    float Lambda = 1.0f;
    float GlobalOpacity = 1.0f;
    ///@}
  };

  /** Where the opacities of a part of an actor, one vtkPolyData, begin. */
  struct Part
  {
    vtkPolyData* Data = nullptr; ///< compared, never used: it may be gone
    std::uint32_t FirstSegment = 0;
    std::uint32_t NumberOfSegments = 0;
    bool HasImportance = false;    ///< has the array that the settings name
    bool HasCorners = false;       ///< point 3 t + c is corner c of triangle t
    std::uint32_t FirstCorner = 0; ///< in GetCorners()
  };

  /** One actor that takes part. */
  struct Member
  {
    vtkImportanceDrivenOpacity* Settings = nullptr;
    bool Avoids = false;     ///< the settings are a vtkOcclusionAvoidance
    std::vector<Part> Parts; ///< one at least
    std::string MappedArray; ///< that VTK's mapper brings to the graphics memory

    /** What that mapper draws; where that is unknown, number 0, what takes no part. */
    Part FindPart(vtkAbstractMapper* mapper) const;
  };

  /** Segments of a corner, nearest first, and their shares in its opacity. */
  struct Corner
  {
    std::uint32_t Segments[4];
    float Weights[4];
  };

  /** What has changed in the tables, each with what comes before it. */
  enum class Change
  {
    None,
    Settings, ///< GetParameters(), and importances
    Segments  ///< all
  };

  /** Take the actors among the props that are visible. Returns what is not as it was before. */
  Change Update(const std::vector<vtkProp*>& props);

  /**
   * Whether an optimisation can fade anything: one of its actors has a weight above 0, and the
   * importances of its actors are not all the same.
   */
  bool HasOptimization() const;

  /** Whether occlusion avoidance can fade anything: an actor's factors can differ from 1. */
  bool HasAvoidance() const;

  /** Whether it smooths the attributes of pixels, for any actor. */
  bool SmoothsPixels() const;

  /** Whether any actor takes part. */
  bool HasMembers() const { return !this->Members.empty(); }

  /** The entry of a prop; null when it takes no part. */
  const Member* Find(vtkProp* prop) const;

  int GetSmoothingIterations() const;

  ///@{
  /** Tables. The first element of the first three is that of what takes no part. */
  const std::vector<Parameters>& GetParameters() const { return this->ActorParameters; }
  const std::vector<std::uint32_t>& GetActors() const { return this->ActorOfSegment; }
  const std::vector<std::uint32_t>& GetFirstNeighbors() const { return this->FirstNeighbors; }
  const std::vector<std::uint32_t>& GetNeighbors() const { return this->Neighbors; }
  const std::vector<Corner>& GetCorners() const { return this->Corners; }
  ///@}

  vtkIdType GetNumberOfSegments() const
  {
    return static_cast<vtkIdType>(this->ActorOfSegment.size());
  }

  /** Make VTK's mappers bring importances to the graphics memory, as vertex attributes. Those that
   * do so already are not touched: it makes them upload all data anew. */
  void MapImportances();

  ///@{
  /** Importance arrays that the data of an actor lacks, and classes of mappers that cannot bring
   * importances; each is told once, as long as it is so. */
  std::vector<std::string> TakeMissingArrays() { return this->MissingArrays.Take(); }
  std::vector<std::string> TakeUnsupportedMappers() { return this->UnsupportedMappers.Take(); }
  ///@}

  /** Whether a poly data mapper draws something else than the cells of its input. */
  static bool DrawsImpostors(vtkMapper* mapper);

  /** Whether the arrays of vtkTrajectorySegments are there. */
  static bool HasLineSegments(vtkPolyData* data);

  /** Segments of a part: as its arrays say, or 1. */
  static std::uint32_t CountSegments(vtkPolyData* data);

private:
  struct Source
  {
    vtkProp* Prop;
    vtkMapper* Mapper;
    vtkImportanceDrivenOpacity* Settings;
    vtkMTimeType SettingsTime;
    bool Optimizes; ///< the settings are a vtkOpacityOptimization: there are segments
    std::vector<vtkPolyData*> Leaves;
    std::vector<vtkMTimeType> LeafTimes;

    /** Whether the segments of the other are the same. */
    bool HasSegmentsOf(const Source& other) const;
  };

  /** Names that are told once. */
  class Complaints
  {
  public:
    void Set(const std::set<std::string>& names);
    std::vector<std::string> Take();

  private:
    std::set<std::string> Names;
    std::set<std::string> Told;
  };

  void ClearSegments();
  void AddSettings();
  void AddActor(const Source& source);
  void AddSegments(vtkPolyData* data, std::uint32_t actor, Part& part);
  void AddLoneSegment(std::uint32_t actor, Part& part);
  void AddLineNeighbors(vtkPolyData* data, std::uint32_t count, std::uint32_t first);
  void AddSurfaceNeighbors(vtkPolyData* data, std::uint32_t count, std::uint32_t first);
  void AddCorners(vtkPolyData* data, Part& part);
  void AddImportances(const Source& source, std::set<std::string>& missing);

  std::vector<Source> Sources;
  std::map<vtkProp*, Member> Members;
  std::vector<Parameters> ActorParameters;
  std::vector<std::uint32_t> ActorOfSegment;
  std::vector<std::uint32_t> FirstNeighbors;
  std::vector<std::uint32_t> Neighbors;
  std::vector<Corner> Corners;
  Complaints MissingArrays;
  Complaints UnsupportedMappers;

  // Of the points of the actors whose opacities are optimised.
  std::optional<double> FirstImportance;
  bool ImportancesDiffer = false;
};

VTK_ABI_NAMESPACE_END
#endif
