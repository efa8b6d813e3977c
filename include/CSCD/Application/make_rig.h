// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A rig for animation: joints in a hierarchy, and which of them move the vertices of a mesh.

#ifndef CSCD_APPLICATION_MAKE_RIG_H
#define CSCD_APPLICATION_MAKE_RIG_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CSCD {

/// A joint of a rig: it turns the joints after it about its place.
struct Rig_joint
{
  std::optional<std::size_t> parent{}; ///< the number of the joint before it; none for a root
  Index node = no_index;               ///< the node of the skeleton at its place; along a spine, its number from 0
  Index branch = no_index;             ///< the branch of that node; `no_index` along a spine
  Vector3 point{};                     ///< its place
  double radius = 0;                   ///< of the body there
  bool is_tip = false;                 ///< whether a limb ends in it, so that it moves nothing
};

/// The name of a joint in files, as `branch_3_node_17`, or `spine_2` along a spine.
inline std::string name(const Rig_joint& joint)
{
  return (joint.branch == no_index ? "spine_" : "branch_" + std::to_string(joint.branch) + "_node_") +
         std::to_string(joint.node);
}

/// How strongly a joint moves a vertex.
struct Rig_influence
{
  Index joint = 0;   ///< the number of the joint
  double weight = 0; ///< from 0, for none, to 1
};

/// Joints, and which of them move the vertices of a mesh.
struct Rig
{
  /// How many joints move a vertex at most, as engines for animation have it.
  static constexpr std::size_t max_number_of_influences = 4;
  /// Of one vertex, the strongest first; the sum of their weights is 1.
  using Influences = std::array<Rig_influence, max_number_of_influences>;

  std::vector<Rig_joint> joints;      ///< each after its parent, and its descendants right after it
  std::vector<Influences> influences; ///< of the vertices of the mesh in their order
};

namespace internal {

/// \param root see the public function
Rig make_rig(const Skeleton& parts, const Assigned_surface& surface, std::optional<Index> root);

} // namespace internal

/// makes a rig of the skeleton of a mesh.
///
/// Components are joined by the shortest straight edges, so that the rig has one root. Joints are at the root,
/// junctions and tips of the skeleton, a quarter of a radius outside junctions, so that each limb has a joint of its
/// own, and along limbs at even distances: every 0.06 of the size of the body, but at most five. Cycles are cut where
/// they are thinnest.
///
/// Components that are small and thin, such as strands of hair, buttons and belts, get no joints and move with the one
/// that they are joined to: of a radius below 0.02 and in a box of a diagonal below 0.3 of the size of the body.
///
/// Where one of several components holds two thirds of the volume and nine tenths of an ellipsoid, as the body of a
/// fish with fins and eyes, and is not a ball, there are seven joints on a straight spine: through its center, along
/// the principal axis that all components together are longest along and do not stick out at both ends of.
///
/// A vertex is moved by the joint before its place on the skeleton, which is the point of the edges at its node that is
/// nearest to it. Up to one radius before and after a joint, the weights go over from one joint to the other by a cubic
/// polynomial of the distance along the skeleton. At last they are averaged over neighboring vertices, so often that
/// they spread by a quarter of a mean radius, as places on the skeleton leap where limbs meet.
///
/// O(n log n + m k + c^2), for n nodes, k averagings, 2 to 64, over m vertices, and c nodes of components to be joined.
///
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \tparam Skeleton a model of `CurveSkeletonGraph` that holds vertices of the mesh and has radii
/// \param root a node, counted from 0 in the order of the graph; by default, the thickest node
/// \throw Input_error if components have too many nodes to be joined; the message names the remedy
/// \pre `skeleton` has nodes; all faces of `mesh` are triangles
template <class TriangleMesh, class Skeleton, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
Rig make_rig(const TriangleMesh& mesh, const Skeleton& skeleton, std::optional<Index> root = std::nullopt)
{
  static_assert(has_radius_v<Skeleton>, "joints are placed by the radii of the nodes");
  return internal::make_rig(internal::index_skeleton(skeleton), internal::assigned_surface(mesh, skeleton), root);
}

} // namespace CSCD

#endif // CSCD_APPLICATION_MAKE_RIG_H
