// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a mesh of any type into plain arrays, and refuses one that is not a manifold.

#ifndef CSCD_TRAITS_READ_MESH_H
#define CSCD_TRAITS_READ_MESH_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

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

/// The points and triangles of a mesh as arrays, in the iteration order of the mesh.
template <class VertexDescriptor>
struct Mesh_arrays
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> faces;
  std::vector<VertexDescriptor> descriptors; ///< of the points
};

/// Reads the corners of `face`, as the `numbers` of their vertices.
/// \throw Input_error if there are not three different ones; `face_number` names the face
template <class TriangleMesh, class VertexNumbers, class FaceDescriptor>
std::array<Index, 3> read_corners(const TriangleMesh& mesh, const VertexNumbers& numbers, FaceDescriptor face,
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

/// Reads `mesh`. Linear, where vertices are indices as in `CGAL::Surface_mesh`, expectedly linear otherwise.
/// \param mesh a model of `FaceListGraph`
/// \param point_map a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`
/// \throw Input_error naming the face that is not a triangle or uses a vertex twice
template <class TriangleMesh, class VertexPointMap>
Mesh_arrays<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> read_mesh(const TriangleMesh& mesh,
                                                                                     const VertexPointMap& point_map)
{
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  Mesh_arrays<Vertex_descriptor> result;
  auto numbers = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  result.descriptors.reserve(num_vertices(mesh));
  result.points.reserve(num_vertices(mesh));
  for (const Vertex_descriptor vertex : vertices(mesh)) {
    put(numbers, vertex, Index(result.descriptors.size()));
    result.descriptors.push_back(vertex);
    result.points.push_back(to_vector_3(get(point_map, vertex)));
  }
  result.faces.reserve(num_faces(mesh));
  for (const auto face : faces(mesh)) {
    result.faces.push_back(read_corners(mesh, numbers, face, result.faces.size()));
  }
  return result;
}

/// The triangles of a mesh, and where they came from.
template <class VertexDescriptor>
struct Collected_triangles : Checked_triangles
{
  std::vector<VertexDescriptor> descriptors; ///< the vertices of the points
};

/// Reads `mesh` into points and index triples. Vertices and faces keep the iteration order of the mesh; vertices
/// without a face are left out. Linear where vertices are indices as in `CGAL::Surface_mesh`, expectedly linear
/// otherwise.
/// \param mesh a model of `FaceListGraph`
/// \param point_map a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`
/// \throw Input_error as `read_mesh()` and `check_triangles()` do
template <class TriangleMesh, class VertexPointMap>
Collected_triangles<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
collect_triangles(const TriangleMesh& mesh, const VertexPointMap& point_map)
{
  auto arrays = read_mesh(mesh, point_map);
  Checked_triangles checked = check_triangles(std::move(arrays.points), std::move(arrays.faces));
  auto descriptors = reordered(arrays.descriptors, checked.input_number);
  return {std::move(checked), std::move(descriptors)};
}

/// The numbers of the vertices of `mesh` among `descriptors`; `no_index` for a vertex without a face. Linear.
template <class TriangleMesh, class VertexDescriptor>
auto vertex_numbers(const TriangleMesh& mesh, const std::vector<VertexDescriptor>& descriptors)
{
  auto numbers = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  for (const VertexDescriptor vertex : vertices(mesh)) {
    put(numbers, vertex, no_index);
  }
  for (Index i = 0; i < descriptors.size(); ++i) {
    put(numbers, descriptors[i], i);
  }
  return numbers;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_READ_MESH_H
