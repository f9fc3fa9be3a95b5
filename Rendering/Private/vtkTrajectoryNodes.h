// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryNodes
 * @brief   The lines and vertices of some vtkPolyData as one array of nodes for a shader.
 *
 * A node is a point with a radius; a run is the sequence of nodes of one cell. A node that is
 * joined to the next one begins a segment. Nodes hold what is left after cleaning:
 * - consecutive coincident points of a line are one node;
 * - a line of which one point is left is a single node, drawn as a ball, as vertices are;
 * - points or radii that are not finite are left out and split their line
 * (GetNumberOfInvalidPoints);
 * - negative radii count as 0.
 *
 * Points are single precision relative to the middle of their bounds. Where the radii are too small
 * for that, GetRemainders() holds what rounding has taken off.
 *
 * Cost: one pass over the points for extent and length, one to write; 24 bytes for each node,
 * 40 with remainders.
 */

#ifndef vtkTrajectoryNodes_h
#define vtkTrajectoryNodes_h

#include "vtkBoundingBox.h" // for the bounds
#include "vtkDisplayedLeaf.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkTrajectoryNodes
{
public:
  using Leaf = vtkDisplayedLeaf;

  /** The nodes of one cell, from FirstNode to the FirstNode of the next run. */
  struct Run
  {
    vtkIdType FirstNode;
    vtkIdType Cell; ///< cell id in its leaf
    std::size_t Leaf;
  };

  /** Four floats of a node: point minus GetCenter(); radius, negated when joined to the next node.
   */
  using Node = std::array<float, 4>;

  /** Take the lines and vertices of `leaves`. `radius` 0 derives one from the data; a one-component
   * point array `radiusArray`, where a leaf has it, replaces it. */
  void Build(std::vector<Leaf> leaves, double radius, const std::string& radiusArray);

  /** The same leaves, displayed otherwise. Nodes do not depend on it. */
  void UpdateDisplay(std::vector<Leaf> leaves) { this->Leaves = std::move(leaves); }

  const std::vector<Leaf>& GetLeaves() const { return this->Leaves; }
  const std::vector<Run>& GetRuns() const { return this->Runs; }
  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  /** Three floats to add to each node's point (the fourth is 0); empty where they do not matter. */
  const std::vector<Node>& GetRemainders() const { return this->Remainders; }

  /** Point id, in its leaf, of each node. */
  const std::vector<vtkIdType>& GetPointIds() const { return this->PointIds; }

  vtkIdType GetNumberOfNodes() const { return static_cast<vtkIdType>(this->Nodes.size()); }

  /** The run that holds a node. \pre 0 <= node < GetNumberOfNodes() */
  const Run& GetRun(vtkIdType node) const;

  /** The first node of a leaf; with the number of leaves, that of nodes. */
  vtkIdType GetFirstNode(std::size_t leaf) const { return this->FirstNodes[leaf]; }

  /** What was subtracted from the points: the middle of their bounds. */
  const std::array<double, 3>& GetCenter() const { return this->Center; }

  /** Bounds of the balls of a leaf; not valid when it has no node. */
  const vtkBoundingBox& GetBounds(std::size_t leaf) const { return this->Bounds[leaf]; }

  ///@{
  /** Bounds of the points alone, and the largest radius. */
  const vtkBoundingBox& GetPointBounds() const { return this->PointBounds; }
  double GetMaximumRadius() const { return this->MaximumRadius; }
  ///@}

  /** The constant radius: as given to Build(), or derived. */
  double GetRadius() const { return this->Radius; }

  /** Leaves whose radius array was left out because it has not one component. */
  vtkIdType GetNumberOfBadRadiusArrays() const { return this->NumberOfBadRadiusArrays; }

  /** Points left out because a coordinate or the radius is not finite. */
  vtkIdType GetNumberOfInvalidPoints() const { return this->NumberOfInvalidPoints; }

private:
  class Extent;

  void ComputeRemainders();
  void AddCell(std::size_t leaf, vtkDataArray* radii, vtkIdType count, const vtkIdType* points);

  std::vector<Leaf> Leaves;
  std::vector<vtkIdType> FirstNodes;  ///< of each leaf, and at last the number of nodes
  std::vector<vtkBoundingBox> Bounds; ///< of each leaf
  std::vector<Run> Runs;
  std::vector<Node> Nodes;
  std::vector<Node> Remainders;
  std::vector<vtkIdType> PointIds;
  std::array<double, 3> Center{ { 0.0, 0.0, 0.0 } };
  vtkBoundingBox PointBounds;
  double MinimumRadius = VTK_DOUBLE_MAX; ///< of those above 0
  double MaximumRadius = 0.0;
  vtkIdType NumberOfBadRadiusArrays = 0;
  double Radius = 0.0;
  vtkIdType NumberOfInvalidPoints = 0;
};

VTK_ABI_NAMESPACE_END
#endif
