// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes the surfaces of cavities out: what is hollow has the skeleton of the body around.

#ifndef CSCD_SURFACE_FILL_CAVITIES_H
#define CSCD_SURFACE_FILL_CAVITIES_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The components of a surface that bound cavities: they face inwards, and lie within those that face outwards.
class Cavity_search
{
public:
  /// Both are referred to.
  Cavity_search(const Indexed_triangles& triangles, const Surface_components& components)
      : m_triangles(triangles), m_components(components), m_is_cavity(components.number(), 0)
  {
  }

  /// Whether each component is such a cavity, without a body in it. O(n log n) where any component faces inwards.
  /// \param side of every vertex, not 0 on a sheet, which bounds no cavity; empty without sheets
  std::vector<char> operator()(const std::vector<signed char>& side = {})
  {
    if (m_components.number() == 1) {
      return m_is_cavity;
    }
    for (Index c = 0; c < m_components.number(); ++c) {
      m_is_cavity[c] = m_components.measures[c].faces_inwards() ? 1 : 0;
    }
    for (std::size_t face = 0; face < m_triangles.faces.size() && !side.empty(); ++face) {
      if (side[m_triangles.faces[face][0]] != 0) {
        m_is_cavity[m_components.component[face]] = 0;
      }
    }
    if (std::count(m_is_cavity.begin(), m_is_cavity.end(), 1) > 0) {
      keep_within_bodies();
      drop_around_bodies();
    }
    return m_is_cavity;
  }

private:
  /// Of a component, this many faces are asked whether they are within bodies, ...
  static constexpr std::size_t max_samples = 1024;
  /// ... and of their area this part has to be: a body moved inwards along its normals comes out of thin limbs.
  static constexpr double min_area_within = 0.8;

  /// The components that are, or are not, candidates, as a surface of their own.
  Triangulated_surface surface_of(bool are_candidates) const
  {
    Indexed_triangles part = m_triangles;
    remove_components(part, m_components, [&](Index c) { return (m_is_cavity[c] != 0) != are_candidates; });
    return Triangulated_surface(std::move(part), 1U);
  }

  void keep_within_bodies()
  {
    const Triangulated_surface bodies = surface_of(false);
    if (bodies.number_of_faces() == 0) {
      std::fill(m_is_cavity.begin(), m_is_cavity.end(), 0);
      return;
    }
    const Solid_queries queries(bodies);
    std::vector<std::size_t> number_of_visits(m_components.number(), 0);
    std::vector<double> excess(m_components.number(), 0); // outside of bodies, less what is allowed
    for (std::size_t face = 0; face < m_triangles.faces.size(); ++face) {
      const Index c = m_components.component[face];
      const std::size_t stride = m_components.measures[c].number_of_faces / max_samples + 1;
      if (m_is_cavity[c] != 0 && number_of_visits[c]++ % stride == 0) {
        const auto& [i, j, k] = m_triangles.faces[face];
        const Vector_3& corner = m_triangles.points[i];
        const double area = triangle_area(corner, m_triangles.points[j], m_triangles.points[k]);
        excess[c] += (queries.is_inside(corner) ? 0 : area) - (1 - min_area_within) * area;
      }
    }
    for (Index c = 0; c < m_components.number(); ++c) {
      m_is_cavity[c] = m_is_cavity[c] != 0 && excess[c] <= 0 ? 1 : 0;
    }
  }

  /// A body in a cavity has a skeleton of its own, and needs the void around it.
  void drop_around_bodies()
  {
    const Triangulated_surface cavities = surface_of(true);
    if (cavities.number_of_faces() == 0) {
      return;
    }
    std::vector<Index> component; // of each face of the cavities
    std::copy_if(m_components.component.begin(), m_components.component.end(), std::back_inserter(component),
                 [this](Index c) { return m_is_cavity[c] != 0; });
    const Solid_queries queries(cavities);
    std::vector<char> is_visited(m_is_cavity);
    for (std::size_t face = 0; face < m_triangles.faces.size(); ++face) {
      const Index body = m_components.component[face];
      if (std::exchange(is_visited[body], 1) == 0) {
        const Vector_3& point = m_triangles.points[m_triangles.faces[face][0]];
        const auto hit = queries.is_inside(point) ? queries.first_hit(point, Vector_3::UnitX()) : std::nullopt;
        if (hit && m_components.measures[body].volume < -m_components.measures[component[hit->face]].volume) {
          m_is_cavity[component[hit->face]] = 0;
        }
      }
    }
  }

  const Indexed_triangles& m_triangles;
  const Surface_components& m_components;
  std::vector<char> m_is_cavity;
};

/// What was taken out of a surface.
struct Filled_cavities
{
  std::size_t number = 0;
  std::vector<Index> old_number; ///< of every point that remains; empty where there was no cavity
  std::vector<Index> vertices;   ///< the points of the input that were taken out, by their old numbers,
  std::vector<Vector_3> places;  ///< and where they are
};

/// Takes the surfaces of cavities, such as those of a hollowed statue, out of `triangles`.
/// \param number_of_input_points the points from this one on are not of the input
/// \param side of every vertex, not 0 on a sheet; empty without sheets
/// \pre `pairing` and `components` are those of `triangles`, and are kept so
inline Filled_cavities fill_cavities(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                     Surface_components& components, std::size_t number_of_input_points,
                                     const std::vector<signed char>& side = {})
{
  const std::vector<char> is_cavity = Cavity_search(triangles, components)(side);
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
  components = Surface_components(triangles);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_FILL_CAVITIES_H
