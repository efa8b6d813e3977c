// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to triangles between them: CGAL's advancing front, kept from growing sheets across gaps.

#ifndef CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
#define CSCD_RECONSTRUCTION_ADVANCE_FRONT_H

#include <CSCD/Reconstruction/Front_triangulation.h>
#include <CSCD/Reconstruction/Front_vertex_base.h>
#include <CSCD/Reconstruction/orient_coherently.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>

#include <array>
#include <vector>

namespace CSCD::internal {

/// The priority of a triangle in the front: that of CGAL, the radius of its smallest empty sphere. Triangles with an
/// edge that is too long, or across the normals at its corners, are never taken.
struct Front_priority
{
  template <class AdvancingFront, class CellHandle>
  double operator()(const AdvancingFront& front, CellHandle& cell, const int& index) const
  {
    return front.triangulation_3().is_allowed(cell, index) ? front.smallest_radius_delaunay_sphere(cell, index)
                                                           : front.infinity();
  }
};

/// Triangulates a surface through `points`, some of which may be left out; O(n log n) for points on a surface.
/// \param limits what triangles must respect at each point
/// \return triangles with consistent orientation in each component, each edge of which has at most two
inline std::vector<std::array<Index, 3>> advance_front(const std::vector<Vector_3>& points,
                                                       const std::vector<Front_limit>& limits)
{
  Front_triangulation triangulation(points, limits);
  Front_edge_numbers::clear();
  CGAL::Advancing_front_surface_reconstruction<Front_triangulation, Front_priority> front(triangulation);
  front.run();
  Front_edge_numbers::clear();
  // CGAL also makes a surface of these triangles, but in an order, and at pinched vertices with an orientation, that
  // differ from call to call.
  std::vector<std::array<Index, 3>> result;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell) {
    for (int facet = 0; facet < 4; ++facet) {
      if (front.has_on_surface({cell, facet})) {
        const auto corner = [&](int i) { return Index(cell->vertex((facet + i) & 3)->id()); };
        result.push_back({corner(1), corner(2), corner(3)});
      }
    }
  }
  orient_coherently(result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
