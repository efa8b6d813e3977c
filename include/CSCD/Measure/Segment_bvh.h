// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the nearest of many segments.

#ifndef CSCD_MEASURE_SEGMENT_BVH_H
#define CSCD_MEASURE_SEGMENT_BVH_H

#include <CSCD/Measure/Part_tree.h>
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

/// A round cone, the convex hull of the balls around two points; a ball if it has no length.
struct Round_cone
{
  Vector_3 source, direction;
  double length, source_radius, target_radius;
  double sine, cosine; ///< of the angle between the axis and the straight lines of the surface

  Round_cone(const Vector_3& from, const Vector_3& to, double from_radius, double to_radius)
      : source(from), direction(Vector_3::Zero()), length((to - from).norm()), source_radius(from_radius),
        target_radius(to_radius), sine(length > 0 ? (from_radius - to_radius) / length : 1), cosine(0)
  {
    if (std::abs(sine) < 1) {
      direction = (to - from) / length;
      cosine = std::sqrt(1 - sine * sine);
    } else { // one ball holds the other
      source = from_radius >= to_radius ? from : to;
      source_radius = target_radius = std::max(from_radius, to_radius);
      length = sine = 0;
      cosine = 1;
    }
  }

  /// Negative inside, exact outside, and inside no greater in magnitude than the distance from the surface.
  double signed_distance(const Vector_3& point) const
  {
    const Vector_3 to_point = point - source;
    const double x = to_point.dot(direction);
    const double y2 = std::max(to_point.squaredNorm() - x * x, 0.);
    const double y = std::sqrt(y2);
    // Coordinate along the straight line of the surface below the point, 0 where it leaves the first ball.
    const double along = x * cosine - y * sine;
    if (along <= 0) {
      return std::sqrt(x * x + y2) - source_radius;
    }
    if (along >= length * cosine) {
      return std::sqrt((x - length) * (x - length) + y2) - target_radius;
    }
    return x * sine + y * cosine - source_radius;
  }
};

/// A search structure over segments; those of length zero are points. A node of the tree is bounded by a box, and
/// by a round cone around its segments, which is slim where they leave one point in about one direction.
/// Queries are const and may be made by several threads at once; each is O(log n) if segments are well spread.
class Segment_bvh
{
public:
  using Segment = std::array<Vector_3, 2>;

  /// Builds the hierarchy in O(n log n).
  /// \param radii the greatest one that either end of each segment has, for bounds of round cones; or empty
  explicit Segment_bvh(std::vector<Segment> segments, const std::vector<double>& radii = {})
      : m_segments(std::move(segments)), m_direction_length(direction_length(m_segments)),
        m_tree(parts_of(m_segments, m_direction_length))
  {
    m_bounds.resize(m_tree.nodes().size());
    for (Index n = Index(m_bounds.size()); n-- > 0;) {
      const auto& node = m_tree.nodes()[n];
      Bound& bound = m_bounds[n];
      for (Index k = node.begin; node.second_child == no_index && k < node.end; ++k) {
        const Index i = m_tree.objects()[k];
        bound.max_radius = std::max(bound.max_radius, radii.empty() ? 0. : radii[i]);
        bound.max_length = std::max(bound.max_length, (m_segments[i][1] - m_segments[i][0]).norm());
        bound.box.extend(m_segments[i][0]);
        bound.box.extend(m_segments[i][1]);
      }
      if (node.parent != no_index) {
        Bound& parent = m_bounds[node.parent];
        parent.max_radius = std::max(parent.max_radius, bound.max_radius);
        parent.max_length = std::max(parent.max_length, bound.max_length);
        parent.box.extend(bound.box);
      }
      set_bound(node, bound);
    }
  }

  bool empty() const { return m_segments.empty(); }

  /// Nodes of the tree after which those who ask for means should be content with what they asked for so far: a
  /// second or two. Well spread segments take a hundred for a query, those of a complete graph each tenth.
  static constexpr std::size_t enough_work = std::size_t(1) << 24;

  /// The point of all segments that is nearest to `point`; on ties that of the first segment.
  /// \param enough a distance: any point up to there will do
  /// \param work the number of nodes of the tree that were looked into is added to this
  /// \pre there are segments
  Segment_point nearest(const Vector_3& point, double enough = 0, std::size_t* work = nullptr) const
  {
    CGAL_precondition(!empty());
    const auto [least, segment] = m_tree.minimize(
        [&](Index n) {
          const double distance = std::max(bound(n, point), 0.);
          return distance * distance;
        },
        [&](Index i, double) { return squared_distance(i, point); }, {},
        {std::numeric_limits<std::size_t>::max(), enough * enough, work});
    return {segment, parameter(segment, point), std::sqrt(least)};
  }

  /// The least value of a segment, where that of one is at least the distance from it less its radius. In tangles of
  /// some thousand long segments and more, which are near each other everywhere, one of the least.
  template <class Value>
  double least_value(const Vector_3& point, const Value& value) const
  {
    return m_tree
        .minimize([&](Index n) { return bound(n, point); }, [&](Index i, double) { return value(i); }, {},
                  {max_number_of_nodes, -std::numeric_limits<double>::infinity(), nullptr})
        .value;
  }

private:
  /// Source, and direction, as a vector of the length `m_direction_length`.
  using Tree = Part_tree<2>;

  /// A search for the least value looks into as many nodes of the tree at most.
  static constexpr std::size_t max_number_of_nodes = 1 << 12;

  /// Nodes of the tree are divided by direction where the sources are nearer to each other than this.
  static double direction_length(const std::vector<Segment>& segments)
  {
    constexpr double factor = 8; // in mean lengths of a segment
    double sum = 0;
    for (const auto& [source, target] : segments) {
      sum += (target - source).norm();
    }
    return sum > 0 ? factor * sum / double(segments.size()) : 1;
  }

  static std::vector<Tree::Parts> parts_of(const std::vector<Segment>& segments, double direction_length)
  {
    std::vector<Tree::Parts> parts(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto& [source, target] = segments[i];
      parts[i][0].extend(source);
      parts[i][1].extend(direction_length * (target - source).normalized());
    }
    return parts;
  }

  /// What a node is inside of.
  struct Bound
  {
    Bounding_box box;
    double max_radius = 0; ///< by how much the box grows on all sides
    double max_length = 0; ///< of a segment
    Round_cone cone{Vector_3::Zero(), Vector_3::Zero(), 0, 0};
    bool has_cone = false; ///< otherwise the box is the better one
  };

  /// The cone is around the segments made equally long.
  void set_bound(const Tree::Node& node, Bound& bound) const
  {
    constexpr double slack = 1 + 1e-9; // far above rounding
    constexpr double min_slimness = 4; // length over radius: thicker cones fill their boxes
    const auto& [sources, directions] = node.boxes;
    const double scale = bound.max_length / m_direction_length;
    const Vector_3 source = (sources.min() + sources.max()) / 2;
    const Vector_3 target = source + scale * (directions.min() + directions.max()) / 2;
    const double source_radius = sources.diagonal() / 2 * slack;
    const double target_radius = source_radius + scale * directions.diagonal() / 2 * slack;
    // What rounding adds where the radii are 0.
    const double rounding = (slack - 1) * bound.max_length;
    bound.cone = Round_cone(source, target, source_radius + rounding + bound.max_radius,
                            target_radius + rounding + bound.max_radius);
    bound.has_cone = bound.cone.length > min_slimness * std::max(bound.cone.source_radius, bound.cone.target_radius);
  }

  /// At most the distance of `point` from each segment of node `n`, less its radius.
  double bound(Index n, const Vector_3& point) const
  {
    constexpr double slack = 1e-12; // far above rounding
    const Bound& bound = m_bounds[n];
    const double from_box = std::sqrt(bound.box.squared_distance(point)) - bound.max_radius;
    const double distance = bound.has_cone ? std::max(from_box, bound.cone.signed_distance(point)) : from_box;
    return distance - slack * std::abs(distance);
  }

  double parameter(Index i, const Vector_3& point) const
  {
    const auto& [source, target] = m_segments[i];
    const Vector_3 along = target - source;
    const double squared_length = along.squaredNorm();
    return squared_length > 0 ? std::clamp((point - source).dot(along) / squared_length, 0., 1.) : 0;
  }

  double squared_distance(Index i, const Vector_3& point) const
  {
    const auto& [source, target] = m_segments[i];
    return (source + parameter(i, point) * (target - source) - point).squaredNorm();
  }

  std::vector<Segment> m_segments;
  double m_direction_length = 1;
  Tree m_tree;
  std::vector<Bound> m_bounds; ///< of the nodes of the tree
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
