// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closes the borders of a surface with triangles that carry no area.

#ifndef CSCD_SURFACE_BRIDGE_BORDERS_H
#define CSCD_SURFACE_BRIDGE_BORDERS_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>

#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The halfedges of each border, in order against their direction. Linear.
/// \pre `pairing` is that of the faces of `triangles`, and has no pinched vertex
inline std::vector<std::vector<Index>> border_cycles(const Indexed_triangles& triangles,
                                                     const Halfedge_pairing& pairing)
{
  const auto origin = [&triangles](Index h) { return triangles.faces[h / 3][h % 3]; };
  // The border has one fan of faces at each of its vertices, hence one halfedge that ends there.
  std::vector<Index> into(triangles.points.size(), no_index);
  for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
    if (pairing.twin(h) == no_index) {
      into[origin(Halfedge_pairing::next(h))] = h;
    }
  }
  std::vector<std::vector<Index>> cycles;
  for (Index start = 0; start < into.size(); ++start) {
    std::vector<Index> cycle;
    for (Index vertex = start; into[vertex] != no_index; vertex = origin(cycle.back())) {
      cycle.push_back(std::exchange(into[vertex], no_index));
    }
    if (!cycle.empty()) {
      cycles.push_back(std::move(cycle));
    }
  }
  return cycles;
}

/// Closes holes, one after the other, by cutting off the corner with the shortest diagonal again and again.
/// A slit is thereby zipped across and a round hole filled evenly.
class Border_bridge
{
public:
  Border_bridge(Indexed_triangles& triangles, const Halfedge_pairing& pairing) : m_triangles(triangles)
  {
    std::vector<char> on_border(triangles.points.size(), 0);
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      if (pairing.twin(h) == no_index) {
        on_border[origin(h)] = 1;
      }
    }
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      if (on_border[origin(h)] && on_border[target(h)]) {
        m_edges.insert(edge(origin(h), target(h)));
      }
    }
  }

  /// Closes every hole and returns their number.
  std::size_t close_all(const Halfedge_pairing& pairing)
  {
    const std::vector<std::vector<Index>> cycles = border_cycles(m_triangles, pairing);
    for (std::vector<Index> hole : cycles) {
      std::transform(hole.begin(), hole.end(), hole.begin(), [this](Index h) { return target(h); });
      close(hole);
    }
    return cycles.size();
  }

private:
  /// A corner of the hole that may be cut off, valid while its version is that of the corner.
  struct Ear
  {
    double squared_diagonal;
    Index corner;
    Index version;
    bool operator<(const Ear& other) const // the least comes first out of the queue
    {
      return std::tie(other.squared_diagonal, other.corner) < std::tie(squared_diagonal, corner);
    }
  };

  /// The part of a hole that is still open, as a circular list of corners.
  struct Open_polygon
  {
    explicit Open_polygon(const std::vector<Index>& hole)
        : vertex(hole), previous(hole.size()), next(hole.size()), version(hole.size(), 0), size(Index(hole.size()))
    {
      for (Index i = 0; i < size; ++i) {
        next[i] = (i + 1) % size;
        previous[next[i]] = i;
      }
    }

    std::array<Index, 3> triangle(Index corner) const
    {
      return {vertex[previous[corner]], vertex[corner], vertex[next[corner]]};
    }
    void remove(Index corner)
    {
      next[previous[corner]] = next[corner];
      previous[next[corner]] = previous[corner];
      for (Index changed : {previous[corner], corner, next[corner]}) {
        ++version[changed];
      }
      --size;
    }

    std::vector<Index> vertex, previous, next, version;
    Index size;
  };

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }

  static std::uint64_t edge(Index a, Index b)
  {
    const auto [smaller, larger] = std::minmax(a, b);
    return (std::uint64_t(smaller) << 32) | larger;
  }

  void push_ear(const Open_polygon& polygon, Index corner)
  {
    const std::array<Index, 3> ear = polygon.triangle(corner);
    if (m_edges.count(edge(ear[0], ear[2])) == 0) {
      const double squared_diagonal = (m_triangles.points[ear[0]] - m_triangles.points[ear[2]]).squaredNorm();
      m_ears.push({squared_diagonal, corner, polygon.version[corner]});
    }
  }

  void close(std::vector<Index>& hole)
  {
    start_at_min_point(hole);
    Open_polygon polygon(hole);
    m_ears = {};
    for (Index corner = 0; corner < polygon.size; ++corner) {
      push_ear(polygon, corner);
    }
    Index some_corner = 0;
    while (polygon.size > 3 && !m_ears.empty()) {
      const Ear ear = m_ears.top();
      m_ears.pop();
      const std::array<Index, 3> triangle = polygon.triangle(ear.corner);
      if (ear.version != polygon.version[ear.corner] || m_edges.count(edge(triangle[0], triangle[2])) != 0) {
        continue;
      }
      m_triangles.faces.push_back(triangle);
      m_edges.insert(edge(triangle[0], triangle[2]));
      polygon.remove(ear.corner);
      some_corner = polygon.next[ear.corner];
      push_ear(polygon, polygon.previous[ear.corner]);
      push_ear(polygon, polygon.next[ear.corner]);
    }
    if (polygon.size == 3) {
      m_triangles.faces.push_back(polygon.triangle(some_corner));
    } else {
      close_by_fan(polygon, some_corner);
    }
  }

  /// Rotates `hole` to begin at its lexicographically least point. Ties between ears are broken by the number of the
  /// corner, which thus does not depend on the numbering of the input.
  void start_at_min_point(std::vector<Index>& hole) const
  {
    const auto is_less = [this](Index a, Index b) {
      return is_lexicographically_less(m_triangles.points[a], m_triangles.points[b]);
    };
    std::rotate(hole.begin(), std::min_element(hole.begin(), hole.end(), is_less), hole.end());
  }

  /// Every diagonal of what is left is an edge of the surface already: only a new vertex can close it.
  void close_by_fan(const Open_polygon& polygon, Index first)
  {
    const Index center = Index(m_triangles.points.size());
    Vector_3 sum = Vector_3::Zero();
    Index corner = first;
    do {
      sum += m_triangles.points[polygon.vertex[corner]];
      m_triangles.faces.push_back({polygon.vertex[corner], polygon.vertex[polygon.next[corner]], center});
      corner = polygon.next[corner];
    } while (corner != first);
    m_triangles.points.push_back(sum / double(polygon.size));
  }

  Indexed_triangles& m_triangles;
  boost::unordered_set<std::uint64_t> m_edges; // between vertices of the border, old and new
  std::priority_queue<Ear> m_ears;
};

/// Closes every border cycle of `triangles` with hole-filling faces, which come after `first_hole_filling_face`.
/// No vertices are added, except one where all diagonals of a hole are edges of the surface already.
/// O(n + b log b) for a border of b edges.
/// \return the number of border cycles that were closed
/// \pre `triangles` is a manifold, `pairing` is that of its faces, and none of them is bridging
inline std::size_t bridge_borders(Indexed_triangles& triangles, const Halfedge_pairing& pairing)
{
  return pairing.has_border() ? Border_bridge(triangles, pairing).close_all(pairing) : 0;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_BRIDGE_BORDERS_H
