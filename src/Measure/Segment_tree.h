// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the nearest of many segments.

#ifndef CSCD_SRC_MEASURE_SEGMENT_TREE_H
#define CSCD_SRC_MEASURE_SEGMENT_TREE_H

#include <CSCD/Skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Counts steps of searches, and refuses what would take hours: the edges of a skeleton that are all near each other,
/// as those of a complete graph.
class Work_limit
{
public:
  /// Adds the steps of one search. \throw Input_error if these were too many
  void add(std::size_t steps)
  {
    constexpr std::size_t most = std::size_t(1) << 31; // half a minute
    constexpr std::size_t most_of_each = 1024;         // on the average; in skeletons of bodies there are a hundred
    m_steps += steps;
    ++m_number;
    if (m_steps > std::max(most, most_of_each * m_number)) {
      throw Input_error("too many edges of the skeleton are near each other to be measured: simplify it first");
    }
  }

private:
  std::size_t m_steps = 0;
  std::size_t m_number = 0; // of searches
};

/// The ends of the edges of `skeleton`, in order, and after them twice the number of each node that has no edge: such a
/// node is a segment of length zero. Linear.
inline std::vector<std::array<Index, 2>> segment_ends(const Skeleton& skeleton)
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

/// A point of a segment.
struct Segment_point
{
  Index segment = no_index;
  double parameter = 0; ///< 0 at the source of the segment, 1 at its target
  double distance = 0;  ///< from the query point
};

/// A search structure over segments; those of length zero are points. A query is O(log n) if segments are well spread.
class Segment_tree
{
public:
  using Segment = std::array<Vector_3, 2>;

  /// O(n log n).
  explicit Segment_tree(std::vector<Segment> segments) : m_segments(std::move(segments))
  {
    std::vector<Bounding_box> boxes(m_segments.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      boxes[i].extend(m_segments[i][0]);
      boxes[i].extend(m_segments[i][1]);
    }
    m_tree = Box_tree(boxes);
  }
  /// Over the segments of `skeleton` with the given `ends`.
  Segment_tree(const Skeleton& skeleton, const std::vector<std::array<Index, 2>>& ends)
      : Segment_tree(segments_of(skeleton, ends))
  {
  }

  /// The point of all segments that is nearest to `point`; on ties that of the first segment. \pre there are segments
  /// \throw Input_error see `Work_limit`
  Segment_point nearest(const Vector_3& point, Work_limit& work) const
  {
    constexpr double slack = 1 - 1e-12; // far above rounding: boxes that are as near as what was found are entered
    double least = std::numeric_limits<double>::infinity();
    Index nearest = no_index;
    std::size_t steps = 0;
    m_tree.minimize([&](const Bounding_box& box) { return slack * box.squared_distance(point); },
                    [&](Index i) {
                      ++steps;
                      const auto& [source, target] = m_segments[i];
                      const double square = (source + parameter(i, point) * (target - source) - point).squaredNorm();
                      if (square < least || (square == least && i < nearest)) {
                        least = square;
                        nearest = i;
                      }
                      return square;
                    });
    work.add(steps);
    return {nearest, parameter(nearest, point), std::sqrt(least)};
  }

private:
  static std::vector<Segment> segments_of(const Skeleton& skeleton, const std::vector<std::array<Index, 2>>& ends)
  {
    std::vector<Segment> segments;
    segments.reserve(ends.size());
    for (const auto& [u, v] : ends) {
      segments.push_back({skeleton.points[u], skeleton.points[v]});
    }
    return segments;
  }

  double parameter(Index i, const Vector_3& point) const
  {
    const auto& [source, target] = m_segments[i];
    const Vector_3 along = target - source;
    const double squared_length = along.squaredNorm();
    return squared_length > 0 ? std::clamp((point - source).dot(along) / squared_length, 0., 1.) : 0;
  }

  std::vector<Segment> m_segments;
  Box_tree m_tree;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_SEGMENT_TREE_H
