// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cutting polygons into triangles.

#ifndef CSCD_IO_INTERNAL_TRIANGULATE_POLYGON_SOUP_H
#define CSCD_IO_INTERNAL_TRIANGULATE_POLYGON_SOUP_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Cuts one polygon after the other into triangles.
class Polygon_triangulator
{
public:
  Polygon_triangulator(const Polygon_soup& soup, std::vector<std::array<Index, 3>>& triangles)
      : m_soup(soup), m_triangles(triangles)
  {
  }

  void triangulate(std::size_t polygon)
  {
    m_corners = m_soup.corners.data() + m_soup.first_corner[polygon];
    m_size = m_soup.size_of_polygon(polygon);
    if (m_size == 3) {
      append(0, 1, 2);
    } else if (!triangulate_as_fan() && !triangulate_by_cgal()) {
      append_fan(0);
    }
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  /// Polygons of more corners than this are tried as a fan around their first corner only, as trying takes quadratic
  /// time.
  static constexpr std::size_t max_size_to_try_all_fans = 16;
  /// Polygons of more corners than this are cut as a fan whatever their shape: CGAL's triangulation of a hole takes up
  /// to cubic time where it is not planar.
  static constexpr std::size_t max_size_for_cgal = 500;

  void append(std::size_t i, std::size_t j, std::size_t k)
  {
    m_triangles.push_back({m_corners[i], m_corners[j], m_corners[k]});
  }

  void append_fan(std::size_t apex)
  {
    for (std::size_t i = 1; i + 1 < m_size; ++i) {
      append(apex, (apex + i) % m_size, (apex + i + 1) % m_size);
    }
  }

  /// Looks for a corner from which the polygon is seen whole, as it is from all corners of a convex one.
  bool triangulate_as_fan()
  {
    const Vector_3 normal = twice_area_vector();
    const std::size_t number_of_tries = m_size <= max_size_to_try_all_fans ? m_size : 1;
    for (std::size_t apex = 0; apex < number_of_tries; ++apex) {
      if (is_fan_unfolded(apex, normal)) {
        append_fan(apex);
        return true;
      }
    }
    return false;
  }

  bool is_fan_unfolded(std::size_t apex, const Vector_3& normal) const
  {
    for (std::size_t i = 1; i + 1 < m_size; ++i) {
      const Vector_3 a = point((apex + i) % m_size) - point(apex);
      const Vector_3 b = point((apex + i + 1) % m_size) - point(apex);
      if (!(a.cross(b).dot(normal) > 0)) {
        return false;
      }
    }
    return true;
  }

  Vector_3 twice_area_vector() const
  {
    Vector_3 sum = Vector_3::Zero();
    for (std::size_t i = 1; i + 1 < m_size; ++i) {
      sum += (point(i) - point(0)).cross(point(i + 1) - point(0));
    }
    return sum;
  }

  bool triangulate_by_cgal()
  {
    if (m_size > max_size_for_cgal) {
      return false;
    }
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = 0; i < m_size; ++i) {
      const Vector_3& p = point(i);
      points.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<CGAL::Triple<int, int, int>> triangles;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(triangles));
    if (triangles.size() != m_size - 2) {
      return false;
    }
    for (const auto& t : triangles) {
      append_in_order({std::size_t(t.first), std::size_t(t.second), std::size_t(t.third)});
    }
    return true;
  }

  /// The corners of a triangle in the order in which they stand in the polygon: this is its orientation.
  void append_in_order(std::array<std::size_t, 3> corners)
  {
    std::sort(corners.begin(), corners.end());
    append(corners[0], corners[1], corners[2]);
  }

  const Vector_3& point(std::size_t corner) const { return m_soup.points[m_corners[corner]]; }

  const Polygon_soup& m_soup;
  std::vector<std::array<Index, 3>>& m_triangles;
  const Index* m_corners = nullptr;
  std::size_t m_size = 0;
};

/// Cuts all polygons into triangles, whose order is that of the polygons. The points stay.
inline Indexed_triangles triangulate_polygon_soup(Polygon_soup&& soup)
{
  Indexed_triangles result;
  result.faces.reserve(soup.corners.size() - 2 * soup.number_of_polygons());
  Polygon_triangulator triangulator(soup, result.faces);
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    triangulator.triangulate(polygon);
  }
  result.points = std::move(soup.points);
  result.first_hole_filling_face = result.faces.size();
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_TRIANGULATE_POLYGON_SOUP_H
