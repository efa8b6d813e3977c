// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits faces that are too large for the surface to be sampled by its vertices.

#ifndef CSCD_SURFACE_REFINE_LARGE_FACES_H
#define CSCD_SURFACE_REFINE_LARGE_FACES_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Splits the second face of every component of two faces at its center. Such a component is what a single triangle
/// becomes when its border is bridged; refined as it is, it would get several edges between the same vertices. Linear.
/// \return the number of inserted vertices
/// \pre `triangles` is closed; `pairing` and `components` are those of its faces, and are kept so
inline std::size_t split_two_face_components(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                             Surface_components& components)
{
  std::vector<Index> number_of_faces(components.number(), 0);
  for (Index component : components.component) {
    ++number_of_faces[component];
  }
  if (std::find(number_of_faces.begin(), number_of_faces.end(), Index(2)) == number_of_faces.end()) {
    return 0;
  }
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> component_of_face;
  std::vector<char> is_visited(components.number(), 0);
  const std::size_t number_of_points = triangles.points.size();
  std::size_t first_hole_filling_face = 0;
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    const auto [a, b, c] = triangles.faces[f];
    const Index component = components.component[f];
    if (number_of_faces[component] == 2 && is_visited[component]) {
      const Index center = Index(triangles.points.size());
      triangles.points.push_back((triangles.points[a] + triangles.points[b] + triangles.points[c]) / 3);
      faces.insert(faces.end(), {{a, b, center}, {b, c, center}, {c, a, center}});
    } else {
      faces.push_back(triangles.faces[f]);
    }
    is_visited[component] = 1;
    component_of_face.resize(faces.size(), component);
    first_hole_filling_face = f < triangles.first_hole_filling_face ? faces.size() : first_hole_filling_face;
  }
  triangles.faces = std::move(faces);
  triangles.first_hole_filling_face = first_hole_filling_face;
  components.component = std::move(component_of_face);
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  return triangles.points.size() - number_of_points;
}

/// Vertices that sample a body well enough for fronts and loops. Fuzz targets are run with fewer, for a tenth of the
/// time.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr double size_of_sampled_body = 100;
#else
inline constexpr double size_of_sampled_body = 2000;
#endif

/// Splits long edges at their midpoints, round by round, until none is longer than the bound of its component.
class Face_refinement
{
public:
  Face_refinement(Indexed_triangles& triangles, Halfedge_pairing& pairing, Surface_components& components)
      : m_triangles(triangles), m_pairing(pairing), m_components(components),
        m_budget(triangles.points.size() * maximum_growth + free_vertices)
  {
    const std::vector<std::size_t> genus = genus_of_components(triangles, pairing, components);
    // Halving all edges of a surface of genus g takes this many vertices more than of a sphere.
    constexpr std::size_t midpoints_per_handle = 6;
    m_budget += midpoints_per_handle * std::accumulate(genus.begin(), genus.end(), std::size_t(0));
    set_bounds(genus);
  }

  /// Refines and returns the number of inserted vertices.
  std::size_t refine()
  {
    const std::size_t number_of_points = m_triangles.points.size();
    while (has_long_edge() && insert_midpoints()) {
      split_faces();
      m_pairing = Halfedge_pairing(m_triangles.faces, m_triangles.points.size());
    }
    return m_triangles.points.size() - number_of_points;
  }

private:
  /// Vertices that sample a handle well enough: with fewer, there is no room for a loop around each of many struts.
  static constexpr double target_size_of_handle = 32;
  /// The longest edge allowed, relative to the square root of the area that each of these vertices has.
  /// An even triangulation has edges of 1.07; the factor keeps clear of uneven ones and of the halving of edges.
  static constexpr double edge_factor = 2.2;
  /// With fewer vertices left for each of many components, none is refined: these would not sample a body.
  static constexpr double min_size = 24;
  /// Inserted vertices are at most this many times those of the input, and these more.
  static constexpr std::size_t maximum_growth = 3;
  static constexpr std::size_t free_vertices = 20000;

  /// Area below which a component counts as having none; relative to the square of the extent of the surface.
  static constexpr double min_area = 1e-14;

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }
  double squared_distance(Index a, Index b) const
  {
    return (m_triangles.points[a] - m_triangles.points[b]).squaredNorm();
  }
  bool is_long(Index h) const
  {
    return squared_distance(origin(h), target(h)) > m_squared_bound[m_components.component[h / 3]];
  }

  void set_bounds(const std::vector<std::size_t>& genus)
  {
    for (std::size_t i = 0; i < genus.size(); ++i) {
      const double size = std::min(std::max(size_of_sampled_body, target_size_of_handle * double(genus[i])),
                                   double(m_budget) / double(m_components.number()));
      // A component without area cannot be sampled: its edges count as short.
      const double area = m_components.measures[i].area;
      m_squared_bound.push_back(area > min_area && size >= min_size ? area * edge_factor * edge_factor / size
                                                                    : std::numeric_limits<double>::max());
    }
  }

  /// Whether any edge of the surface as it was given is long; asks the lengths that are known. Midpoints shorten edges.
  bool has_long_edge() const
  {
    for (Index i = 0; i < m_components.number(); ++i) {
      if (m_components.measures[i].max_squared_length > m_squared_bound[i]) {
        return true;
      }
    }
    return false;
  }

  std::size_t count_long_edges() const
  {
    std::size_t result = 0;
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      result += h < m_pairing.twin(h) && is_long(h);
    }
    return result;
  }

  /// Appends the midpoints of all long edges; false if there are none.
  bool insert_midpoints()
  {
    std::size_t number = count_long_edges();
    while (number > m_budget) {
      for (double& bound : m_squared_bound) {
        bound *= 2;
      }
      number = count_long_edges();
    }
    if (number == 0) {
      return false;
    }
    m_budget -= number;
    m_midpoint.assign(m_pairing.number_of_halfedges(), no_index);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      if (h < m_pairing.twin(h) && is_long(h)) {
        m_midpoint[h] = m_midpoint[m_pairing.twin(h)] = Index(m_triangles.points.size());
        m_triangles.points.push_back((m_triangles.points[origin(h)] + m_triangles.points[target(h)]) / 2);
      }
    }
    return true;
  }

  void split_faces()
  {
    const std::vector<std::array<Index, 3>> old_faces = std::move(m_triangles.faces);
    const std::vector<Index> old_component = std::move(m_components.component);
    const std::size_t first_hole_filling_face = m_triangles.first_hole_filling_face;
    m_triangles.faces.clear();
    m_components.component.clear();
    for (std::size_t f = 0; f < old_faces.size(); ++f) {
      if (f == first_hole_filling_face) {
        m_triangles.first_hole_filling_face = m_triangles.faces.size();
      }
      split_face(old_faces[f], {m_midpoint[3 * f], m_midpoint[3 * f + 1], m_midpoint[3 * f + 2]});
      m_components.component.resize(m_triangles.faces.size(), old_component[f]);
    }
    if (first_hole_filling_face == old_faces.size()) {
      m_triangles.first_hole_filling_face = m_triangles.faces.size();
    }
  }

  /// Splits a face into one more triangle than it has midpoints; `middle[i]` follows `corner[i]`.
  void split_face(std::array<Index, 3> corner, std::array<Index, 3> middle)
  {
    std::vector<std::array<Index, 3>>& faces = m_triangles.faces;
    const auto number = 3 - std::count(middle.begin(), middle.end(), no_index);
    // Turned so that the side without midpoint is the last one, and the single midpoint is on the first.
    while (number != 0 && number != 3 && (middle[2] != no_index || middle[0] == no_index)) {
      std::rotate(corner.begin(), corner.begin() + 1, corner.end());
      std::rotate(middle.begin(), middle.begin() + 1, middle.end());
    }
    const auto [a, b, c] = corner;
    const auto [ab, bc, ca] = middle;
    if (number == 0) {
      faces.push_back(corner);
    } else if (number == 1) {
      faces.insert(faces.end(), {{a, ab, c}, {ab, b, c}});
    } else if (number == 2) {
      faces.push_back({ab, b, bc});
      if (squared_distance(a, bc) < squared_distance(ab, c)) {
        faces.insert(faces.end(), {{a, ab, bc}, {a, bc, c}});
      } else {
        faces.insert(faces.end(), {{a, ab, c}, {ab, bc, c}});
      }
    } else {
      faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }

  Indexed_triangles& m_triangles;
  Halfedge_pairing& m_pairing;
  Surface_components& m_components;
  std::size_t m_budget;                // vertices that may still be inserted
  std::vector<double> m_squared_bound; // of the length of an edge, per component
  std::vector<Index> m_midpoint;       // of every halfedge's edge
};

/// Splits edges of `triangles` that are long relative to the area of their component, so that about 2000 vertices, and
/// 32 for each handle, or more sample it; a surface that is sampled so already stays as it is. The shape does not
/// change. Inserted vertices are appended; hole-filling faces stay bridging. Vertices grow at most to 4 n + 6 g + 20000
/// for genus g, faces accordingly. O(n) for each round of halving. \return the number of inserted vertices
/// \pre `triangles` is closed and no two faces have the same corners; `pairing` and `components` are those of its faces,
///      and are kept so
inline std::size_t refine_large_faces(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                      Surface_components& components)
{
  return Face_refinement(triangles, pairing, components).refine();
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_REFINE_LARGE_FACES_H
