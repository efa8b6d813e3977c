// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a manifold of a triangle soup.

#ifndef CSCD_IO_INTERNAL_REPAIR_TRIANGLE_SOUP_H
#define CSCD_IO_INTERNAL_REPAIR_TRIANGLE_SOUP_H

#include <CSCD/IO/Mesh_repair_report.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CSCD::internal {

/// Hashes a point by its coordinates; equal points have equal hashes.
struct Point_hash
{
  std::size_t operator()(const Vector_3& point) const
  {
    std::size_t seed = 0;
    for (double coordinate : point) {
      boost::hash_combine(seed, coordinate + 0.0); // turns -0 into 0, which is equal
    }
    return seed;
  }
};

/// Merges points of exactly equal coordinates into the first of them; the others keep their order. Linear.
/// \param[out] new_index for each old point, its new index
/// \return the number of points that vanished
/// \pre the points are finite
inline std::size_t merge_equal_points(std::vector<Vector_3>& points, std::vector<Index>& new_index)
{
  std::unordered_map<Vector_3, Index, Point_hash> index_of;
  index_of.reserve(points.size());
  new_index.resize(points.size());
  Index size = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [place, is_new] = index_of.emplace(points[i], size);
    new_index[i] = place->second;
    if (is_new) {
      points[size++] = points[i];
    }
  }
  const std::size_t number_of_merged_points = points.size() - size;
  points.resize(size);
  return number_of_merged_points;
}

/// Pairs the halfedges of `triangles` if these form an oriented manifold, with or without borders. Linear.
inline std::optional<Halfedge_pairing> pair_manifold(const Indexed_triangles& triangles)
{
  const auto is_degenerate = [](const std::array<Index, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  if (triangles.faces.empty() || std::any_of(triangles.faces.begin(), triangles.faces.end(), is_degenerate)) {
    return std::nullopt;
  }
  try {
    return check_manifold(triangles, [](Index vertex) { return vertex; });
  } catch (const Input_error&) {
    return std::nullopt;
  }
}

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
    result.first_hole_filling_face = result.faces.size();
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
