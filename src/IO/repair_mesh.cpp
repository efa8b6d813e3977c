// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes manifold triangle meshes of the polygons of a file.

// `triangulate_hole_polyline()` compiles this triangulation even where it does not use it: a tenth of the time of this
// part, for nothing.
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2

#include "IO/merge_equal_points.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// Calls `function(faces, edge)` for each edge of triangles with the faces at it, an array that is reused, and with its
/// two vertices. O(n log n).
template <class Function>
void for_each_edge(const std::vector<std::array<Index, 3>>& faces, const Function& function)
{
  std::vector<std::array<Index, 3>> sides; // the two vertices, the smaller one first, and the face
  sides.reserve(3 * faces.size());
  for (Index face = 0; face < faces.size(); ++face) {
    const auto [a, b, c] = faces[face];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      sides.push_back({std::min(from, to), std::max(from, to), face});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Index> faces_of_edge;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    faces_of_edge.push_back(sides[i][2]);
    if (i + 1 == sides.size() || sides[i + 1][0] != sides[i][0] || sides[i + 1][1] != sides[i][1]) {
      function(std::as_const(faces_of_edge), std::array<Index, 2>{sides[i][0], sides[i][1]});
      faces_of_edge.clear();
    }
  }
}

/// Whether a triangle names a vertex twice.
bool is_degenerate(const std::array<Index, 3>& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Removes the faces of flaps: parts of the surface, joined by edges of two faces, that meet a part of a hundred times
/// their area at an edge of three faces or more. Without them, that edge joins the two faces of the larger part, which
/// would be slit there. Points stay. O(n log n). \return the number of faces that were removed
/// \pre no face names a vertex twice, and no two faces have the same vertices
std::size_t remove_flaps(Indexed_triangles& soup)
{
  constexpr double max_area = 0.01; // relative to that of the larger part
  const std::size_t number_of_faces = soup.faces.size();
  Disjoint_sets sets(number_of_faces);
  for_each_edge(soup.faces, [&](const std::vector<Index>& faces, const auto& /* edge */) {
    if (faces.size() == 2) {
      sets.join(faces[0], faces[1]);
    }
  });
  Index number_of_parts = 0;
  const std::vector<Index> part = sets.numbers(number_of_parts);
  const std::vector<double> face_area = face_areas(soup);
  std::vector<double> area(number_of_parts, 0.);
  for (Index face = 0; face < number_of_faces; ++face) {
    area[part[face]] += face_area[face];
  }
  std::vector<char> is_flap(number_of_parts, 0);
  for_each_edge(soup.faces, [&](const std::vector<Index>& faces, const auto& /* edge */) {
    if (faces.size() > 2) {
      double largest = 0;
      for (const Index face : faces) {
        largest = std::max(largest, area[part[face]]);
      }
      for (const Index face : faces) {
        is_flap[part[face]] = is_flap[part[face]] != 0 || area[part[face]] < max_area * largest ? 1 : 0;
      }
    }
  });
  std::size_t kept = 0;
  for (std::size_t face = 0; face < number_of_faces; ++face) {
    if (is_flap[part[face]] == 0) {
      soup.faces[kept++] = soup.faces[face];
    }
  }
  soup.faces.resize(kept);
  return number_of_faces - kept;
}

/// A polygon of a file.
struct Polygon
{
  const std::vector<Vector3>& points; ///< of the file
  const Index* corners;
  std::size_t size;

  const Vector3& operator[](std::size_t corner) const { return points[corners[corner]]; }
};

/// Whether the first corner sees the whole polygon, as all corners of a convex one do.
bool is_fan_unfolded(const Polygon& polygon)
{
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size; ++i) {
    normal += triangle_vector(polygon[0], polygon[i], polygon[i + 1]);
  }
  for (std::size_t i = 1; i + 1 < polygon.size; ++i) {
    if (!(triangle_vector(polygon[0], polygon[i], polygon[i + 1]).dot(normal) > 0)) {
      return false;
    }
  }
  return true;
}

/// Cuts a polygon into triangles as CGAL fills a hole. \return whether they were appended
bool triangulate_by_cgal(const Polygon& polygon, std::vector<std::array<Index, 3>>& triangles)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  constexpr std::size_t max_size = 500; // CGAL takes up to cubic time where a hole is not planar
  if (polygon.size > max_size) {
    return false;
  }
  std::vector<Kernel::Point_3> points;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    points.push_back(make_point<Kernel::Point_3>(polygon[i]));
  }
  std::vector<CGAL::Triple<int, int, int>> pieces;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(pieces));
  if (pieces.size() != polygon.size - 2) {
    return false;
  }
  for (const auto& t : pieces) {
    // The orientation is the order of the corners in the polygon.
    std::array<int, 3> order{t.first, t.second, t.third};
    std::sort(order.begin(), order.end());
    triangles.push_back({polygon.corners[order[0]], polygon.corners[order[1]], polygon.corners[order[2]]});
  }
  return true;
}

/// Cuts a polygon into triangles, as a fan where that does not fold or nothing else is possible, and appends them.
void triangulate(const Polygon& polygon, std::vector<std::array<Index, 3>>& triangles)
{
  const bool is_cut = polygon.size > 3 && !is_fan_unfolded(polygon) && triangulate_by_cgal(polygon, triangles);
  for (std::size_t i = 1; i + 1 < polygon.size && !is_cut; ++i) { // of fewer than three corners: nothing
    triangles.push_back({polygon.corners[0], polygon.corners[i], polygon.corners[i + 1]});
  }
}

/// Cuts all polygons into triangles, whose order is that of the polygons: two fewer than each has corners, and none of
/// those of fewer than three. The points stay.
Indexed_triangles triangulate_polygon_soup(Shape_file&& polygons)
{
  Shape_file soup = std::move(polygons); // its memory is free when the triangles are there
  Indexed_triangles result;
  result.faces.reserve(soup.corners.size() - std::min(2 * soup.number_of_polygons(), soup.corners.size()));
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    const Index* const corners = soup.corners.data() + soup.first_corner[polygon];
    triangulate({soup.points, corners, soup.size_of_polygon(polygon)}, result.faces);
  }
  result.points = std::move(soup.points);
  result.first_hole_filling_face = result.faces.size();
  return result;
}

/// Pairs the halfedges of `triangles` if these form an oriented manifold, with or without borders. Linear.
std::optional<Halfedge_pairing> pair_manifold(const Indexed_triangles& triangles, unsigned number_of_threads = 1)
{
  if (triangles.faces.empty() || std::any_of(triangles.faces.begin(), triangles.faces.end(), is_degenerate)) {
    return std::nullopt;
  }
  Halfedge_pairing pairing(triangles.faces, triangles.points.size(), number_of_threads);
  if (pairing.conflict() != no_index || pairing.pinched_vertex() != no_index) {
    return std::nullopt;
  }
  return pairing;
}

/// The only part of a kernel that CGAL's functions for soups use.
struct Soup_traits
{
  static constexpr auto less_xyz_3_object() { return is_lexicographically_less; }
};

/// Merges points of equal coordinates. \return for each old point, its new index
std::vector<Index> merge_points(Indexed_triangles& soup, Mesh_repair_report& report)
{
  std::vector<Index> new_index;
  report.number_of_merged_points += merge_equal_points(soup.points, new_index);
  for (std::array<Index, 3>& triangle : soup.faces) {
    for (Index& corner : triangle) {
      corner = new_index[corner];
    }
  }
  return new_index;
}

/// Makes coordinates equal that differ by `tolerance` at most, axis by axis: each becomes the least of its like.
void round_coordinates(std::vector<Vector3>& points, double tolerance)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  for (Index axis = 0; axis < 3; ++axis) {
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return points[a][axis] < points[b][axis]; });
    double least = -std::numeric_limits<double>::infinity();
    for (const Index point : order) {
      double& coordinate = points[point][axis];
      least = coordinate - least <= tolerance ? least : coordinate;
      coordinate = least;
    }
  }
}

/// Moves points at edges of a single face to the first one that only rounding to single precision parts from them:
/// writers of STL may compute a point anew for each triangle, which leaves gaps. \return whether any moved
/// \param pairing of the halfedges, which makes it faster, or nothing
bool close_rounding_gaps(Indexed_triangles& soup, const std::optional<Halfedge_pairing>& pairing)
{
  constexpr double rounding = 0x1p-22; // twice that of single precision, relative to the longest side of the mesh
  std::vector<Index> vertices;
  std::vector<Vector3> places;
  const auto add = [&](Index vertex) {
    vertices.push_back(vertex);
    places.push_back(soup.points[vertex]);
  };
  for (Index h = 0; pairing && h < pairing->number_of_halfedges(); ++h) {
    if (pairing->twin(h) == no_index) {
      add(soup.origin(h));
    }
  }
  if (!pairing) {
    for_each_edge(soup.faces, [&](const std::vector<Index>& faces, const std::array<Index, 2>& edge) {
      if (faces.size() == 1) {
        std::for_each(edge.begin(), edge.end(), add);
      }
    });
  }
  const Bounding_box box(soup.points);
  round_coordinates(places, (rounding * box.max() - rounding * box.min()).maxCoeff()); // the side itself may overflow
  std::vector<Index> place;
  merge_equal_points(places, place);
  bool has_moved = false;
  std::vector<Index> first_vertex; // at each place
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (place[i] == first_vertex.size()) {
      first_vertex.push_back(vertices[i]);
    }
    const Vector3 point = soup.points[first_vertex[place[i]]];
    has_moved = has_moved || soup.points[vertices[i]] != point;
    soup.points[vertices[i]] = point;
  }
  return has_moved;
}

/// Removes triangles that name a vertex twice, all but one of those of the same vertices, flaps, and points without
/// triangle.
void remove_useless_elements(Indexed_triangles& soup, Mesh_repair_report& report)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const std::size_t number_of_faces = soup.faces.size();
  soup.faces.erase(std::remove_if(soup.faces.begin(), soup.faces.end(), is_degenerate), soup.faces.end());
  PMP::merge_duplicate_polygons_in_polygon_soup(soup.points, soup.faces, CGAL::parameters::geom_traits(Soup_traits()));
  report.number_of_removed_faces += number_of_faces - soup.faces.size();
  report.number_of_removed_flap_faces += remove_flaps(soup);
  report.number_of_removed_points += PMP::remove_isolated_points_in_polygon_soup(soup.points, soup.faces);
}

/// Turns triangles so that neighbors agree, and duplicates points where the surface is not a manifold.
void orient(Indexed_triangles& soup, Mesh_repair_report& report)
{
  const std::size_t number_of_points = soup.points.size();
  const std::vector<std::array<Index, 3>> old_faces = soup.faces;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.faces);
  report.number_of_duplicated_points += soup.points.size() - number_of_points;
  for (std::size_t i = 0; i < old_faces.size(); ++i) {
    // a turned triangle has its corners in reverse order; a corner of another index is a duplicated point
    const bool is_turned = soup.points[soup.faces[i][0]] != soup.points[old_faces[i][0]] ||
                           soup.points[soup.faces[i][1]] != soup.points[old_faces[i][1]];
    report.number_of_turned_faces += is_turned ? 1 : 0;
  }
}

/// Makes the triangles an oriented manifold, with or without borders: merges points of equal coordinates; if borders
/// are left, closes gaps of rounding; if that is not enough, removes useless faces and points and flaps, turns faces,
/// and duplicates points where the surface is not a manifold. \return the pairing of the halfedges, or nothing if it
/// failed
std::optional<Halfedge_pairing> repair_triangle_soup(Manifold_triangles& mesh)
{
  Indexed_triangles& soup = mesh.triangles;
  const std::vector<Index> vertex_of_point = merge_points(soup, mesh.report);
  std::optional<Halfedge_pairing> pairing = pair_manifold(soup);
  if ((!pairing || pairing->has_border()) && close_rounding_gaps(soup, pairing)) {
    for (const Index vertex : vertex_of_point) {
      mesh.places_in_file.push_back(soup.points[vertex]);
    }
    merge_points(soup, mesh.report);
    pairing = pair_manifold(soup);
  }
  if (!pairing) {
    remove_useless_elements(soup, mesh.report);
    orient(soup, mesh.report);
    soup.first_hole_filling_face = soup.faces.size();
    pairing = pair_manifold(soup);
  }
  return pairing;
}

} // namespace

Manifold_triangles make_manifold(Shape_file&& polygons, const std::string& filename, unsigned number_of_threads)
{
  Manifold_triangles result;
  result.report.number_of_triangulated_polygons =
      polygons.number_of_polygons([](std::size_t size) { return size > 3; });
  result.report.number_of_removed_faces = polygons.number_of_polygons([](std::size_t size) { return size < 3; });
  result.triangles = triangulate_polygon_soup(std::move(polygons));
  if (result.triangles.faces.size() > maximum_number_of_faces) {
    throw Input_error(filename + ": the mesh has more than 2^26 triangles; simplify it first");
  }
  std::optional<Halfedge_pairing> pairing = pair_manifold(result.triangles, number_of_threads);
  if (!pairing || pairing->has_border()) {
    pairing = repair_triangle_soup(result);
  }
  if (!pairing) {
    throw Input_error(filename + ": the faces do not form a surface and could not be repaired; repair the mesh with a "
                                 "modelling program");
  }
  if (!pairing->has_border()) {
    Surface_components components(result.triangles);
    result.report.number_of_turned_components =
        orient_outwards(result.triangles, components, Cavity_search(result.triangles, components)());
  }
  return result;
}

std::vector<Index> faces_of_polygons(const Shape_file& file, const std::vector<Vector3>& points,
                                     const std::vector<std::array<Index, 3>>& faces)
{
  std::vector<Vector3> places = file.points;
  places.insert(places.end(), points.begin(), points.end());
  std::vector<Index> place; // for the points of the file, then for those of the mesh
  merge_equal_points(places, place);
  const auto place_of_vertex = place.begin() + static_cast<std::ptrdiff_t>(file.points.size());
  using Corners = std::array<Index, 3>;
  const auto sorted = [](Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  boost::unordered_map<Corners, Index> face_at;
  std::vector<Index> face_at_place(places.size(), no_index);
  for (Index face = 0; face < faces.size(); ++face) {
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = place_of_vertex[faces[face][i]];
      face_at_place[corners[i]] = std::min(face_at_place[corners[i]], face);
    }
    face_at.emplace(sorted(corners), face);
  }
  std::vector<Index> result(file.number_of_polygons(), no_index);
  const std::vector<Corners> triangles = triangulate_polygon_soup(Shape_file(file)).faces;
  auto triangle = triangles.begin();
  for (std::size_t polygon = 0; polygon < file.number_of_polygons(); ++polygon) {
    Index& largest = result[polygon];
    double largest_area = -1;
    for (std::size_t i = 2; i < file.size_of_polygon(polygon); ++i, ++triangle) {
      const Corners corners = sorted({place[(*triangle)[0]], place[(*triangle)[1]], place[(*triangle)[2]]});
      const double area = triangle_area(places[corners[0]], places[corners[1]], places[corners[2]]);
      if (const auto face = face_at.find(corners); face != face_at.end() && area > largest_area) {
        largest_area = area;
        largest = face->second;
      }
    }
    for (std::size_t c = file.first_corner[polygon]; c < file.first_corner[polygon + 1] && largest == no_index; ++c) {
      largest = face_at_place[place[file.corners[c]]];
    }
  }
  return result;
}

} // namespace CSCD::internal

namespace CSCD {

std::vector<std::string> Mesh_repair_report::sentences() const
{
  std::vector<std::string> result;
  const auto add = [&result](std::size_t count, const char* one, const char* many) {
    if (count > 0) {
      result.push_back(internal::counted(count, one, many));
    }
  };
  add(number_of_triangulated_polygons, "polygon triangulated", "polygons triangulated");
  add(number_of_merged_points, "duplicate point merged", "duplicate points merged");
  add(number_of_removed_faces, "degenerate or duplicate face removed", "degenerate or duplicate faces removed");
  add(number_of_removed_flap_faces, "face that hung on the surface removed", "faces that hung on the surface removed");
  add(number_of_removed_points, "point without faces removed", "points without faces removed");
  add(number_of_turned_faces, "face turned to agree with its neighbors", "faces turned to agree with their neighbors");
  add(number_of_duplicated_points, "point duplicated where the surface is not a manifold",
      "points duplicated where the surface is not a manifold");
  add(number_of_turned_components, "component turned outwards", "components turned outwards");
  return result;
}

} // namespace CSCD
