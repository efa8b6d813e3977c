// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of the skeletonization of a tree.

#ifndef CSCD_TREE_TREE_REPORT_H
#define CSCD_TREE_TREE_REPORT_H

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CSCD {

/// The result of the attempt to fit a circle to the points around a node. Without one, center and radius are given by
/// the scatter of the points, by the circles around, and by what the limb carries.
enum class Circle_outcome
{
  fitted,     ///< there is one
  few_points, ///< too few points, or all on a line
  short_arc,  ///< too little of the circle is covered by points
  scattered,  ///< the points are too far from the circle: leaves, or noise as large as the limb is thin
  too_wide    ///< the circle is wider than the parent of the limb, or much wider than the scatter of the points
};

/// Number of values of `Circle_outcome`.
inline constexpr std::size_t number_of_circle_outcomes = 5;

/// The parent of a branch that has none: a trunk.
inline constexpr std::size_t no_branch = std::numeric_limits<std::size_t>::max();

/// A branch: a limb from where it leaves its parent to its tip, whatever grows from it. Lengths are in the unit of the
/// input.
struct Tree_branch
{
  std::size_t parent = no_branch; ///< the branch that it grows from, an earlier one; `no_branch` for a trunk
  std::size_t object = 0;         ///< the object that it belongs to
  std::size_t order = 0;          ///< centrifugal order: 0 for a trunk, one more than the parent's for any other branch
  std::size_t strahler_order = 1; ///< at the base: 1 for a branch without branches
  /// The vertices of the skeleton along the branch, base to tip. The first is the vertex of the parent that it grows
  /// from, or the root for a trunk.
  std::vector<std::size_t> nodes{};
  double length = 0;         ///< along the nodes
  double radius_at_base = 0; ///< at its first own node
  double radius_at_tip = 0;  ///< at its last node
  std::size_t number_of_sections =
      0;                             ///< nodes whose center and radius come from points: all but the first and the last
  std::size_t number_of_circles = 0; ///< of these, those where it is by a circle
};

/// A gap in the points that a branch goes on across.
struct Tree_gap
{
  std::array<double, 3> from{}; ///< a point
  std::array<double, 3> to{};   ///< and the nearest one beyond the gap
  double length = 0;            ///< the distance between the two
};

/// Counts, branches, gaps and warnings of the skeletonization of a scan of trees. Lengths are in the unit of the input.
struct Tree_report
{
  std::size_t number_of_points = 0;         ///< of the input
  std::size_t number_of_duplicates = 0;     ///< points that are at the place of another one
  std::size_t number_of_thinned_points = 0; ///< points nearer to others than noise allows, which stand for them
  std::size_t number_of_debris = 0;  ///< points of no object: they belong to the node of the nearest point that has one
  std::size_t number_of_objects = 0; ///< each is a tree of the skeleton
  double spacing = 0;                ///< median over the points of the mean distance to the nearest six
  std::vector<Tree_branch> branches; ///< parents before children
  std::vector<Tree_gap> gaps;        ///< that were bridged, the shortest first
  std::size_t number_of_nodes = 0;   ///< of the skeleton
  std::size_t number_of_edges = 0;   ///< of the skeleton
  /// How the sections of the branches were found, in the order of `Circle_outcome`.
  std::array<std::size_t, number_of_circle_outcomes> number_of_sections{};
  double seconds = 0;                ///< wall-clock time
  std::vector<std::string> warnings; ///< warnings for the user, one sentence each
};

} // namespace CSCD

#endif // CSCD_TREE_TREE_REPORT_H
