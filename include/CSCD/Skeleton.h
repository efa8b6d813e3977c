// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve skeleton as plain arrays.

#ifndef CSCD_SKELETON_H
#define CSCD_SKELETON_H

#include <CSCD/Vector3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD {

/// A curve skeleton as plain arrays: nodes and straight edges, in the coordinates and the unit of the input. All
/// measures, readers and writers work on it; a Boost graph is converted at the boundary.
struct Skeleton
{
  std::vector<Vector3> points;                ///< the positions of the nodes
  std::vector<double> radii{};                ///< mean distance of each node to the surface around it; empty if unknown
  std::vector<std::array<Index, 2>> edges{};  ///< the two nodes of each edge, counted from 0
  std::vector<char> is_joined{};              ///< for each edge, whether it was added to join components
  std::vector<char> is_opening{};             ///< for each node, whether a limb ends there at a border; may be empty
  std::vector<double> significance{};         ///< one for each edge, see `compute_significance()`; may be empty
  std::vector<std::vector<Index>> vertices{}; ///< for each node, the input vertices that belong to it; may be empty
  std::vector<std::vector<Vector3>> separators{}; ///< the packed separators as closed polygons; may be empty

  /// The number of nodes.
  std::size_t number_of_nodes() const { return points.size(); }
  /// Whether the radii are known.
  bool has_radii() const { return radii.size() == points.size(); }
  /// The length of `edge`, in the unit of the input.
  double length(const std::array<Index, 2>& edge) const { return (points[edge[1]] - points[edge[0]]).norm(); }
};

} // namespace CSCD

#endif // CSCD_SKELETON_H
