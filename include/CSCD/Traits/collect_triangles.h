// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the triangles of a mesh of any type into flat arrays, and refuses what is no manifold.

#ifndef CSCD_TRAITS_COLLECT_TRIANGLES_H
#define CSCD_TRAITS_COLLECT_TRIANGLES_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/double.h>
#include <CGAL/float.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The point map that `np` gives, else that of the mesh; a mesh whose map is given need not have one of its own.
template <class TriangleMesh, class NamedParameters>
auto vertex_point_map(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>::value) {
    return get(CGAL::vertex_point, mesh);
  } else {
    return parameters::get_parameter(np, CGAL::internal_np::vertex_point);
  }
}

/// With more faces than this the halfedges of the refined surface could no longer be indexed.
inline constexpr std::size_t maximum_number_of_faces = std::size_t(1) << 26;

/// The triangles of a mesh, and where they came from.
template <class VertexDescriptor>
struct Collected_triangles
{
  Indexed_triangles triangles;
  Halfedge_pairing pairing;
  std::vector<VertexDescriptor> descriptors; ///< the vertices of the points
  std::size_t number_of_isolated_vertices = 0;
};

/// Reads the corners of `face`, as the `numbers` of their vertices.
/// \throw Input_error if there are not three different ones; `face_number` names the face
template <class TriangleMesh, class VertexNumbers, class FaceDescriptor>
std::array<Index, 3> collect_corners(const TriangleMesh& mesh, const VertexNumbers& numbers, FaceDescriptor face,
                                     std::size_t face_number)
{
  std::array<Index, 3> corners{};
  std::size_t number_of_sides = 0;
  const auto first = halfedge(face, mesh);
  auto side = first;
  do {
    if (number_of_sides < 3) {
      corners[number_of_sides] = get(numbers, target(side, mesh));
    }
    ++number_of_sides;
    side = next(side, mesh);
  } while (side != first);
  if (number_of_sides != 3) {
    throw Input_error("face " + std::to_string(face_number) + " has " + std::to_string(number_of_sides) +
                      " sides: triangulate the mesh first, for instance by "
                      "CGAL::Polygon_mesh_processing::triangulate_faces");
  }
  if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
    throw Input_error("face " + std::to_string(face_number) + " uses a vertex twice: remove the face");
  }
  return corners;
}

/// \throw Input_error if `point`, that of vertex `number`, has a coordinate that is not finite
inline void check_finite(const Vector_3& point, Index number)
{
  if (!point.allFinite()) {
    throw Input_error("vertex " + std::to_string(number) +
                      " has a coordinate that is not finite: correct it or remove the vertex");
  }
}

/// Reads `mesh` into points and index triples.
/// Vertices and faces keep the order in which the mesh iterates them; vertices without a face are left out.
/// Linear, where vertices are indices as in `CGAL::Surface_mesh`, expectedly linear otherwise.
/// \param mesh a model of `FaceListGraph`
/// \param point_map a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`
/// \param number_of_threads 0 for as many as TBB allows
/// \throw Input_error naming the element, by its number in the order of iteration, if `mesh` has no faces, a face that
///        is no triangle or uses a vertex twice, an edge with more than two faces or with faces of opposite
///        orientation, a pinched vertex, a coordinate that is not finite, or more faces than can be indexed
template <class TriangleMesh, class VertexPointMap>
Collected_triangles<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
collect_triangles(const TriangleMesh& mesh, const VertexPointMap& point_map, unsigned number_of_threads = 1)
{
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  if (std::size_t(num_faces(mesh)) > maximum_number_of_faces ||
      std::size_t(num_vertices(mesh)) > maximum_number_of_faces) {
    throw Input_error("the mesh has more than 2^26 faces or vertices: simplify it first");
  }
  Collected_triangles<Vertex_descriptor> result;
  auto numbers = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  result.descriptors.reserve(num_vertices(mesh));
  for (const Vertex_descriptor vertex : vertices(mesh)) {
    put(numbers, vertex, Index(result.descriptors.size()));
    result.descriptors.push_back(vertex);
  }
  Indexed_triangles& triangles = result.triangles;
  triangles.faces.reserve(num_faces(mesh));
  for (const auto face : faces(mesh)) {
    triangles.faces.push_back(collect_corners(mesh, numbers, face, triangles.faces.size()));
  }
  if (triangles.faces.empty()) {
    throw Input_error(
        "the mesh has no faces: a skeleton needs a surface; if these are points, use them as a point set");
  }
  triangles.first_hole_filling_face = triangles.faces.size();

  const std::vector<Index> input_number = compact_numbers(triangles.faces, result.descriptors.size());
  result.number_of_isolated_vertices = result.descriptors.size() - input_number.size();
  triangles.points.reserve(input_number.size());
  for (std::size_t i = 0; i < input_number.size(); ++i) {
    result.descriptors[i] = result.descriptors[input_number[i]];
    const auto& point = get(point_map, result.descriptors[i]);
    triangles.points.emplace_back(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
    check_finite(triangles.points.back(), input_number[i]);
  }
  result.descriptors.resize(input_number.size());
  result.pairing = check_manifold(
      triangles, [&input_number](Index vertex) { return input_number[vertex]; }, number_of_threads);
  return result;
}

/// Takes over the triangles of a mesh whose vertices are their points, with the same numbers, as if that mesh were
/// read. \tparam VertexDescriptor constructible from a number
/// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
/// \throw Input_error if a coordinate is not finite
template <class VertexDescriptor>
Collected_triangles<VertexDescriptor> take_triangles(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                                     unsigned number_of_threads = 1)
{
  Collected_triangles<VertexDescriptor> result;
  result.triangles = std::move(triangles);
  result.pairing = std::move(pairing);
  auto& [points, faces, first_hole_filling_face] = result.triangles;
  const std::vector<Index> input_number = compact_numbers(faces, points.size());
  result.number_of_isolated_vertices = points.size() - input_number.size();
  for (std::size_t i = 0; i < input_number.size(); ++i) {
    points[i] = Vector_3(points[input_number[i]]);
    check_finite(points[i], input_number[i]);
  }
  if (result.number_of_isolated_vertices > 0) {
    points.resize(input_number.size());
    result.pairing = Halfedge_pairing(faces, points.size(), number_of_threads);
  }
  result.descriptors = std::vector<VertexDescriptor>(input_number.begin(), input_number.end());
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_COLLECT_TRIANGLES_H
