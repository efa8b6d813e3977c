// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins junctions that are one junction of the body.

#ifndef CSCD_SKELETON_MERGE_JUNCTIONS_H
#define CSCD_SKELETON_MERGE_JUNCTIONS_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// Merges two junctions whenever the path between them is shorter than the body is thick there.
/// The number of independent cycles stays: junctions that are joined by more than one path are left alone.
class Junction_merging
{
public:
  explicit Junction_merging(Skeleton_draft& draft) : m_draft(draft) {}

  void operator()()
  {
    for (Index node = 0; node < m_draft.size(); ++node) {
      while (m_draft.is_junction(node) && merge_one_into(node)) {
      }
    }
  }

private:
  /// Junctions are merged if the path between them is shorter than this, relative to the least radius on the path.
  static constexpr double most_length = 1;
  /// A path of more nodes than this is never that short.
  static constexpr std::size_t most_path_nodes = 4;

  /// The nodes strictly between two junctions, and the second junction.
  struct Path
  {
    std::vector<Index> inner;
    Index end = no_index;
    double length = 0;
    double least_radius = std::numeric_limits<double>::max();
  };

  Path walk(Index start, Index first) const
  {
    Path path;
    Index before = start;
    Index node = first;
    path.length = m_draft.edge_length(start, first);
    while (m_draft.is_regular(node) && path.inner.size() < most_path_nodes) {
      path.inner.push_back(node);
      path.least_radius = std::min(path.least_radius, m_draft[node].radius);
      const std::vector<Index>& neighbors = m_draft[node].neighbors;
      const Index next = neighbors[0] == before ? neighbors[1] : neighbors[0];
      path.length += m_draft.edge_length(node, next);
      before = node;
      node = next;
    }
    path.end = node;
    return path;
  }

  bool merge_one_into(Index junction)
  {
    for (Index first : m_draft[junction].neighbors) {
      const Path path = walk(junction, first);
      const bool is_short = !path.inner.empty() && path.length < most_length * path.least_radius;
      if (is_short && path.end != junction && m_draft.is_junction(path.end) && is_only_path(junction, path.end)) {
        merge(junction, path);
        return true;
      }
    }
    return false;
  }

  bool is_only_path(Index junction, Index end) const
  {
    const std::vector<Index>& neighbors = m_draft[junction].neighbors;
    return std::count_if(neighbors.begin(), neighbors.end(),
                         [&](Index first) { return walk(junction, first).end == end; }) == 1;
  }

  void merge(Index junction, const Path& path)
  {
    const auto weight = double(m_draft.degree(junction));
    const auto other_weight = double(m_draft.degree(path.end));
    m_draft[junction].position =
        (weight * m_draft[junction].position + other_weight * m_draft[path.end].position) / (weight + other_weight);
    m_draft[junction].radius = std::max(m_draft[junction].radius, m_draft[path.end].radius);
    for (Index node : path.inner) {
      m_draft.contract(node, junction);
    }
    m_draft.contract(path.end, junction);
  }

  Skeleton_draft& m_draft;
};

/// Merges junctions of `draft` that are closer to each other than the body is thick there.
inline void merge_junctions(Skeleton_draft& draft)
{
  Junction_merging merging(draft);
  merging();
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_MERGE_JUNCTIONS_H
