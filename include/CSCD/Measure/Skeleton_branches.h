// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of the branches of a skeleton.

#ifndef CSCD_MEASURE_SKELETON_BRANCHES_H
#define CSCD_MEASURE_SKELETON_BRANCHES_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CSCD {

/// The kind of an end of a branch.
enum class Branch_end
{
  tip,      ///< a node with one edge, inside of the body
  opening,  ///< a node with one edge, in the middle of a border
  junction, ///< a node with three or more edges
  isolated, ///< a node without edges, which is a branch of its own
  closed    ///< nothing: the branch is a cycle without junction
};

/// The name of a value of `Branch_end`, as files have it.
constexpr const char* name(Branch_end end)
{
  return end == Branch_end::tip        ? "tip"
         : end == Branch_end::opening  ? "opening"
         : end == Branch_end::junction ? "junction"
         : end == Branch_end::isolated ? "isolated"
                                       : "closed";
}

/// A branch of a skeleton and its measures, in the unit of the skeleton. Unknown values, such as radii of a skeleton
/// without any, are not a number.
struct Skeleton_branch
{
  /// The value of unknown measures.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::vector<Index> nodes;                          ///< from end to end, as `split_into_branches()` gives them
  std::array<Branch_end, 2> ends{};                  ///< kinds of the first and the last node
  double length = 0;                                 ///< along the edges
  double chord = 0;                                  ///< distance of both ends
  double min_radius = unknown;                       ///< over the nodes
  double mean_radius = unknown;                      ///< over the length
  double max_radius = unknown;                       ///< over the nodes
  std::array<double, 2> end_radii{unknown, unknown}; ///< of the first and the last node
  /// Area of the sides of the frusta of circular cones between the nodes.
  double cone_area = unknown;
  /// Volume of these frusta: pi *l* (*r*² + *r* *s* + *s*²) / 3 for an edge of length *l* between radii *r* and *s*.
  double cone_volume = unknown;
  /// Area of the part of the surface that belongs to the branch.
  double surface_area = unknown;
  /// Volume of that part, closed by cones to the junctions where it meets other parts, and over borders to their
  /// middle: the volumes of all branches have the volume of the body as their sum.
  double volume = unknown;
  /// How far the limb reaches beyond its body, in radii; infinite if it is never cut. See `compute_significance()`.
  double significance = std::numeric_limits<double>::infinity();
  /// The branch before it on the way from the root; none if it contains the root, or without a root.
  std::optional<std::size_t> parent{};
  /// The number of branches before it on that way; none without a root.
  std::optional<std::size_t> order{};
  /// In a scan of trees, the `Tree_branch`, a limb from its base to its tip, that contains the branch.
  std::optional<std::size_t> limb{};

  /// The length over the chord: 1 if the branch is straight, infinite if it returns to its first node, not a number for
  /// an isolated node.
  double tortuosity() const
  {
    return chord > 0 ? length / chord : length > 0 ? std::numeric_limits<double>::infinity() : unknown;
  }
};

/// The branches of a skeleton; all outputs name them by their index in `branches`.
struct Skeleton_branches
{
  std::vector<Skeleton_branch> branches; ///< in the order of `split_into_branches()`
  /// The branch of every node. A junction where several end belongs to the branch of the greatest mean radius.
  std::vector<Index> branch_of_node;
};

/// Measures of the surface around a node, in the unit of the skeleton. Unknown values are not a number.
struct Node_measures
{
  /// Distance to the surface; not known if it is more than three radii.
  double inscribed_radius = Skeleton_branch::unknown;
  /// Area of the section through the node, perpendicular to the skeleton. It is not known of junctions and isolated
  /// nodes, which have no direction, nor where the section reaches beyond three radii or meets a border.
  double section_area = Skeleton_branch::unknown;
};

namespace internal {

/// Triangles and the node of each vertex.
struct Assigned_surface
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> node_of_vertex; ///< `no_index` for vertices of no node
};

/// Copies a triangle mesh, with the `vertex_point_map` of `np`, and the nodes of its vertices in `skeleton`; expectedly
/// linear.
/// \throw Input_error if a face is not a triangle of three different vertices
template <class TriangleMesh, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Assigned_surface assigned_surface(const TriangleMesh& mesh, const Skeleton& skeleton,
                                  const NamedParameters& np = parameters::default_values())
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const auto point_map = vertex_point_map(mesh, np);
  Assigned_surface result;
  // A property of the mesh would be faster, but adding one writes to the mesh: others may be reading it.
  std::unordered_map<Vertex, Index> number;
  number.reserve(num_vertices(mesh));
  result.points.reserve(num_vertices(mesh));
  for (const Vertex v : boost::make_iterator_range(vertices(mesh))) {
    number.emplace(v, Index(number.size()));
    result.points.push_back(to_vector_3(get(point_map, v)));
  }
  for (const auto f : boost::make_iterator_range(faces(mesh))) {
    result.triangles.push_back(read_corners(mesh, boost::make_assoc_property_map(number), f, result.triangles.size()));
  }
  result.node_of_vertex.assign(number.size(), no_index);
  Index node = 0;
  for (const auto v : boost::make_iterator_range(vertices(skeleton))) {
    for (const Vertex vertex : skeleton[v].vertices) {
      result.node_of_vertex[number.at(vertex)] = node;
    }
    ++node;
  }
  return result;
}

/// The significance of every edge; empty if the skeleton has no radii.
std::vector<double> edge_significances(const Skeleton& skeleton);

/// \param roots nodes, at most one of each component; parents and orders are left out if there is none
Skeleton_branches measure_branches(const Skeleton& skeleton, const std::vector<Index>& roots = {});

/// Adds area and volume of the parts of the surface.
void measure_surface_parts(const Skeleton& skeleton, const Assigned_surface& surface, Skeleton_branches& branches);

std::vector<Node_measures> measure_nodes(const Skeleton& skeleton, const Assigned_surface& surface);

} // namespace internal

/// measures the branches of a skeleton of any origin; `surface_area` and `volume` are left unknown.
/// O(n log n) for n nodes.
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \param roots nodes, counted from 0 in the order of the graph, such as `find_roots()` gives them; of a component
///        without any it is the first node. If there are none at all, parents and orders are left out. Where a cycle
///        has to be cut for that, it is cut where it is thinnest.
template <class Skeleton>
Skeleton_branches measure_branches(const Skeleton& skeleton, const std::vector<Index>& roots = {})
{
  return internal::measure_branches(internal::index_skeleton(skeleton), roots);
}

/// measures the branches of the skeleton of a mesh, and the parts of its surface that belong to them. A face belongs to
/// the branch of the node that two of its vertices share, else of the first of their nodes. A face whose vertices
/// belong to no node is left out. O(n log n + m) for n nodes and m faces.
/// \tparam Skeleton a model of `CurveSkeletonGraph` that holds vertices of the mesh
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \param roots as of the function without a mesh
/// \pre all faces of `mesh` are triangles; all coordinates are finite
template <class Skeleton, class TriangleMesh, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
Skeleton_branches measure_branches(const Skeleton& skeleton, const TriangleMesh& mesh,
                                   const std::vector<Index>& roots = {})
{
  const CSCD::Skeleton indexed = internal::index_skeleton(skeleton);
  Skeleton_branches result = internal::measure_branches(indexed, roots);
  internal::measure_surface_parts(indexed, internal::assigned_surface(mesh, skeleton), result);
  return result;
}

/// measures the surface of a mesh around each node of its skeleton. O(m log m + n k) for m faces and n nodes, with up
/// to k faces within three radii of each.
/// \tparam Skeleton a model of `CurveSkeletonGraph` that holds vertices of the mesh and has radii
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \return the measures of the nodes in their order
/// \pre all faces of `mesh` are triangles; all coordinates are finite
template <class Skeleton, class TriangleMesh, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
std::vector<Node_measures> measure_nodes(const Skeleton& skeleton, const TriangleMesh& mesh)
{
  return internal::measure_nodes(internal::index_skeleton(skeleton), internal::assigned_surface(mesh, skeleton));
}

} // namespace CSCD

#endif // CSCD_MEASURE_SKELETON_BRANCHES_H
