// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the points of an object are from its root.

#ifndef CSCD_TREE_ROOT_DISTANCES_H
#define CSCD_TREE_ROOT_DISTANCES_H

#include <CSCD/Tree/Neighbor_graph.h>
#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CSCD::internal {

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
  Distance_front m_front;
  std::vector<float> m_cost;
  std::vector<float> m_distance;
  std::vector<Index> m_parent;
};

} // namespace CSCD::internal

#endif // CSCD_TREE_ROOT_DISTANCES_H
