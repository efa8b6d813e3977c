// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to triangles between them: CGAL's advancing front, kept from growing sheets across gaps.

#ifndef CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
#define CSCD_RECONSTRUCTION_ADVANCE_FRONT_H

#include <CSCD/internal/Vector_3.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// The priority of a triangle in the front: that of CGAL, the radius of its smallest empty sphere, but triangles with
/// an edge that is too long for the spacing of the points at its ends are never taken.
class Front_priority
{
public:
  /// \param longest_edge the longest edge allowed at each point
  explicit Front_priority(const std::vector<double>& longest_edge) : m_longest_edge(&longest_edge) {}

  template <class AdvancingFront, class CellHandle>
  double operator()(const AdvancingFront& front, CellHandle& cell, const int& index) const
  {
    for (int i = 1; i <= 3; ++i) {
      const auto a = cell->vertex((index + i) & 3);
      const auto b = cell->vertex((index + i % 3 + 1) & 3);
      if (front.triangulation_3().is_infinite(a) || front.triangulation_3().is_infinite(b)) {
        continue;
      }
      const auto n = m_longest_edge->size();
      if (a->info() >= n || b->info() >= n) {
        continue; // CGAL's own point beside a plane
      }
      const double limit = std::max((*m_longest_edge)[a->info()], (*m_longest_edge)[b->info()]);
      if (CGAL::squared_distance(a->point(), b->point()) > limit * limit) {
        return front.infinity();
      }
    }
    return front.smallest_radius_delaunay_sphere(cell, index);
  }

private:
  const std::vector<double>* m_longest_edge;
};

/// Triangulates a surface through `points`, some of which may be left out; O(n log n) for points on a surface.
/// \param longest_edge at each point, the longest edge that a triangle may have there
/// \return triangles with consistent orientation in each component, each edge of which has at most two
inline std::vector<std::array<Index, 3>> advance_front(const std::vector<Vector_3>& points,
                                                       const std::vector<double>& longest_edge)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> cgal_points;
  cgal_points.reserve(points.size());
  for (const Vector_3& point : points) {
    cgal_points.emplace_back(point.x(), point.y(), point.z());
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(cgal_points.begin(), cgal_points.end(), std::back_inserter(triangles),
                                               Front_priority(longest_edge));
  std::vector<std::array<Index, 3>> result;
  result.reserve(triangles.size());
  for (const std::array<std::size_t, 3>& t : triangles) {
    result.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
