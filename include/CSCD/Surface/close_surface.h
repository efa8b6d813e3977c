// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closes a surface: borders are bridged, cavities filled.

#ifndef CSCD_SURFACE_CLOSE_SURFACE_H
#define CSCD_SURFACE_CLOSE_SURFACE_H

#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

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
  // The border has one fan of faces at each of its vertices, hence one halfedge that ends there.
  std::vector<Index> into(triangles.points.size(), no_index);
  for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
    if (pairing.twin(h) == no_index) {
      into[triangles.target(h)] = h;
    }
  }
  std::vector<std::vector<Index>> cycles;
  for (Index start = 0; start < into.size(); ++start) {
    std::vector<Index> cycle;
    for (Index vertex = start; into[vertex] != no_index; vertex = triangles.origin(cycle.back())) {
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
        on_border[triangles.origin(h)] = 1;
      }
    }
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      if (on_border[triangles.origin(h)] && on_border[triangles.target(h)]) {
        m_edges.insert(edge(triangles.origin(h), triangles.target(h)));
      }
    }
  }

  /// Closes every hole and returns their number.
  std::size_t close_all(const Halfedge_pairing& pairing)
  {
    const std::vector<std::vector<Index>> cycles = border_cycles(m_triangles, pairing);
    for (std::vector<Index> hole : cycles) {
      std::transform(hole.begin(), hole.end(), hole.begin(), [this](Index h) { return m_triangles.target(h); });
      close(hole);
    }
    return cycles.size();
  }

  /// Closes the hole with these corners, counterclockwise as its faces will be.
  void close(std::vector<Index>& hole)
  {
    start_at_farthest_point(hole);
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

private:
  /// A corner of the hole that may be cut off, valid while its version is that of the corner.
  struct Ear
  {
    float squared_diagonal; // single precision, so that rounding does not order equal ones
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

  static std::uint64_t edge(Index a, Index b)
  {
    const auto [smaller, larger] = std::minmax(a, b);
    return (std::uint64_t(smaller) << 32) | larger;
  }

  void push_ear(const Open_polygon& polygon, Index corner)
  {
    const std::array<Index, 3> ear = polygon.triangle(corner);
    if (m_edges.count(edge(ear[0], ear[2])) == 0) {
      const auto squared_diagonal = float((m_triangles.points[ear[0]] - m_triangles.points[ear[2]]).squaredNorm());
      m_ears.push({squared_diagonal, corner, polygon.version[corner]});
    }
  }

  /// Rotates `hole` to begin at the corner that is farthest from the mean of all, of equally far ones at the
  /// lexicographically least, up to rounding. Ties between ears are broken by the number of the corner, which thus
  /// depends neither on the numbering of the input nor on its pose.
  void start_at_farthest_point(std::vector<Index>& hole) const
  {
    const auto point = [this](Index vertex) -> const Vector3& { return m_triangles.points[vertex]; };
    Vector3 sum = Vector3::Zero();
    for (const Index corner : hole) {
      sum += point(corner);
    }
    const Vector3 mean = sum / double(hole.size());
    const auto key = [&](Index corner) {
      const Vector3 place = on_grid(point(corner));
      return std::tuple(-float((point(corner) - mean).squaredNorm()), place.x(), place.y(), place.z());
    };
    const auto is_less = [&key](Index a, Index b) { return key(a) < key(b); };
    std::rotate(hole.begin(), std::min_element(hole.begin(), hole.end(), is_less), hole.end());
  }

  /// Every diagonal of the rest is an edge of the surface already: only a new vertex can close it.
  void close_by_fan(const Open_polygon& polygon, Index first)
  {
    const Index center = Index(m_triangles.points.size());
    Vector3 sum = Vector3::Zero();
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

/// The components of a surface that bound cavities: they face inwards, and lie within components that face outwards.
class Cavity_search
{
public:
  /// Both are referred to.
  Cavity_search(const Indexed_triangles& triangles, const Surface_components& components)
      : m_triangles(triangles), m_components(components), m_is_cavity(components.number(), 0)
  {
  }

  /// Whether each component is such a cavity; a body in it has a skeleton of its own. O(n log n) where any component
  /// faces inwards.
  std::vector<char> operator()()
  {
    if (m_components.number() == 1) {
      return m_is_cavity;
    }
    for (Index c = 0; c < m_components.number(); ++c) {
      m_is_cavity[c] = m_components.measures[c].faces_inwards() && !m_components.measures[c].is_sheet ? 1 : 0;
    }
    if (std::count(m_is_cavity.begin(), m_is_cavity.end(), 1) > 0) {
      keep_within_bodies();
    }
    return m_is_cavity;
  }

private:
  /// This many faces of a component are tested for being within bodies, ...
  static constexpr std::size_t max_samples = 1024;
  /// ... and of their area this part has to be: a body moved inwards along its normals comes out of thin limbs.
  static constexpr double min_area_within = 0.8;

  /// The components that are not candidates, as a surface of their own.
  Triangulated_surface bodies() const
  {
    Indexed_triangles part = m_triangles;
    remove_components(part, m_components, [this](Index c) { return m_is_cavity[c] != 0; });
    return Triangulated_surface(std::move(part));
  }

  void keep_within_bodies()
  {
    const Triangulated_surface surface = bodies();
    if (surface.number_of_faces() == 0) {
      std::fill(m_is_cavity.begin(), m_is_cavity.end(), 0);
      return;
    }
    const Solid_queries queries(surface);
    std::vector<std::size_t> number_of_visits(m_components.number(), 0);
    std::vector<double> excess(m_components.number(), 0); // outside of bodies, less the allowance
    for (std::size_t face = 0; face < m_triangles.faces.size(); ++face) {
      const Index c = m_components.component[face];
      const std::size_t stride = m_components.measures[c].number_of_faces / max_samples + 1;
      if (m_is_cavity[c] != 0 && number_of_visits[c]++ % stride == 0) {
        const auto& [i, j, k] = m_triangles.faces[face];
        const Vector3& corner = m_triangles.points[i];
        const double area = triangle_area(corner, m_triangles.points[j], m_triangles.points[k]);
        excess[c] += (queries.is_inside(corner) ? 0 : area) - (1 - min_area_within) * area;
      }
    }
    for (Index c = 0; c < m_components.number(); ++c) {
      m_is_cavity[c] = m_is_cavity[c] != 0 && excess[c] <= 0 ? 1 : 0;
    }
  }

  const Indexed_triangles& m_triangles;
  const Surface_components& m_components;
  std::vector<char> m_is_cavity;
};

/// The parts taken out of a surface.
struct Filled_cavities
{
  std::size_t number = 0;
  std::vector<Index> old_number; ///< of every remaining point; empty without a cavity
  std::vector<Index> vertices;   ///< the points of the input that were taken out, by their old numbers,
  std::vector<Vector3> places;   ///< and where they are
};

/// Takes the surfaces of cavities, as in a hollowed statue, out of `triangles`.
/// \param number_of_input_points the points from this one on are not of the input
/// \param side of every vertex, not 0 on a sheet; empty without sheets
/// \pre `pairing` and `components` are those of `triangles`, and are kept so
inline Filled_cavities fill_cavities(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                     Surface_components& components, std::size_t number_of_input_points,
                                     const std::vector<signed char>& side = {})
{
  const std::vector<char> is_cavity = Cavity_search(triangles, components)();
  Filled_cavities result;
  result.number = std::size_t(std::count(is_cavity.begin(), is_cavity.end(), 1));
  if (result.number == 0) {
    return result;
  }
  for (Index point = 0; point < number_of_input_points; ++point) {
    if (is_cavity[components.component_of_vertex(pairing, point)] != 0) {
      result.vertices.push_back(point);
      result.places.push_back(triangles.points[point]);
    }
  }
  result.old_number = remove_components(triangles, components, [&](Index c) { return is_cavity[c] != 0; });
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  components = Surface_components(triangles, reordered(side, result.old_number));
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_CLOSE_SURFACE_H
