// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Delaunay triangulations of points that are refused before they fill the memory.

#ifndef CSCD_SRC_TREE_INSERT_POINTS_H
#define CSCD_SRC_TREE_INSERT_POINTS_H

#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CSCD::internal {

/// Inserts points into a Delaunay triangulation in space, in the order that CGAL uses for a range; the information of
/// each vertex becomes the number of its point. O(n log n) for points on surfaces or in volumes.
/// \throw Input_error if there would be as many tetrahedra as only points along curves have: two straight lines of n
///        points have n^2
template <class Triangulation>
void insert_points(Triangulation& triangulation, const std::vector<Vector3>& points)
{
  using Point = typename Triangulation::Point;
  // Points on surfaces have about 7 tetrahedra each, in volumes as many; each takes some 100 bytes.
  constexpr std::size_t max_cells_per_point = 32;
  constexpr std::size_t max_cells_of_few_points = 1 << 18; // which take no time and no memory
  const std::size_t max_number_of_cells = max_cells_per_point * points.size() + max_cells_of_few_points;
  std::vector<Point> sites;
  sites.reserve(points.size());
  for (const Vector3& point : points) {
    sites.emplace_back(point.x(), point.y(), point.z());
  }
  std::vector<std::size_t> order(sites.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Geometry = typename Triangulation::Geom_traits;
  using Site_map = typename CGAL::Pointer_property_map<Point>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Geometry, Site_map>(CGAL::make_property_map(sites),
                                                                             triangulation.geom_traits()));
  typename Triangulation::Vertex_handle last;
  for (const std::size_t i : order) {
    last = triangulation.insert(sites[i], last);
    last->info() = static_cast<std::decay_t<decltype(last->info())>>(i);
    if (triangulation.tds().number_of_cells() > max_number_of_cells) {
      throw Input_error("the points lie along curves, not on a surface: their triangulation would fill the memory; "
                        "join the points by edges and skeletonize these as a graph, or thin the points along the "
                        "curves");
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_INSERT_POINTS_H
