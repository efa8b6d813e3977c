// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh and its skeleton as flat arrays: the input of the applications of skeletons.

#ifndef CSCD_APPLICATION_SKELETONIZED_SURFACE_H
#define CSCD_APPLICATION_SKELETONIZED_SURFACE_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Triangles, a skeleton in the same coordinates, and which node each vertex belongs to.
struct Skeletonized_surface
{
  Indexed_triangles triangles; ///< without points that have no face
  Halfedge_pairing pairing;    ///< of the triangles
  CSCD::Skeleton skeleton;
  std::vector<Index> node;   ///< for each vertex of the triangles
  std::vector<Index> number; ///< of each vertex among the points of the mesh
};

/// Faces and nodes keep their order, points without a face are left out. Linear.
/// \throw Input_error as `check_triangles()` does, or if a vertex with a face belongs to no node
inline Skeletonized_surface make_skeletonized_surface(Assigned_surface&& assigned, CSCD::Skeleton skeleton)
{
  Checked_triangles checked = check_triangles(std::move(assigned.points), std::move(assigned.triangles));
  Skeletonized_surface surface{std::move(checked.triangles),
                               std::move(checked.pairing),
                               std::move(skeleton),
                               {},
                               std::move(checked.input_number)};
  for (const Index number : surface.number) {
    surface.node.push_back(assigned.node_of_vertex[number]);
    if (surface.node.back() == no_index) {
      throw Input_error("vertex " + std::to_string(surface.node.size() - 1) +
                        " of those with a face belongs to no node: use the skeleton of this mesh");
    }
  }
  return surface;
}

/// Copies `mesh`, with the `vertex_point_map` of `np`, and `skeleton`; expectedly linear.
template <class TriangleMesh, class Skeleton, class NamedParameters>
Skeletonized_surface collect_skeletonized_surface(const TriangleMesh& mesh, const Skeleton& skeleton,
                                                  const NamedParameters& np)
{
  check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t>();
  check_triangle_mesh<TriangleMesh>();
  return make_skeletonized_surface(assigned_surface(mesh, skeleton, vertex_point_map(mesh, np)),
                                   index_skeleton(skeleton));
}

} // namespace CSCD::internal

#endif // CSCD_APPLICATION_SKELETONIZED_SURFACE_H
