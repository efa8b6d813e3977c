// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the nearest of many segments.

#ifndef CSCD_MEASURE_SEGMENT_BVH_H
#define CSCD_MEASURE_SEGMENT_BVH_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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
    std::vector<Index> indices(m_segments.size());
    std::iota(indices.begin(), indices.end(), Index(0));
    std::vector<Eigen::AlignedBox3d> boxes(m_segments.size());
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
      boxes[i].extend(m_segments[i][0]);
      boxes[i].extend(m_segments[i][1]);
    }
    m_tree.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  }

  bool empty() const { return m_segments.empty(); }

  /// The point of all segments that is nearest to `point`; on ties that of the first segment.
  /// \pre there are segments
  Segment_point nearest(const Vector_3& point) const
  {
    CGAL_precondition(!empty());
    Distance_minimizer minimizer{m_segments, point, {}, std::numeric_limits<double>::infinity()};
    Eigen::BVMinimize(m_tree, minimizer);
    minimizer.nearest.distance = std::sqrt(minimizer.squared_distance);
    return minimizer.nearest;
  }

private:
  struct Distance_minimizer
  {
    using Scalar = double; // as Eigen names it

    const std::vector<Segment>& segments;
    Vector_3 point;
    Segment_point nearest;
    double squared_distance;

    double minimumOnVolume(const Eigen::AlignedBox3d& box) const { return box.squaredExteriorDistance(point); }
    double minimumOnObject(Index i)
    {
      const Vector_3 along = segments[i][1] - segments[i][0];
      const double squared_length = along.squaredNorm();
      const double t =
          squared_length > 0 ? std::clamp((point - segments[i][0]).dot(along) / squared_length, 0., 1.) : 0;
      const double candidate = (segments[i][0] + t * along - point).squaredNorm();
      if (nearest.segment == no_index || candidate < squared_distance ||
          (candidate == squared_distance && i < nearest.segment)) {
        squared_distance = candidate;
        nearest = {i, t, 0};
      }
      return candidate;
    }
  };

  std::vector<Segment> m_segments;
  Eigen::KdBVH<double, 3, Index> m_tree;
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
