// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which vertices triangles join.

#ifndef CSCD_POINT_CLOUD_VERTEX_NEIGHBORS_H
#define CSCD_POINT_CLOUD_VERTEX_NEIGHBORS_H

#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// The neighbors of every vertex in some triangles, each once, by ascending number.
struct Vertex_neighbors
{
  /// O(n) for bounded degrees.
  /// \param triangles a range of what `vertices_of` maps to three vertices
  template <class Triangles, class VerticesOf>
  Vertex_neighbors(std::size_t number_of_vertices, const Triangles& triangles, const VerticesOf& vertices_of)
      : begin(number_of_vertices + 1, 0)
  {
    for (const auto& triangle : triangles) {
      for (const Index vertex : vertices_of(triangle)) {
        begin[vertex + 1] += 2;
      }
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    neighbors.resize(begin.back());
    std::vector<Index> end(begin.begin(), begin.end() - 1);
    for (const auto& triangle : triangles) {
      const std::array<Index, 3>& vertices = vertices_of(triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        neighbors[end[vertices[k]]++] = vertices[(k + 1) % 3];
        neighbors[end[vertices[k]]++] = vertices[(k + 2) % 3];
      }
    }
    remove_duplicates();
  }

  std::vector<Index> begin;     ///< of the neighbors of every vertex, and the end of all
  std::vector<Index> neighbors; ///< vertex by vertex

private:
  void remove_duplicates()
  {
    auto to = neighbors.begin();
    auto from = neighbors.begin();
    for (std::size_t vertex = 0; vertex + 1 < begin.size(); ++vertex) {
      const auto end = neighbors.begin() + begin[vertex + 1];
      std::sort(from, end);
      begin[vertex] = Index(to - neighbors.begin());
      to = std::unique_copy(from, end, to);
      from = end;
    }
    begin.back() = Index(to - neighbors.begin());
    neighbors.erase(to, neighbors.end());
  }
};

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_VERTEX_NEIGHBORS_H
