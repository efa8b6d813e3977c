// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Spatial_graph.h.

#ifndef CSCD_GRAPH_SPATIAL_GRAPH_IMPL_H
#define CSCD_GRAPH_SPATIAL_GRAPH_IMPL_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Sorts edges, and removes all but the shortest of those with the same source and target.
inline void keep_shortest(std::vector<Spatial_graph::Edge>& edges)
{
  using Edge = Spatial_graph::Edge;
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.source, a.target, a.length) < std::tie(b.source, b.target, b.length);
  });
  const auto are_parallel = [](const Edge& a, const Edge& b) { return a.source == b.source && a.target == b.target; };
  edges.erase(std::unique(edges.begin(), edges.end(), are_parallel), edges.end());
}

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE Spatial_graph::Spatial_graph(std::vector<Vector3> points, const std::vector<Edge>& edges,
                                         const std::vector<double>& radii)
{
  Point_cloud cloud = make_point_cloud(std::move(points), {});
  m_points = std::move(cloud.points);
  m_vertex_of_point = std::move(cloud.input_point);
  m_normalization = cloud.normalization;
  if (!radii.empty()) {
    m_radius.assign(m_points.size(), 0);
    for (std::size_t i = 0; i < radii.size(); ++i) {
      double& radius = m_radius[m_vertex_of_point[i]];
      radius = std::max(radius, radii[i] / m_normalization.unit);
    }
  }
  join(edges);
  measure();
}

CSCD_INLINE void Spatial_graph::join(const std::vector<Edge>& edges)
{
  std::vector<Edge> kept;
  kept.reserve(edges.size());
  for (const Edge& edge : edges) {
    const auto [a, b] = std::minmax(m_vertex_of_point[edge.source], m_vertex_of_point[edge.target]);
    if (a != b) {
      kept.push_back({a, b, edge.length / m_normalization.unit});
    }
  }
  internal::keep_shortest(kept);
  m_number_of_unused_edges = edges.size() - kept.size();
  // Sorted by source, then by target: so are the rows.
  m_targets = internal::Compressed_rows<Index>(m_points.size(), [&kept](const auto& add) {
    for (const Edge& edge : kept) {
      add(edge.target, edge.source);
    }
    for (const Edge& edge : kept) {
      add(edge.source, edge.target);
    }
  });
  std::vector<Index> next; // the first halfedge of each vertex whose twin is not known
  for (Index vertex = 0; vertex < m_points.size(); ++vertex) {
    next.push_back(m_targets.begin(vertex));
  }
  for (const Index target : m_targets.values()) {
    m_twins.push_back(next[target]++);
  }
  m_lengths.resize(m_twins.size());
  auto edge = kept.begin();
  for (Index h = 0; h < number_of_halfedges(); ++h) {
    if (origin(h) < target(h)) {
      m_lengths[h] = m_lengths[twin(h)] = (edge++)->length;
    }
  }
}

CSCD_INLINE void Spatial_graph::measure()
{
  std::size_t number_in_triangles = 0;
  for (Index h = 0; h < number_of_halfedges(); ++h) {
    const Halfedge_range others = outgoing(target(h));
    number_in_triangles +=
        std::any_of(others.begin(), others.end(), [&](Index other) { return is_adjacent(origin(h), target(other)); })
            ? 1
            : 0;
  }
  m_is_triangulated = 2 * number_in_triangles > number_of_halfedges();
  internal::Disjoint_sets components(m_points.size());
  m_area.assign(m_points.size(), 1);
  m_number_of_components = m_points.size();
  for (Index vertex = 0; vertex < m_points.size(); ++vertex) {
    double sum = 0;
    for (const Index halfedge : outgoing(vertex)) {
      sum += (m_points[target(halfedge)] - m_points[vertex]).norm();
      m_number_of_components -= components.join(vertex, target(halfedge)) ? 1 : 0;
    }
    if (sum > 0) {
      const double mean = sum / double(m_targets.size(vertex));
      m_area[vertex] = mean * mean;
    }
  }
}

CSCD_INLINE std::vector<Spatial_graph::Edge> neighbor_edges(const std::vector<Vector3>& points,
                                                            Index number_of_neighbors)
{
  const internal::Neighbor_table table(points, number_of_neighbors);
  std::vector<Spatial_graph::Edge> result;
  result.reserve(points.size() * table.number());
  for (Index a = 0; a < points.size(); ++a) {
    for (Index i = 0; i < table.number(); ++i) {
      const Index b = table.neighbors(a).begin()[i];
      const auto [source, target] = std::minmax(a, b);
      result.push_back({source, target, table.distances(a).begin()[i]});
    }
  }
  internal::keep_shortest(result);
  return result;
}

} // namespace CSCD

#endif // CSCD_GRAPH_SPATIAL_GRAPH_IMPL_H
