// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the nearest of many segments.

#ifndef CSCD_MEASURE_SEGMENT_BVH_H
#define CSCD_MEASURE_SEGMENT_BVH_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A point of a segment.
struct Segment_point
{
  Index segment = no_index;
  double parameter = 0; ///< 0 at the source of the segment, 1 at its target
  double distance = 0;  ///< from the query point
};

/// A bounding volume hierarchy over segments; those of length zero are points.
/// Queries are const and may be made by several threads at once; each is O(log n) if segments are well spread.
class Segment_bvh
{
public:
  using Segment = std::array<Vector_3, 2>;

  /// Builds the hierarchy in O(n log n).
  explicit Segment_bvh(std::vector<Segment> segments) : m_segments(std::move(segments))
  {
    std::vector<Bounding_box> boxes(m_segments.size());
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
      boxes[i].extend(m_segments[i][0]);
      boxes[i].extend(m_segments[i][1]);
    }
    m_tree = Box_tree(boxes);
  }

  bool empty() const { return m_segments.empty(); }

  /// The point of all segments that is nearest to `point`; on ties that of the first segment.
  /// \pre there are segments
  Segment_point nearest(const Vector_3& point) const
  {
    CGAL_precondition(!empty());
    Segment_point nearest;
    double least = std::numeric_limits<double>::infinity(); // squared distance
    m_tree.minimize(
        [&point](const Bounding_box& box) { return box.squared_distance(point); },
        [&](Index i) {
          const auto& [source, target] = m_segments[i];
          const Vector_3 along = target - source;
          const double squared_length = along.squaredNorm();
          const double t = squared_length > 0 ? std::clamp((point - source).dot(along) / squared_length, 0., 1.) : 0;
          const double candidate = (source + t * along - point).squaredNorm();
          if (nearest.segment == no_index || candidate < least || (candidate == least && i < nearest.segment)) {
            least = candidate;
            nearest = {i, t, 0};
          }
          return candidate;
        });
    nearest.distance = std::sqrt(least);
    return nearest;
  }

private:
  std::vector<Segment> m_segments;
  Box_tree m_tree;
};

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
inline Segment_bvh segment_tree(const Indexed_skeleton& skeleton, const std::vector<std::array<Index, 2>>& ends)
{
  std::vector<Segment_bvh::Segment> segments;
  segments.reserve(ends.size());
  for (const auto& [u, v] : ends) {
    segments.push_back({skeleton.points[u], skeleton.points[v]});
  }
  return Segment_bvh(std::move(segments));
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_SEGMENT_BVH_H
