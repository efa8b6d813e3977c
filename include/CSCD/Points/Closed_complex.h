// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The closed surface of which a complex of points is a part.

#ifndef CSCD_POINTS_CLOSED_COMPLEX_H
#define CSCD_POINTS_CLOSED_COMPLEX_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Reconstructed_surface.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A complex with its holes closed, its fragments joined, and bridges between sheets cut, as where a surface is made of
/// points: it tells what is connected.
class Closed_complex
{
public:
  /// O(n log n) where false handles are few.
  explicit Closed_complex(const Point_complex& complex)
      : m_completed(complete(complex)), m_surface(Indexed_triangles(m_completed.triangles))
  {
  }

  /// The closed surface.
  const Triangulated_surface& surface() const { return m_surface; }

  /// For each vertex of the surface, its region; each region is connected. `no_index` in components of which no region
  /// has its largest part. O(n log n).
  /// \param region that of a vertex of the complex
  template <class Region>
  std::vector<Index> regions(const Region& region) const
  {
    std::vector<Index> result(m_surface.number_of_vertices(), no_index);
    for (Index vertex = 0; vertex < result.size(); ++vertex) {
      if (vertex < m_completed.point_of_vertex.size() && m_completed.point_of_vertex[vertex] != no_index) {
        result[vertex] = region(m_completed.point_of_vertex[vertex]);
      }
    }
    const std::vector<char> is_kept = largest_parts(result);
    Multi_source_dijkstra_search front(result.size());
    for (Index vertex = 0; vertex < result.size(); ++vertex) {
      if (is_kept[vertex] != 0) {
        front.reach(vertex, 0, result[vertex]);
      }
    }
    front.spread([this](Index vertex, const auto& visit) {
      for (const Index halfedge : m_surface.outgoing(vertex)) {
        visit(m_surface.target(halfedge), float(m_surface.length(halfedge)));
      }
    });
    for (Index vertex = 0; vertex < result.size(); ++vertex) {
      result[vertex] = front.label(vertex);
    }
    return result;
  }

private:
  static Reconstructed_surface complete(const Point_complex& complex)
  {
    Reconstructed_surface result;
    result.triangles.points = complex.points();
    std::set<std::pair<Index, Index>> sides;
    for (Index face = 0; face < complex.number_of_faces(); ++face) {
      const std::array<Index, 3> halfedges = complex.face_halfedges(face);
      const auto is_met = [&](Index h) { return sides.count({complex.origin(h), complex.target(h)}) > 0; };
      if (std::none_of(halfedges.begin(), halfedges.end(), is_met)) {
        std::array<Index, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
          corners[k] = complex.origin(halfedges[k]);
          sides.insert({corners[k], complex.target(halfedges[k])});
        }
        result.triangles.faces.push_back(corners);
      }
    }
    Surface_completion complete(result, Normalization());
    complete.prepare();
    complete();
    return result;
  }

  /// Which vertices are in the largest connected part of their region.
  std::vector<char> largest_parts(const std::vector<Index>& region) const
  {
    const auto n = Index(region.size());
    Disjoint_sets parts(n);
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      if (region[m_surface.origin(h)] == region[m_surface.target(h)]) {
        parts.join(m_surface.origin(h), m_surface.target(h));
      }
    }
    std::vector<Index> size(n, 0);
    for (Index vertex = 0; vertex < n; ++vertex) {
      ++size[parts.find(vertex)];
    }
    std::vector<Index> largest; // of each region, the vertex that stands for its part
    for (Index vertex = 0; vertex < n; ++vertex) {
      if (region[vertex] == no_index) {
        continue;
      }
      largest.resize(std::max<std::size_t>(largest.size(), region[vertex] + 1), no_index);
      Index& best = largest[region[vertex]];
      const Index part = parts.find(vertex);
      if (best == no_index || size[part] > size[best]) {
        best = part;
      }
    }
    std::vector<char> result(n, 0);
    for (Index vertex = 0; vertex < n; ++vertex) {
      result[vertex] = region[vertex] != no_index && largest[region[vertex]] == parts.find(vertex) ? 1 : 0;
    }
    return result;
  }

  Reconstructed_surface m_completed;
  Triangulated_surface m_surface;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_CLOSED_COMPLEX_H
