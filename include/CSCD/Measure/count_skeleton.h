// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a skeleton tells without its surface: topology, length, smoothness.

#ifndef CSCD_MEASURE_COUNT_SKELETON_H
#define CSCD_MEASURE_COUNT_SKELETON_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The angle by which the path a, b, c turns at b, from 0 to pi; 0 where two of the points are equal.
inline double turning_angle(const Vector_3& a, const Vector_3& b, const Vector_3& c)
{
  const Vector_3 before = b - a;
  const Vector_3 after = c - b;
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

/// Measures how much the branches turn: the sum of the turning angles at nodes of two edges, over the length of the
/// edges that touch such nodes, half for each end, in local radii.
inline void measure_turning(const Indexed_skeleton& skeleton, const std::vector<double>& radii,
                            const std::vector<std::vector<Index>>& neighbors, Skeleton_counts& counts)
{
  double sum = 0;
  double length = 0; // in radii
  for (std::size_t v = 0; v < neighbors.size(); ++v) {
    if (neighbors[v].size() != 2) {
      continue;
    }
    const Vector_3& a = skeleton.points[neighbors[v][0]];
    const Vector_3& b = skeleton.points[v];
    const Vector_3& c = skeleton.points[neighbors[v][1]];
    const double angle = turning_angle(a, b, c);
    counts.largest_turning = std::fmax(counts.largest_turning, angle);
    if (radii[v] > 0) {
      sum += angle;
      length += ((a - b).norm() + (c - b).norm()) / 2 / radii[v];
    }
  }
  if (length > 0) {
    counts.mean_turning = sum / length;
  }
}

/// Counts nodes, edges, components, cycles, tips and junctions, and measures length and turning. Near linear.
/// \param radii of the nodes, for the unit of the turning
inline Skeleton_counts count_skeleton(const Indexed_skeleton& skeleton, const std::vector<double>& radii)
{
  Skeleton_counts counts;
  counts.number_of_nodes = skeleton.number_of_nodes();
  counts.number_of_edges = skeleton.edges.size();
  counts.number_of_components = skeleton.number_of_nodes();
  Disjoint_sets sets(skeleton.number_of_nodes());
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    counts.number_of_components -= sets.join(edge[0], edge[1]) ? 1 : 0;
    counts.length += skeleton.length(edge);
  }
  counts.betti_number = counts.number_of_edges + counts.number_of_components - counts.number_of_nodes;
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  for (const std::vector<Index>& around : neighbors) {
    counts.number_of_isolated_nodes += around.empty() ? 1 : 0;
    counts.number_of_tips += around.size() == 1 ? 1 : 0;
    counts.number_of_junctions += around.size() > 2 ? 1 : 0;
  }
  measure_turning(skeleton, radii, neighbors, counts);
  return counts;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_COUNT_SKELETON_H
