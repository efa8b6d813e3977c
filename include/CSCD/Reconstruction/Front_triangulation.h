// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangulation in which a front advances, with the facets that it may take.

#ifndef CSCD_RECONSTRUCTION_FRONT_TRIANGULATION_H
#define CSCD_RECONSTRUCTION_FRONT_TRIANGULATION_H

#include <CSCD/Reconstruction/Front_cell_base.h>
#include <CSCD/Reconstruction/Front_vertex_base.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// What a triangle must respect at a point.
struct Front_limit
{
  double longest_edge = 0;            ///< that a triangle may have at the point; if zero, the point is left out
  Vector_3 normal = Vector_3::Zero(); ///< of unit length and either orientation, or zero if it is not known
};

using Front_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Front_delaunay_triangulation = CGAL::Delaunay_triangulation_3<
    Front_kernel, CGAL::Triangulation_data_structure_3<Front_vertex_base<Front_kernel>, Front_cell_base<Front_kernel>>>;

/// A Delaunay triangulation that shows CGAL's front only those finite facets that may become triangles of the surface.
/// Most facets lie inside the body and are too long; the front looks through all of them for each component.
class Front_triangulation : public Front_delaunay_triangulation
{
public:
  using Finite_facets_iterator = std::vector<Facet>::const_iterator; // hides that of CGAL

  /// \param limits of each of `points`; referred to
  Front_triangulation(const std::vector<Vector_3>& points, const std::vector<Front_limit>& limits)
      : m_limits(&limits), m_has_normals(std::any_of(limits.begin(), limits.end(), [](const Front_limit& limit) {
          return limit.normal != Vector_3::Zero();
        }))
  {
    std::vector<std::pair<Point, std::size_t>> numbered_points;
    numbered_points.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      numbered_points.emplace_back(Point(points[i].x(), points[i].y(), points[i].z()), i);
    }
    insert(numbered_points.begin(), numbered_points.end());
  }

  Finite_facets_iterator finite_facets_begin()
  {
    collect_facets();
    return m_facets.begin();
  }
  Finite_facets_iterator finite_facets_end()
  {
    collect_facets();
    return m_facets.end();
  }

  void remove(Vertex_handle vertex)
  {
    m_is_collected = false;
    Front_delaunay_triangulation::remove(vertex);
  }

  /// Whether the facet `index` of a cell may become a triangle.
  bool is_allowed(Cell_handle cell, int index) const
  {
    const Vertex_handle a = cell->vertex((index + 1) & 3);
    const Vertex_handle b = cell->vertex((index + 2) & 3);
    const Vertex_handle c = cell->vertex((index + 3) & 3);
    return !is_too_long(a, b) && !is_too_long(b, c) && !is_too_long(c, a) &&
           !(m_has_normals && is_across_normals(a, b, c));
  }

private:
  /// The least cosine of the angle between a triangle and the surface at its corners, if that is known.
  static constexpr double least_cosine = 0.1;

  void collect_facets()
  {
    if (m_is_collected) {
      return;
    }
    m_facets.clear();
    for (auto cell = finite_cells_begin(); cell != finite_cells_end(); ++cell) {
      for (int i = 0; i < 4; ++i) {
        const Cell_handle neighbor = cell->neighbor(i);
        if (is_allowed(cell, i) && (is_infinite(neighbor) || Cell_handle(cell) < neighbor)) {
          m_facets.emplace_back(cell, i);
        }
      }
    }
    m_is_collected = true;
  }

  const Front_limit& limit(Vertex_handle vertex) const
  {
    // In a plane, the front adds a point of its own, to have a body.
    static const Front_limit none;
    return vertex->info() < m_limits->size() ? (*m_limits)[vertex->info()] : none;
  }

  bool is_too_long(Vertex_handle a, Vertex_handle b) const
  {
    const double at_a = limit(a).longest_edge;
    const double at_b = limit(b).longest_edge;
    const double longest = std::min(at_a, at_b) > 0 ? std::max(at_a, at_b) : 0;
    return CGAL::squared_distance(a->point(), b->point()) > longest * longest;
  }

  bool is_across_normals(Vertex_handle a, Vertex_handle b, Vertex_handle c) const
  {
    const auto vector = CGAL::cross_product(b->point() - a->point(), c->point() - a->point());
    const Vector_3 normal = Vector_3(vector.x(), vector.y(), vector.z()).stableNormalized();
    const auto is_across = [&](Vertex_handle vertex) {
      const Vector_3& given = limit(vertex).normal;
      return given != Vector_3::Zero() && std::abs(given.dot(normal)) < least_cosine;
    };
    return is_across(a) || is_across(b) || is_across(c);
  }

  const std::vector<Front_limit>* m_limits;
  bool m_has_normals;
  std::vector<Facet> m_facets;
  bool m_is_collected = false;
};

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_FRONT_TRIANGULATION_H
