// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which node and branch each vertex or point of the input belongs to.

#ifndef CSCD_IO_WRITE_CORRESPONDENCE_H
#define CSCD_IO_WRITE_CORRESPONDENCE_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <ostream>
#include <type_traits>
#include <vector>

namespace CSCD {

/// The relation of a vertex or point of the input to the skeleton.
struct Vertex_label
{
  Index node = no_index;   ///< the node of the vertex; `no_index` if none
  Index branch = no_index; ///< the branch of that node
};

namespace internal {

/// \param node_of_vertex `no_index` for vertices of no node
std::vector<Vertex_label> label_vertices(const std::vector<Index>& node_of_vertex, const Skeleton_branches& branches);

/// For each point of a file, the vertex at its place of the mesh that was made from the file; `no_index` if none.
/// Linear. \param points_of_file or the `places_in_file` that repairs gave them
/// \param is_known of several vertices at a place, the first known one counts
std::vector<Index> vertices_of_file(const std::vector<Vector3>& points_of_file,
                                    const std::vector<Vector3>& points_of_mesh, const std::vector<char>& is_known);

std::vector<Vertex_label> labels_of_file(const std::vector<Vector3>& points_of_file,
                                         const std::vector<Vector3>& points_of_mesh,
                                         const std::vector<Vertex_label>& labels);

} // namespace internal

/// returns the node and branch of `skeleton` that every vertex of `mesh` belongs to, in the order of the vertices.
/// Expectedly linear.
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \tparam Skeleton a model of `CurveSkeletonGraph` that holds vertices of the mesh
/// \param branches of `skeleton`, as `measure_branches()` gives them
template <class TriangleMesh, class Skeleton, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
std::vector<Vertex_label> label_vertices(const TriangleMesh& mesh, const Skeleton& skeleton,
                                         const Skeleton_branches& branches)
{
  return internal::label_vertices(internal::assigned_surface(mesh, skeleton).node_of_vertex, branches);
}

/// writes labels as CSV: a line `vertex,node,branch` for each vertex under a line of names, all counted from 0; node
/// and branch are empty for vertices of no node. Linear. \throw File_error if `out` fails
void write_correspondence(std::ostream& out, const std::vector<Vertex_label>& labels);

} // namespace CSCD

#endif // CSCD_IO_WRITE_CORRESPONDENCE_H
