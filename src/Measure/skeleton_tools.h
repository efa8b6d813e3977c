// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common parts of the measures of skeletons: checks, counts, samples of edges, distances, and the nearest edge.

#ifndef CSCD_SRC_MEASURE_SKELETON_TOOLS_H
#define CSCD_SRC_MEASURE_SKELETON_TOOLS_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// \param which skeleton, with a blank behind it, where there are two
[[noreturn]] inline void fail_at_node(std::size_t node, const std::string& fault, const std::string& which = "")
{
  throw Input_error("node " + std::to_string(node) + " of the " + which + "skeleton " + fault);
}

/// \throw Input_error if a coordinate of `node` is not finite
inline void check_finite(const Skeleton& skeleton, std::size_t node, const std::string& which = "")
{
  if (!skeleton.points[node].allFinite()) {
    fail_at_node(node, "has a coordinate that is not finite: correct it or remove the node", which);
  }
}

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

/// A point of a skeleton, and the unit direction of its edge.
struct Edge_sample
{
  Vector3 point = Vector3::Zero();
  Vector3 tangent = Vector3::Zero();
};

/// Samples the edges of `skeleton` evenly: they are laid end to end in their order, and every piece of length `spacing`
/// gets a sample at its middle. So each sample stands for the same length, however the skeleton is cut into edges.
/// O(e + l / spacing) for e edges of total length l.
/// \param max_number of samples; the spacing is made greater if there would be more
/// \pre `spacing` is positive
inline std::vector<Edge_sample> sample_edges(const Skeleton& skeleton, double spacing, std::size_t max_number)
{
  double total = 0;
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    total += skeleton.length(edge);
  }
  spacing = std::max(spacing, total / double(max_number));
  std::vector<Edge_sample> samples;
  double to_next = spacing / 2;
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    const double length = skeleton.length(edge);
    if (!(length > 0)) {
      continue;
    }
    const Vector3& source = skeleton.points[edge[0]];
    const Vector3 tangent = (skeleton.points[edge[1]] - source) / length;
    while (to_next <= length) {
      samples.push_back({source + to_next * tangent, tangent});
      to_next += spacing;
    }
    to_next -= length;
  }
  return samples;
}

/// Takes pairs of things of two kinds, the nearest first, each thing at most once. \return the pairs that were taken
/// \param pairs distance and numbers; of equal distances the least numbers come first
inline std::vector<std::array<Index, 2>> take_nearest_pairs(std::vector<std::tuple<double, Index, Index>>&& pairs)
{
  std::sort(pairs.begin(), pairs.end());
  std::set<Index> first;
  std::set<Index> second;
  std::vector<std::array<Index, 2>> result;
  for (const auto& [distance, i, j] : pairs) {
    if (first.count(i) == 0 && second.count(j) == 0) {
      first.insert(i);
      second.insert(j);
      result.push_back({i, j});
    }
  }
  return result;
}

/// Where on the segment between two points the point nearest to `point` is: 0 at the source, 1 at the target.
inline double nearest_parameter(const Vector3& point, const Vector3& source, const Vector3& target)
{
  const Vector3 along = target - source;
  const double squared_length = along.squaredNorm();
  return squared_length > 0 ? std::clamp((point - source).dot(along) / squared_length, 0., 1.) : 0;
}

/// The distance of `point` from the segment between two points.
inline double distance_to_segment(const Vector3& point, const Vector3& source, const Vector3& target)
{
  return (source + nearest_parameter(point, source, target) * (target - source) - point).norm();
}

/// The distance of `point` from `node` and the edges there. \param neighbors as `node_neighbors()` gives them
inline double distance_to_edges(const Skeleton& skeleton, const std::vector<std::vector<Index>>& neighbors, Index node,
                                const Vector3& point)
{
  double distance = (point - skeleton.points[node]).norm();
  for (const Index neighbor : neighbors[node]) {
    distance = std::min(distance, distance_to_segment(point, skeleton.points[node], skeleton.points[neighbor]));
  }
  return distance;
}

/// A point of a segment.
struct Segment_point
{
  Index segment = no_index;
  double parameter = 0; ///< 0 at the source of the segment, 1 at its target
  double distance = 0;  ///< from the query point
};

/// A search structure over the edges of a skeleton, and over its nodes without edges as segments of length zero. A
/// query is O(log n) if they are well spread.
class Segment_tree
{
public:
  /// O(n log n). \param radii of balls around the nodes, which the boxes hold too; empty if there are none
  explicit Segment_tree(const Skeleton& skeleton, const std::vector<double>& radii = {})
      : m_points(skeleton.points), m_segments(skeleton.edges)
  {
    const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
    for (Index node = 0; node < neighbors.size(); ++node) {
      if (neighbors[node].empty()) {
        m_segments.push_back({node, node});
      }
    }
    std::vector<Bounding_box> boxes(m_segments.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (const Index node : m_segments[i]) {
        const Vector3 radius = Vector3::Constant(radii.empty() ? 0 : radii[node]);
        boxes[i].extend(m_points[node] - radius);
        boxes[i].extend(m_points[node] + radius);
      }
    }
    m_tree = Box_tree(boxes);
  }

  /// The ends of the segments: of the edges in order, then of the nodes without edges.
  const std::vector<std::array<Index, 2>>& segments() const { return m_segments; }

  /// Searches as `Box_tree::minimize()` does.
  /// \throw Input_error if searches would take hours: the edges are all near each other, as those of a complete graph
  template <class Bound, class Visit>
  void minimize(const Bound& bound, const Visit& visit) const
  {
    constexpr std::size_t most = std::size_t(1) << 31; // segments in all searches: half a minute
    constexpr std::size_t most_of_each = 1024;         // on the average; in skeletons of bodies there are a hundred
    m_tree.minimize(bound, [&](Index segment) {
      ++m_number_of_visits;
      return visit(segment);
    });
    ++m_number_of_searches;
    if (m_number_of_visits > std::max(most, most_of_each * m_number_of_searches)) {
      throw Input_error("too many edges of the skeleton are near each other to be measured: simplify it first");
    }
  }

  /// The point of all segments that is nearest to `point`; on ties that of the first segment. \pre there are segments
  /// \throw Input_error as `minimize()` does
  Segment_point nearest(const Vector3& point) const
  {
    constexpr double slack = 1 - 1e-12; // far above rounding: boxes as near as the nearest edge so far are entered
    double least = std::numeric_limits<double>::infinity();
    Index nearest = no_index;
    minimize([&](const Bounding_box& box) { return slack * box.squared_distance(point); },
             [&](Index i) {
               const Vector3& source = m_points[m_segments[i][0]];
               const Vector3& target = m_points[m_segments[i][1]];
               const double square = (source + parameter(i, point) * (target - source) - point).squaredNorm();
               if (square < least || (square == least && i < nearest)) {
                 least = square;
                 nearest = i;
               }
               return square;
             });
    return {nearest, parameter(nearest, point), std::sqrt(least)};
  }

private:
  double parameter(Index i, const Vector3& point) const
  {
    return nearest_parameter(point, m_points[m_segments[i][0]], m_points[m_segments[i][1]]);
  }

  std::vector<Vector3> m_points;
  std::vector<std::array<Index, 2>> m_segments;
  Box_tree m_tree;
  mutable std::size_t m_number_of_visits = 0; // of segments, by all searches
  mutable std::size_t m_number_of_searches = 0;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_SKELETON_TOOLS_H
