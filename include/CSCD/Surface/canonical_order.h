// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Renumbers a surface so that the numbers depend on its shape alone, and neighbors have near numbers.

#ifndef CSCD_SURFACE_CANONICAL_ORDER_H
#define CSCD_SURFACE_CANONICAL_ORDER_H

#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// An order of the vertices of a surface, component by component.
struct Canonical_order
{
  std::vector<Index> vertices;        ///< the old number of every new vertex
  std::vector<Index> component_begin; ///< the first new vertex of every component, and their number at the end
};

/// Finds the canonical order: breadth-first over the rings, in counterclockwise order, which the root and its first
/// halfedge determine. Root is the vertex farthest from the centroid of its component, and its first halfedge leads to
/// the farthest neighbor; components come in order of decreasing area.
class Canonical_ordering
{
public:
  Canonical_ordering(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                     const Surface_components& components)
      : m_triangles(triangles), m_pairing(pairing), m_components(components)
  {
    find_roots();
  }

  Canonical_order order() const
  {
    std::vector<Index> sorted(m_components.number());
    std::iota(sorted.begin(), sorted.end(), Index(0));
    std::sort(sorted.begin(), sorted.end(), [this](Index c, Index d) { return key(c) < key(d); });
    Numbering numbering(m_triangles.points.size());
    Canonical_order result;
    for (Index component : sorted) {
      result.component_begin.push_back(Index(numbering.vertices.size()));
      append_component(m_first[component], numbering);
    }
    result.component_begin.push_back(Index(numbering.vertices.size()));
    result.vertices = std::move(numbering.vertices);
    return result;
  }

private:
  /// Distances that differ by less, relatively, are equal: they differ by rounding only, which depends on the order.
  static constexpr double distance_tolerance = 1e-9;
  /// Vertices ahead for which memory is asked for.
  static constexpr std::size_t prefetch_distance = 8;
  /// The vertices in the order so far.
  struct Numbering
  {
    explicit Numbering(std::size_t number_of_vertices) : is_numbered(number_of_vertices, 0)
    {
      vertices.reserve(number_of_vertices);
      parent.reserve(number_of_vertices);
    }

    void append(Index vertex, Index its_parent)
    {
      if (is_numbered[vertex] == 0) {
        is_numbered[vertex] = 1;
        vertices.push_back(vertex);
        parent.push_back(its_parent);
      }
    }

    std::vector<Index> vertices;
    std::vector<Index> parent; ///< of each of them, the neighbor at which its ring begins
    std::vector<char> is_numbered;
  };

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }
  const Vector_3& origin_point(Index h) const { return m_triangles.points[origin(h)]; }
  double squared_distance(Index vertex, Index component) const
  {
    return (m_triangles.points[vertex] - m_components.measures[component].centroid).squaredNorm();
  }

  /// The sums are rounded to single precision, so that the order of their terms does not matter.
  std::tuple<float, float, double, double, double> key(Index component) const
  {
    const Vector_3& root = origin_point(m_first[component]);
    return {-float(m_components.measures[component].area), -float(m_greatest[component]), root.x(), root.y(), root.z()};
  }

  /// Among equally far vertices the lexicographically smallest is the root; likewise for its neighbors.
  void find_roots()
  {
    const std::size_t n = m_triangles.points.size();
    m_greatest.assign(m_components.number(), 0.);
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index component = m_components.component_of_vertex(m_pairing, vertex);
      m_greatest[component] = std::max(m_greatest[component], squared_distance(vertex, component));
    }
    m_first.assign(m_components.number(), no_index);
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index component = m_components.component_of_vertex(m_pairing, vertex);
      Index& first = m_first[component];
      if (squared_distance(vertex, component) >= (1 - distance_tolerance) * m_greatest[component] &&
          (first == no_index || is_lexicographically_less(m_triangles.points[vertex], origin_point(first)))) {
        first = *m_pairing.outgoing()[vertex].begin();
      }
    }
    for (Index component = 0; component < m_components.number(); ++component) {
      m_first[component] = first_halfedge(m_first[component], component);
    }
  }

  /// The halfedge around the origin of `start` that leads farthest from the centroid.
  Index first_halfedge(Index start, Index component) const
  {
    double greatest = 0;
    Index halfedge = start;
    do {
      greatest = std::max(greatest, squared_distance(target(halfedge), component));
      halfedge = next_around_origin(halfedge);
    } while (halfedge != start);
    Index result = no_index;
    do {
      if (squared_distance(target(halfedge), component) >= (1 - distance_tolerance) * greatest &&
          (result == no_index ||
           is_lexicographically_less(m_triangles.points[target(halfedge)], m_triangles.points[target(result)]))) {
        result = halfedge;
      }
      halfedge = next_around_origin(halfedge);
    } while (halfedge != start);
    return result;
  }

  Index next_around_origin(Index h) const { return m_pairing.twin(Halfedge_pairing::previous(h)); }

  /// Asks for what the vertices that come soon need: where their numbers are scattered, most of the time goes to
  /// waiting.
  void prefetch_rows([[maybe_unused]] const Numbering& numbering, [[maybe_unused]] std::size_t i) const
  {
#ifdef __GNUC__
    if (i + 2 * prefetch_distance < numbering.vertices.size()) {
      __builtin_prefetch(m_pairing.outgoing()[numbering.vertices[i + 2 * prefetch_distance]].begin());
      const auto row = m_pairing.outgoing()[numbering.vertices[i + prefetch_distance]];
      for (std::size_t j = 0; j < row.size(); j += 2) {
        __builtin_prefetch(&m_triangles.faces[row.begin()[j] / 3]);
      }
    }
#endif
  }

  /// Writes the neighbors of `vertex` to `ring`, counterclockwise.
  void read_ring(Index vertex, std::vector<Index>& ring) const
  {
    ring.clear();
    for (const Index halfedge : m_pairing.outgoing()[vertex]) {
      ring.push_back(target(halfedge));
    }
  }

  void append_component(Index first, Numbering& numbering) const
  {
    std::vector<Index> ring;
    std::size_t at = numbering.vertices.size();
    numbering.append(origin(first), target(first));
    for (; at < numbering.vertices.size(); ++at) {
      prefetch_rows(numbering, at);
      const Index vertex = numbering.vertices[at];
      read_ring(vertex, ring);
      std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), numbering.parent[at]), ring.end());
      for (const Index neighbor : ring) {
        numbering.append(neighbor, vertex);
      }
    }
  }

  const Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
  const Surface_components& m_components;
  std::vector<double> m_greatest; // squared distance from the centroid, of every component
  std::vector<Index> m_first;     // the halfedge with which every component begins
};

/// Finds an order of the vertices that does not depend on their numbers nor, up to rounding and symmetry, on the pose
/// of the surface. O(n + c log c) for c components.
/// \pre `triangles` is closed, without isolated vertices; `pairing` and `components` are those of its faces
inline Canonical_order canonical_order(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                       const Surface_components& components)
{
  return Canonical_ordering(triangles, pairing, components).order();
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_CANONICAL_ORDER_H
