// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graph of neighboring points of a scan, and distances from the root in it.

#ifndef CSCD_SRC_TREE_NEIGHBOR_GRAPH_H
#define CSCD_SRC_TREE_NEIGHBOR_GRAPH_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// An undirected graph on points, and the spacing of the points at each of them. Scans are dense on trunks and sparse
/// on twigs: what is near is relative to the spacing there.
class Neighbor_graph
{
public:
  using Edge = std::pair<Index, Index>;

  /// Joins each of `points` to those among its nearest neighbors, or of whose it is one, that are not far for the
  /// spacing at both. O(n log n).
  explicit Neighbor_graph(const std::vector<Vector_3>& points)
  {
    const Neighbor_table table(points, number_of_neighbors);
    measure_spacing(points, table);
    for (Index a = 0; a < points.size(); ++a) {
      for (Index i = 0; i < table.number(); ++i) {
        const Index b = table.neighbors(a).begin()[i];
        if (table.distances(a).begin()[i] <= longest_edge * std::min(m_spacing[a], m_spacing[b])) {
          m_edges.emplace_back(std::minmax(a, b));
        }
      }
    }
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
    m_number_of_own_edges = m_edges.size();
    index_edges();
  }

  Index number_of_vertices() const { return Index(m_spacing.size()); }
  CGAL::Iterator_range<const Index*> neighbors(Index point) const { return m_neighbors[point]; }
  /// The mean distance of the nearest points, a median over the neighborhood.
  double spacing(Index point) const { return m_spacing[point]; }

  /// Adds `bridges`, edges that are not there yet, in the place of those added before. Linear.
  void set_bridges(const std::vector<Edge>& bridges)
  {
    m_edges.resize(m_number_of_own_edges);
    m_edges.insert(m_edges.end(), bridges.begin(), bridges.end());
    index_edges();
  }

private:
  /// With fewer neighbors, random samplings fall apart; more reach over to the next twig.
  static constexpr Index number_of_neighbors = 16;
  /// The neighbors whose mean distance is the spacing: about as many as an even sampling has around.
  static constexpr Index spacing_neighbors = 6;
  /// Of an edge, relative to the lesser spacing at its ends.
  static constexpr double longest_edge = 2.5;

  void measure_spacing(const std::vector<Vector_3>& points, const Neighbor_table& table)
  {
    const auto number_of_points = Index(points.size());
    const Index number = std::min(spacing_neighbors, table.number());
    std::vector<double> mean(number_of_points, 0.);
    for (Index point = 0; number > 0 && point < number_of_points; ++point) {
      const double* first = table.distances(point).begin();
      mean[point] = std::accumulate(first, first + number, 0.) / number;
    }
    m_spacing.resize(number_of_points);
    std::vector<double> around;
    for (Index point = 0; point < number_of_points; ++point) {
      around.assign(1, mean[point]);
      for (Index neighbor : table.neighbors(point)) {
        around.push_back(mean[neighbor]);
      }
      m_spacing[point] = quantile(around, 0.5);
    }
  }

  void index_edges()
  {
    m_neighbors = Compressed_rows<Index>(m_spacing.size(), [this](const auto& add) {
      for (const auto& [a, b] : m_edges) {
        add(a, b);
        add(b, a);
      }
    });
  }

  std::vector<double> m_spacing;
  std::vector<Edge> m_edges; // bridges last
  std::size_t m_number_of_own_edges = 0;
  Compressed_rows<Index> m_neighbors;
};

/// Distances along a neighbor graph, and the tree of the shortest paths.
class Root_distances
{
public:
  explicit Root_distances(const std::vector<Vector_3>& points, const Neighbor_graph& graph)
      : m_points(points), m_graph(graph), m_front(points.size()), m_cost(points.size(), 0.F),
        m_distance(points.size(), 0.F), m_parent(points.size(), no_index)
  {
  }

  /// Measures from `roots` all that is connected with them. O(n log n).
  void measure_from(const std::vector<Index>& roots)
  {
    m_front.clear();
    for (Index root : roots) {
      m_front.reach(root, 0);
    }
    m_front.spread([&](Index point, float cost) {
      m_cost[point] = cost;
      if (m_parent[point] != no_index) {
        m_distance[point] = m_distance[m_parent[point]] + float((m_points[point] - m_points[m_parent[point]]).norm());
      }
      for (Index neighbor : m_graph.neighbors(point)) {
        if (m_front.reach(neighbor, cost + float(cost_of_edge(point, neighbor)))) {
          m_parent[neighbor] = point;
        }
      }
    });
  }

  /// What the shortest path to the root costs.
  float cost(Index point) const { return m_cost[point]; }
  /// The length of that path.
  float distance(Index point) const { return m_distance[point]; }
  /// The next point on the shortest path to the root; `no_index` for a root.
  Index parent(Index point) const { return m_parent[point]; }

private:
  /// Shortest paths must not leap from limb to limb: what is longer than the spacing costs more than its length.
  double cost_of_edge(Index a, Index b) const
  {
    const double length = (m_points[a] - m_points[b]).norm();
    const double spacing = std::min(m_graph.spacing(a), m_graph.spacing(b));
    return spacing > 0 ? length * std::pow(std::max(1., length / spacing), leap_exponent) : length;
  }

  /// How much more, as the power of the length relative to the spacing.
  static constexpr double leap_exponent = 0.5;

  const std::vector<Vector_3>& m_points;
  const Neighbor_graph& m_graph;
  Dijkstra_search m_front;
  std::vector<float> m_cost;
  std::vector<float> m_distance;
  std::vector<Index> m_parent;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_NEIGHBOR_GRAPH_H
