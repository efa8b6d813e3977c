// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns normals of either orientation so that neighbors agree.

#ifndef CSCD_POINTS_ORIENT_NORMALS_H
#define CSCD_POINTS_ORIENT_NORMALS_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The normal that a point at direction `edge` has if both lie on a circular arc, and the other has `normal`. On flat
/// ground it is the same; across an edge of a body it is that of the other side.
inline Vector_3 mirrored_normal(const Vector_3& normal, const Vector_3& edge)
{
  return normal - 2 * edge.dot(normal) / edge.squaredNorm() * edge;
}

/// Turns normals along a spanning tree.
class Normal_orientation
{
public:
  Normal_orientation(const std::vector<Vector_3>& points, std::vector<Vector_3>& normals)
      : m_points(points), m_normals(normals)
  {
  }

  void operator()(const std::vector<std::array<Index, 3>>& triangles)
  {
    find_tree(Vertex_neighbors(
        m_points.size(), triangles, [](const auto& triangle) -> auto& { return triangle; }));
    m_is_oriented.assign(m_points.size(), 0);
    for (Index vertex = 0; vertex < m_points.size(); ++vertex) {
      if (m_is_oriented[vertex] == 0) {
        orient_from(vertex);
      }
    }
  }

private:
  using Edge = std::pair<Index, Index>;

  /// Takes the edges at which normals differ least.
  void find_tree(const Vertex_neighbors& neighbors)
  {
    std::vector<std::pair<double, Edge>> edges; // by what the normals differ
    edges.reserve(neighbors.number_of_values() / 2);
    for (Index a = 0; a < m_points.size(); ++a) {
      for (const Index b : neighbors[a]) {
        if (a < b) {
          edges.push_back({1 - std::abs(expected(a, b).dot(m_normals[b])), {a, b}});
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    Disjoint_sets sets(m_points.size());
    for (const auto& [difference, edge] : edges) {
      if (sets.join(edge.first, edge.second)) {
        m_tree.push_back(edge);
        m_tree.emplace_back(edge.second, edge.first);
      }
    }
    std::sort(m_tree.begin(), m_tree.end());
  }

  /// What the normal of `b` should be, judging by that of `a`.
  Vector_3 expected(Index a, Index b) const { return mirrored_normal(m_normals[a], m_points[b] - m_points[a]); }

  void orient_from(Index seed)
  {
    m_is_oriented[seed] = 1;
    m_stack.push_back(seed);
    while (!m_stack.empty()) {
      const Index a = m_stack.back();
      m_stack.pop_back();
      auto edge = std::lower_bound(m_tree.begin(), m_tree.end(), Edge(a, 0));
      for (; edge != m_tree.end() && edge->first == a; ++edge) {
        const Index b = edge->second;
        if (m_is_oriented[b] == 0) {
          m_is_oriented[b] = 1;
          m_stack.push_back(b);
          if (expected(a, b).dot(m_normals[b]) < 0) {
            m_normals[b] = -m_normals[b];
          }
        }
      }
    }
  }

  const std::vector<Vector_3>& m_points;
  std::vector<Vector_3>& m_normals;
  std::vector<Edge> m_tree; // each edge both ways, sorted
  std::vector<char> m_is_oriented;
  std::vector<Index> m_stack;
};

/// Turns `normals` so that they agree with those of neighbors, starting from the first vertex of each component of
/// `triangles`: along a spanning tree of the edges at which they differ least from what an arc would have (after H.
/// Hoppe et al., "Surface reconstruction from unorganized points", 1992; S. König, S. Gumhold, "Consistent propagation
/// of normal orientations in point clouds", 2009), but of edges of triangles only, which do not lead from one sheet to
/// the next. O(n log n).
inline void orient_normals(const std::vector<Vector_3>& points, std::vector<Vector_3>& normals,
                           const std::vector<std::array<Index, 3>>& triangles)
{
  Normal_orientation orientation(points, normals);
  orientation(triangles);
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_ORIENT_NORMALS_H
