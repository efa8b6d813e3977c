// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigs as glTF.

#ifndef CSCD_IO_WRITE_RIG_H
#define CSCD_IO_WRITE_RIG_H

#include <CSCD/Application/make_rig.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <ostream>
#include <string>
#include <type_traits>

namespace CSCD {

namespace internal {

void write_glb(std::ostream& out, const Assigned_surface& surface, const Rig& rig, const std::string& name);

} // namespace internal

/// writes a mesh with its rig as binary glTF 2.0 (`.glb`): the mesh with normals, a node for each joint, which are
/// called as `name()` has it, in their hierarchy and without rotations, inverse bind matrices, and four joints and
/// weights at each vertex. The vertices are those of the mesh in their order; coordinates are of single precision, and
/// axes stay as they are. If the skeleton has several components, a node named `rig` holds them together. Linear.
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \param rig of this mesh, as `make_rig()` gives it
/// \param name of the mesh
/// \pre all faces of `mesh` are triangles
/// \throw Input_error if the mesh has no faces, a coordinate is too large for single precision, there are more than
///        65,535 joints, or the file would be larger than 4 GB
/// \throw File_error if `out` fails
template <class TriangleMesh, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
void write_glb(std::ostream& out, const TriangleMesh& mesh, const Rig& rig, const std::string& name = "mesh")
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  internal::write_glb(out, internal::assigned_surface(mesh, Skeleton_graph<Vector3, Vertex>()), rig, name);
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_RIG_H
