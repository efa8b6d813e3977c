// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh and its skeleton as flat arrays: the input of the applications of skeletons.

#ifndef CSCD_APPLICATION_SKELETONIZED_SURFACE_H
#define CSCD_APPLICATION_SKELETONIZED_SURFACE_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Triangles, a skeleton in the same coordinates, and which node each vertex belongs to.
struct Skeletonized_surface
{
  Indexed_triangles triangles;
  Halfedge_pairing pairing; ///< of the triangles
  CSCD::Skeleton skeleton;
  std::vector<Index> node; ///< for each vertex of the triangles
};

/// Copies `mesh` and `skeleton`. Faces and nodes keep their order, vertices without a face are left out. Expectedly
/// linear. \return the copy, and the vertices of the mesh in the order of the copy
/// \throw Input_error if `mesh` is not a manifold of triangles, or a vertex with a face has no node of `skeleton`
template <class TriangleMesh, class Skeleton, class VertexPointMap>
auto collect_skeletonized_surface(const TriangleMesh& mesh, const Skeleton& skeleton, const VertexPointMap& point_map)
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  auto collected = collect_triangles(mesh, point_map);
  Skeletonized_surface surface{
      std::move(collected.triangles), std::move(collected.pairing), index_skeleton(skeleton), {}};
  auto nodes = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  for (const Vertex vertex : boost::make_iterator_range(vertices(mesh))) {
    put(nodes, vertex, no_index);
  }
  Index node = 0;
  for (const auto skeleton_vertex : boost::make_iterator_range(vertices(skeleton))) {
    for (const Vertex vertex : skeleton[skeleton_vertex].vertices) {
      put(nodes, vertex, node);
    }
    ++node;
  }
  surface.node.reserve(collected.descriptors.size());
  for (const Vertex vertex : collected.descriptors) {
    surface.node.push_back(get(nodes, vertex));
    if (surface.node.back() == no_index) {
      throw Input_error("vertex " + std::to_string(surface.node.size() - 1) +
                        " of those with a face belongs to no node: use the skeleton of this mesh");
    }
  }
  return std::pair(std::move(surface), std::move(collected.descriptors));
}

} // namespace CSCD::internal

#endif // CSCD_APPLICATION_SKELETONIZED_SURFACE_H
