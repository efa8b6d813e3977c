// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the pieces of the cut surface lie in space.

#ifndef CSCD_SKELETON_SURFACE_PIECES_H
#define CSCD_SKELETON_SURFACE_PIECES_H

#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Selection/Surface_regions.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// The vertices of each piece, on the level of the regions, and what follows from them.
class Surface_pieces
{
public:
  Surface_pieces(const Cut_graph& cut_graph, const Surface_regions& regions) : m_regions(regions)
  {
    const Triangulated_surface& surface = regions.level().surface;
    const Index n = surface.number_of_vertices();
    std::vector<Index> piece(n);
    m_begin.assign(cut_graph.pieces().size() + 1, 0);
    for (Index vertex = 0; vertex < n; ++vertex) {
      piece[vertex] = cut_graph.piece_of_vertex(regions.level().to_finest(vertex));
      ++m_begin[piece[vertex] + 1];
    }
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_vertices.resize(n);
    std::vector<Index> fill(m_begin.begin(), m_begin.end() - 1);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_vertices[fill[piece[vertex]]++] = vertex;
    }
  }

  /// The vertices of `piece`; none in a piece that is smaller than the triangles of the level.
  CGAL::Iterator_range<const Index*> vertices(Index piece) const
  {
    return {m_vertices.data() + m_begin[piece], m_vertices.data() + m_begin[piece + 1]};
  }
  bool is_empty(Index piece) const { return m_begin[piece] == m_begin[piece + 1]; }

  /// A sum of points by area.
  struct Weighted_sum
  {
    Vector_3 sum = Vector_3::Zero();
    double weight = 0;

    void add(const Vector_3& point, double point_weight)
    {
      sum += point_weight * point;
      weight += point_weight;
    }
  };

  /// The area-weighted sum of those vertices of `piece` that are at least `least_distance` from its separators.
  Weighted_sum area_sum(Index piece, float least_distance = 0) const
  {
    const Triangulated_surface& surface = m_regions.level().surface;
    Weighted_sum result;
    for (Index vertex : vertices(piece)) {
      if (m_regions.distance(vertex) >= least_distance) {
        result.add(surface.point(vertex), double(surface.vertex_area(vertex)));
      }
    }
    return result;
  }

  /// The largest distance of a vertex of `piece` from its separators; 0 in an empty piece.
  float height(Index piece) const
  {
    float result = 0;
    for (Index vertex : vertices(piece)) {
      result = std::max(result, m_regions.distance(vertex));
    }
    return result;
  }

  /// The largest extent of `piece` from `origin` in `direction`; 0 where it does not reach beyond `origin`.
  double extent(Index piece, const Vector_3& origin, const Vector_3& direction) const
  {
    double result = 0;
    for (Index vertex : vertices(piece)) {
      result = std::max(result, direction.dot(m_regions.level().surface.point(vertex) - origin));
    }
    return result;
  }

private:
  const Surface_regions& m_regions;
  std::vector<Index> m_begin;
  std::vector<Index> m_vertices;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_SURFACE_PIECES_H
