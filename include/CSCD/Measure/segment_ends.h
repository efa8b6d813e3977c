// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton as segments.

#ifndef CSCD_MEASURE_SEGMENT_ENDS_H
#define CSCD_MEASURE_SEGMENT_ENDS_H

#include <CSCD/Measure/Segment_tree.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The ends of the edges of `skeleton`, in order, and after them twice the number of each node that has no edge: such a
/// node is a segment of length zero. Linear.
inline std::vector<std::array<Index, 2>> segment_ends(const Indexed_skeleton& skeleton)
{
  std::vector<std::array<Index, 2>> ends = skeleton.edges;
  std::vector<char> has_edge(skeleton.number_of_nodes(), 0);
  for (const auto& [u, v] : skeleton.edges) {
    has_edge[u] = has_edge[v] = 1;
  }
  for (Index v = 0; v < skeleton.number_of_nodes(); ++v) {
    if (has_edge[v] == 0) {
      ends.push_back({v, v});
    }
  }
  return ends;
}

/// The search structure over the segments of `skeleton` with the given ends.
inline Segment_tree segment_tree(const Indexed_skeleton& skeleton, const std::vector<std::array<Index, 2>>& ends)
{
  std::vector<Segment_tree::Segment> segments;
  segments.reserve(ends.size());
  for (const auto& [u, v] : ends) {
    segments.push_back({skeleton.points[u], skeleton.points[v]});
  }
  return Segment_tree(std::move(segments));
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_SEGMENT_ENDS_H
