// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to triangles between them: CGAL's advancing front, kept from growing sheets across gaps.

#ifndef CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
#define CSCD_RECONSTRUCTION_ADVANCE_FRONT_H

#include <CSCD/Reconstruction/Front_vertex_base.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Advancing_front_surface_reconstruction_cell_base_3.h>
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
  /// That a triangle may have at the point; if zero, the point is left out.
  double longest_edge = 0;            ///< that a triangle may have at the point
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
    const double radius = front.smallest_radius_delaunay_sphere(cell, index);
    if (radius == front.infinity()) {
      return radius;
    }
    const auto corner = [&](int i) { return cell->vertex((index + 1 + i % 3) & 3); };
    for (int i = 0; i < 3; ++i) {
      const double at_source = limit(corner(i)).longest_edge;
      const double at_target = limit(corner(i + 1)).longest_edge;
      const double longest = std::min(at_source, at_target) > 0 ? std::max(at_source, at_target) : 0;
      if (CGAL::squared_distance(corner(i)->point(), corner(i + 1)->point()) > longest * longest) {
        return front.infinity();
      }
    }
    if (is_across_normals(corner(0), corner(1), corner(2))) {
      return front.infinity();
    }
    return radius;
  }

private:
  /// The least cosine of the angle between a triangle and the surface at its corners, if that is known.
  static constexpr double least_cosine = 0.1;

  template <class VertexHandle>
  const Front_limit& limit(VertexHandle vertex) const
  {
    return (*m_limits)[vertex->info()];
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

/// More cells than a Delaunay triangulation of points on a surface has for each point.
inline constexpr std::size_t cells_per_point = 10;

/// Triangulates a surface through `points`, some of which may be left out; O(n log n) for points on a surface.
/// \param limits what triangles must respect at each point
/// \return triangles with consistent orientation in each component, each edge of which has at most two
inline std::vector<std::array<Index, 3>> advance_front(const std::vector<Vector_3>& points,
                                                       const std::vector<Front_limit>& limits)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Cell_base = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>;
  using Tds = CGAL::Triangulation_data_structure_3<Front_vertex_base<Kernel>, Cell_base>;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Tds>;

  std::vector<std::pair<Kernel::Point_3, std::size_t>> cgal_points;
  cgal_points.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cgal_points.emplace_back(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()), i);
  }
  // In one block each, vertices and cells have addresses in the order in which they are made: the front compares them.
  Triangulation triangulation;
  triangulation.tds().vertices().reserve(points.size() + 2);
  triangulation.tds().cells().reserve(cells_per_point * points.size() + cells_per_point);
  triangulation.insert(cgal_points.begin(), cgal_points.end());
  Front_edge_numbers::clear();
  CGAL::Advancing_front_surface_reconstruction<Triangulation, Front_priority> front(triangulation,
                                                                                    Front_priority(limits));
  front.run();
  Front_edge_numbers::clear();
  std::vector<std::array<Index, 3>> result;
  if (triangulation.dimension() < 3) {
    return result;
  }
  const auto& surface = front.triangulation_data_structure_2();
  for (auto face = surface.faces_begin(); face != surface.faces_end(); ++face) {
    if (face->is_on_surface()) {
      const auto number = [&face](int i) { return Index(face->vertex(i)->vertex_3()->id()); };
      result.push_back({number(0), number(1), number(2)});
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
