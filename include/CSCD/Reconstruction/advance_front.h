// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to triangles between them: CGAL's advancing front, kept from growing sheets across gaps.

#ifndef CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
#define CSCD_RECONSTRUCTION_ADVANCE_FRONT_H

#include <CSCD/Reconstruction/Front_cell_base.h>
#include <CSCD/Reconstruction/Front_vertex_base.h>
#include <CSCD/Reconstruction/orient_coherently.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>

#include <algorithm>
#include <array>
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

/// The priority of a triangle in the front: that of CGAL, the radius of its smallest empty sphere. Triangles with an
/// edge that is too long, or across the normals at its corners, are never taken.
class Front_priority
{
public:
  explicit Front_priority(const std::vector<Front_limit>& limits) : m_limits(&limits) {}

  template <class AdvancingFront, class CellHandle>
  double operator()(const AdvancingFront& front, CellHandle& cell, const int& index) const
  {
    // Most facets of the triangulation lie inside the body and are long: their radii need not be known.
    const auto corner = [&](int i) { return cell->vertex((index + 1 + i % 3) & 3); };
    for (int i = 0; i < 3; ++i) {
      if (is_too_long(corner(i), corner(i + 1))) {
        return front.infinity();
      }
    }
    const double radius = front.smallest_radius_delaunay_sphere(cell, index);
    return radius == front.infinity() || is_across_normals(corner(0), corner(1), corner(2)) ? front.infinity() : radius;
  }

private:
  /// The least cosine of the angle between a triangle and the surface at its corners, if that is known.
  static constexpr double least_cosine = 0.1;

  template <class VertexHandle>
  const Front_limit& limit(VertexHandle vertex) const
  {
    // In a plane, the front adds a point of its own, to have a body.
    static const Front_limit none;
    return vertex->info() < m_limits->size() ? (*m_limits)[vertex->info()] : none;
  }

  template <class VertexHandle>
  bool is_too_long(VertexHandle a, VertexHandle b) const
  {
    const double at_a = limit(a).longest_edge;
    const double at_b = limit(b).longest_edge;
    const double longest = std::min(at_a, at_b) > 0 ? std::max(at_a, at_b) : 0;
    return CGAL::squared_distance(a->point(), b->point()) > longest * longest;
  }

  template <class VertexHandle>
  bool is_across_normals(VertexHandle a, VertexHandle b, VertexHandle c) const
  {
    const auto vector = CGAL::cross_product(b->point() - a->point(), c->point() - a->point());
    const Vector_3 normal = Vector_3(vector.x(), vector.y(), vector.z()).stableNormalized();
    const auto is_across = [&](VertexHandle vertex) {
      const Vector_3& given = limit(vertex).normal;
      return given != Vector_3::Zero() && std::abs(given.dot(normal)) < least_cosine;
    };
    return is_across(a) || is_across(b) || is_across(c);
  }

  const std::vector<Front_limit>* m_limits;
};

/// Triangulates a surface through `points`, some of which may be left out; O(n log n) for points on a surface.
/// \param limits what triangles must respect at each point
/// \return triangles with consistent orientation in each component, each edge of which has at most two
inline std::vector<std::array<Index, 3>> advance_front(const std::vector<Vector_3>& points,
                                                       const std::vector<Front_limit>& limits)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Tds = CGAL::Triangulation_data_structure_3<Front_vertex_base<Kernel>, Front_cell_base<Kernel>>;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Tds>;

  std::vector<std::pair<Kernel::Point_3, std::size_t>> cgal_points;
  cgal_points.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cgal_points.emplace_back(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()), i);
  }
  Triangulation triangulation(cgal_points.begin(), cgal_points.end());
  Front_edge_numbers::clear();
  CGAL::Advancing_front_surface_reconstruction<Triangulation, Front_priority> front(triangulation,
                                                                                    Front_priority(limits));
  front.run();
  Front_edge_numbers::clear();
  // CGAL also makes a surface of these triangles, but in an order, and at pinched vertices with an orientation, that
  // differ from call to call.
  std::vector<std::array<Index, 3>> result;
  for (auto facet = triangulation.finite_facets_begin(); facet != triangulation.finite_facets_end(); ++facet) {
    if (front.has_on_surface(*facet) || front.has_on_surface(triangulation.mirror_facet(*facet))) {
      const auto corner = [&facet](int i) { return Index(facet->first->vertex((facet->second + i) & 3)->id()); };
      result.push_back({corner(1), corner(2), corner(3)});
    }
  }
  orient_coherently(result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
