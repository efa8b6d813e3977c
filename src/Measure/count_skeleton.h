// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts of a skeleton.

#ifndef CSCD_SRC_MEASURE_COUNT_SKELETON_H
#define CSCD_SRC_MEASURE_COUNT_SKELETON_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <array>
#include <vector>

namespace CSCD::internal {

/// Counts nodes, edges, components, cycles, tips and junctions, and measures the length. Near linear.
inline Skeleton_counts count_skeleton(const Skeleton& skeleton)
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
  for (const std::vector<Index>& around : node_neighbors(skeleton)) {
    counts.number_of_isolated_nodes += around.empty() ? 1 : 0;
    counts.number_of_tips += around.size() == 1 ? 1 : 0;
    counts.number_of_junctions += around.size() > 2 ? 1 : 0;
  }
  return counts;
}

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_COUNT_SKELETON_H
