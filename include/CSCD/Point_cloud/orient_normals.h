// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns normals of either orientation so that neighbors agree.

#ifndef CSCD_POINT_CLOUD_ORIENT_NORMALS_H
#define CSCD_POINT_CLOUD_ORIENT_NORMALS_H

#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The normal that a point at direction `edge` has if both lie on a circular arc, and the other has `normal`. On flat
/// ground it is the same; across an edge of a body it is that of the other side.
inline Vector_3 mirrored_normal(const Vector_3& normal, const Vector_3& edge)
{
  return normal - 2 * edge.dot(normal) / edge.squaredNorm() * edge;
}

/// Turns `normals` so that they agree with those of neighbors, starting from the least vertex of each component of
/// `triangles`: along a spanning tree of the edges at which they differ least from what an arc would have (after H.
/// Hoppe et al., "Surface reconstruction from unorganized points", 1992; S. König, S. Gumhold, "Consistent propagation
/// of normal orientations in point clouds", 2009), but of edges of triangles only, which do not lead from one sheet to
/// the next. O(n log n).
inline void orient_normals(const std::vector<Vector_3>& points, std::vector<Vector_3>& normals,
                           const std::vector<std::array<Index, 3>>& triangles)
{
  struct Edge
  {
    double difference;
    Index a;
    Index b;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
      const double agreement = mirrored_normal(normals[a], points[b] - points[a]).dot(normals[b]);
      edges.push_back({1 - std::abs(agreement), a, b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::tie(x.difference, x.a, x.b) < std::tie(y.difference, y.a, y.b);
  });
  Disjoint_sets sets(normals.size());
  std::vector<std::pair<Index, Index>> tree; // both ways
  for (const Edge& edge : edges) {
    if (sets.join(edge.a, edge.b)) {
      tree.emplace_back(edge.a, edge.b);
      tree.emplace_back(edge.b, edge.a);
    }
  }
  std::sort(tree.begin(), tree.end());
  std::vector<char> is_oriented(normals.size(), 0);
  std::vector<Index> stack;
  for (Index seed = 0; seed < normals.size(); ++seed) {
    if (is_oriented[seed] != 0) {
      continue;
    }
    is_oriented[seed] = 1;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index vertex = stack.back();
      stack.pop_back();
      for (auto edge = std::lower_bound(tree.begin(), tree.end(), std::make_pair(vertex, Index(0)));
           edge != tree.end() && edge->first == vertex; ++edge) {
        Vector_3& normal = normals[edge->second];
        if (is_oriented[edge->second] == 0) {
          is_oriented[edge->second] = 1;
          stack.push_back(edge->second);
          const Vector_3 expected = mirrored_normal(normals[vertex], points[edge->second] - points[vertex]);
          normal = expected.dot(normal) < 0 ? Vector_3(-normal) : normal;
        }
      }
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_ORIENT_NORMALS_H
