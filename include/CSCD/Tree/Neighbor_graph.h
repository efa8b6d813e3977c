// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points of a scan are next to each other.

#ifndef CSCD_TREE_NEIGHBOR_GRAPH_H
#define CSCD_TREE_NEIGHBOR_GRAPH_H

#include <CSCD/Point_cloud/Neighbor_table.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
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
  CGAL::Iterator_range<const Index*> neighbors(Index point) const
  {
    return {m_neighbors.data() + m_begin[point], m_neighbors.data() + m_begin[point + 1]};
  }
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
      const auto middle = around.begin() + std::ptrdiff_t(around.size() / 2);
      std::nth_element(around.begin(), middle, around.end());
      m_spacing[point] = *middle;
    }
  }

  void index_edges()
  {
    m_begin.assign(m_spacing.size() + 1, 0);
    for (const auto& [a, b] : m_edges) {
      ++m_begin[a + 1];
      ++m_begin[b + 1];
    }
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    std::vector<Index> fill(m_begin.begin(), m_begin.end() - 1);
    m_neighbors.resize(2 * m_edges.size());
    for (const auto& [a, b] : m_edges) {
      m_neighbors[fill[a]++] = b;
      m_neighbors[fill[b]++] = a;
    }
  }

  std::vector<double> m_spacing;
  std::vector<Edge> m_edges; // bridges last
  std::size_t m_number_of_own_edges = 0;
  std::vector<Index> m_begin;
  std::vector<Index> m_neighbors;
};

} // namespace CSCD::internal

#endif // CSCD_TREE_NEIGHBOR_GRAPH_H
