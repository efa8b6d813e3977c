// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the triangles of a mesh of any type into flat arrays, and refuses a mesh that is not a manifold.

#ifndef CSCD_TRAITS_COLLECT_TRIANGLES_H
#define CSCD_TRAITS_COLLECT_TRIANGLES_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/read_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The triangles of a mesh, and where they came from.
template <class VertexDescriptor>
struct Collected_triangles
{
  Indexed_triangles triangles;
  Halfedge_pairing pairing;
  std::vector<VertexDescriptor> descriptors; ///< the vertices of the points
  std::size_t number_of_isolated_vertices = 0;
};

/// Reads `mesh` into points and index triples. Vertices and faces keep the iteration order of the mesh; vertices
/// without a face are left out. Linear where vertices are indices as in `CGAL::Surface_mesh`, expectedly linear
/// otherwise.
/// \param mesh a model of `FaceListGraph`
/// \param point_map a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`
/// \param number_of_threads 0 for as many as TBB allows
/// \throw Input_error as `read_mesh()` and `check_triangles()` do
template <class TriangleMesh, class VertexPointMap>
Collected_triangles<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
collect_triangles(const TriangleMesh& mesh, const VertexPointMap& point_map, unsigned number_of_threads = 1)
{
  auto arrays = read_mesh(mesh, point_map);
  Checked_triangles checked = check_triangles(std::move(arrays.points), std::move(arrays.faces), number_of_threads);
  Collected_triangles<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> result;
  result.descriptors.reserve(checked.input_number.size());
  for (const Index number : checked.input_number) {
    result.descriptors.push_back(arrays.descriptors[number]);
  }
  result.triangles = std::move(checked.triangles);
  result.pairing = std::move(checked.pairing);
  result.number_of_isolated_vertices = checked.number_of_isolated_vertices;
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_COLLECT_TRIANGLES_H
