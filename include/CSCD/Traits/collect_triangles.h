// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the triangles of a mesh of any type into flat arrays, and refuses a mesh that is not a manifold.

#ifndef CSCD_TRAITS_COLLECT_TRIANGLES_H
#define CSCD_TRAITS_COLLECT_TRIANGLES_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>
#include <vector>

namespace CSCD::internal {

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

#endif // CSCD_TRAITS_COLLECT_TRIANGLES_H
