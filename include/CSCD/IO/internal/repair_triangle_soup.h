// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mending triangles that do not form an oriented manifold.

#ifndef CSCD_IO_INTERNAL_REPAIR_TRIANGLE_SOUP_H
#define CSCD_IO_INTERNAL_REPAIR_TRIANGLE_SOUP_H

#include <CSCD/IO/Mesh_repair_report.h>
#include <CSCD/IO/internal/merge_equal_points.h>
#include <CSCD/IO/internal/pair_manifold.h>
#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// Triangles as CGAL's functions for soups want them.
struct Cgal_soup
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Polygon = std::vector<std::size_t>;

  explicit Cgal_soup(const Indexed_triangles& soup)
  {
    points.reserve(soup.points.size());
    for (const Vector_3& p : soup.points) {
      points.emplace_back(p.x(), p.y(), p.z());
    }
    polygons.reserve(soup.faces.size());
    for (const std::array<Index, 3>& t : soup.faces) {
      polygons.push_back({t[0], t[1], t[2]});
    }
  }

  Indexed_triangles triangles() const
  {
    Indexed_triangles result;
    result.points.reserve(points.size());
    for (const Point& p : points) {
      result.points.emplace_back(p.x(), p.y(), p.z());
    }
    result.faces.reserve(polygons.size());
    for (const Polygon& t : polygons) {
      result.faces.push_back({static_cast<Index>(t[0]), static_cast<Index>(t[1]), static_cast<Index>(t[2])});
    }
    result.first_bridging_face = result.faces.size();
    return result;
  }

  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

/// Merges points of equal coordinates. \return their number
inline std::size_t merge_equal_points(Indexed_triangles& soup)
{
  std::vector<Index> new_index;
  const std::size_t number_of_merged_points = merge_equal_points(soup.points, new_index);
  for (std::array<Index, 3>& triangle : soup.faces) {
    for (Index& corner : triangle) {
      corner = new_index[corner];
    }
  }
  return number_of_merged_points;
}

/// Removes triangles that name a vertex twice, all but one of those of the same vertices, and points without triangle.
inline void remove_useless_elements(Cgal_soup& soup, Mesh_repair_report& report)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto is_degenerate = [](const Cgal_soup::Polygon& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  const std::size_t number_of_polygons = soup.polygons.size();
  soup.polygons.erase(std::remove_if(soup.polygons.begin(), soup.polygons.end(), is_degenerate), soup.polygons.end());
  PMP::merge_duplicate_polygons_in_polygon_soup(soup.points, soup.polygons);
  report.number_of_removed_faces += number_of_polygons - soup.polygons.size();
  report.number_of_removed_points += PMP::remove_isolated_points_in_polygon_soup(soup.points, soup.polygons);
}

/// Turns triangles so that neighbours agree, and duplicates points where the surface is no manifold.
inline void orient(Cgal_soup& soup, Mesh_repair_report& report)
{
  const std::size_t number_of_points = soup.points.size();
  const std::vector<Cgal_soup::Polygon> old_polygons = soup.polygons;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons);
  report.number_of_duplicated_points += soup.points.size() - number_of_points;
  for (std::size_t i = 0; i < old_polygons.size(); ++i) {
    // a turned triangle has its corners in reverse order; a corner of another index is a duplicated point
    const bool is_turned = soup.points[soup.polygons[i][0]] != soup.points[old_polygons[i][0]] ||
                           soup.points[soup.polygons[i][1]] != soup.points[old_polygons[i][1]];
    report.number_of_turned_faces += is_turned ? 1 : 0;
  }
}

/// Makes the triangles an oriented manifold, with or without borders: merges points of equal coordinates; if that is
/// not enough, removes useless faces and points, turns faces, and duplicates points where the surface is no manifold.
/// \return the pairing of the halfedges, or nothing if it failed
inline std::optional<Halfedge_pairing> repair_triangle_soup(Indexed_triangles& soup, Mesh_repair_report& report)
{
  report.number_of_merged_points += merge_equal_points(soup);
  std::optional<Halfedge_pairing> pairing = pair_manifold(soup);
  if (!pairing) {
    Cgal_soup cgal_soup(soup);
    remove_useless_elements(cgal_soup, report);
    orient(cgal_soup, report);
    soup = cgal_soup.triangles();
    pairing = pair_manifold(soup);
  }
  return pairing;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_REPAIR_TRIANGLE_SOUP_H
