// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplification of finished skeletons.

#ifndef CSCD_MEASURE_SIMPLIFY_SKELETON_H
#define CSCD_MEASURE_SIMPLIFY_SKELETON_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CSCD {

/// The changes of a simplification, and the counts of its result, which has its length in the unit of the skeleton.
struct Simplification_report : Skeleton_counts
{
  std::size_t number_of_removed_components = 0; ///< components that were too small
  std::size_t number_of_removed_vertices = 0;   ///< vertices or points of the input that belong to no node any more
  std::size_t number_of_removed_nodes = 0;      ///< nodes of branches that were pruned
  std::size_t number_of_joined_edges = 0;       ///< edges that were added to join components
};

namespace internal {

/// The steps to take; a length or a number of 0 turns its step off.
struct Simplification_parameters
{
  std::size_t min_component_size = 0; ///< in vertices of the input, or in nodes if these have none
  double min_significance = 0;
  double min_length = 0;
  double min_length_over_radius = 0;
  bool joins_components = false;
  double spacing = 0;
  double spacing_over_radius = 0;
};

/// Simplifies a plain skeleton, with the vertices of the input, openings and significances. Its separators stay.
/// \param skeleton as it was if the function throws
/// \param solid the body, or null if it is not known
Simplification_report simplify_skeleton(Skeleton& skeleton, const Simplification_parameters& parameters,
                                        const Triangulated_solid* solid);

template <class Graph, class NamedParameters>
Simplification_report simplify_skeleton(Graph& graph, const Triangulated_solid* solid, const NamedParameters& np)
{
  check_curve_skeleton_graph<Graph>();
  check_named_parameters<NamedParameters, internal_np::minimum_component_size_t, internal_np::minimum_significance_t,
                         internal_np::minimum_branch_length_t, internal_np::minimum_length_over_radius_t,
                         internal_np::join_components_t, internal_np::spacing_t, internal_np::spacing_over_radius_t,
                         CGAL::internal_np::vertex_point_t>();
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Simplification_parameters steps;
  const auto read = [&](auto& value, const auto& tag) {
    value = std::decay_t<decltype(value)>(choose_parameter(get_parameter(np, tag), value));
  };
  read(steps.min_component_size, internal_np::minimum_component_size);
  read(steps.min_significance, internal_np::minimum_significance);
  read(steps.min_length, internal_np::minimum_branch_length);
  read(steps.min_length_over_radius, internal_np::minimum_length_over_radius);
  read(steps.joins_components, internal_np::join_components);
  read(steps.spacing, internal_np::spacing);
  read(steps.spacing_over_radius, internal_np::spacing_over_radius);
  Skeleton skeleton = index_skeleton(graph);
  std::vector<Skeleton_descriptor<Graph>> descriptors;
  for (const auto node : boost::make_iterator_range(vertices(graph))) {
    std::vector<Index>& numbers = skeleton.vertices.emplace_back();
    for (const auto& descriptor : graph[node].vertices) {
      numbers.push_back(Index(descriptors.size()));
      descriptors.push_back(descriptor);
    }
  }
  const Simplification_report report = simplify_skeleton(skeleton, steps, solid);
  graph = make_skeleton_graph<Graph>(skeleton, descriptors);
  return report;
}

} // namespace internal

/// simplifies a finished skeleton of any origin.
///
/// The requested steps are taken in this order; without parameters nothing changes.
/// -# Small components are removed, except the largest.
/// -# Branches are pruned that are less significant than asked, then short ones, then short ones in radii: the least
///    first, and where two branches are then alone at a junction they count as one. See `compute_significance()`. The
///    last branch of a tree stays.
/// -# Components are joined by straight edges into one, by the minimum spanning tree over the distances from the tips
///    of one (all nodes, if there are none) to the nodes of the other. Such edges have `is_joined`.
/// -# Branches are sampled anew: tips, junctions and the ends of joined edges stay, the nodes between are replaced by
///    equidistant ones on the branch. Cycles keep at least three nodes, and radii are interpolated.
///
/// Handles are never cut: the Betti number stays. The vertices of the input that belong to nodes which are gone belong
/// to the nearest node along the skeleton that is left; those of removed components to none. Significances are computed
/// anew. Each of the steps up to the third, alone, changes nothing when it is repeated. O(n log n) for n nodes.
///
/// \tparam Skeleton a model of `CurveSkeletonGraph`, its points constructible from three coordinates
/// \param skeleton is replaced, with the properties that the concept knows and no others; if the function throws, it is
///        as it was
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_component_size}
///     \cgalParamDescription{components with fewer vertices or points of the input are removed; if the whole skeleton
///     has none, components with fewer nodes}
///     \cgalParamType{std::size_t}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_significance}
///     \cgalParamDescription{branches that are less significant are pruned}
///     \cgalParamType{double}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_branch_length}
///     \cgalParamDescription{branches that end in a tip and are shorter are pruned}
///     \cgalParamType{double, in the unit of the skeleton}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_length_over_radius}
///     \cgalParamDescription{branches that end in a tip and are shorter, in their mean radii, are pruned}
///     \cgalParamType{double}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{join_components}
///     \cgalParamDescription{whether components are joined}
///     \cgalParamType{bool}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{spacing}
///     \cgalParamDescription{the distance of nodes along branches, 0 to leave them as they are}
///     \cgalParamType{double, in the unit of the skeleton}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{spacing_over_radius}
///     \cgalParamDescription{the same in local radii; not with `spacing`}
///     \cgalParamType{double}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the changes, and counts of the result
/// \throw Input_error if a coordinate, radius or parameter is not finite or negative where it must not be; if radii are
///        needed and the skeleton has none; if a spacing asks for more nodes than there can be; or if there are too
///        many nodes to join: 2^34 pairs of an end and a node of another component
template <class Skeleton, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_triangle_mesh_v<NamedParameters>, int> = 0>
Simplification_report simplify_skeleton(Skeleton& skeleton, const NamedParameters& np = parameters::default_values())
{
  return internal::simplify_skeleton(skeleton, nullptr, np);
}

/// simplifies the skeleton of a mesh; parts inside of the mesh stay inside. See the function without a mesh.
///
/// Where an edge of a branch that is sampled anew would leave the mesh, the branch is sampled more closely.
/// \param mesh an oriented manifold of triangles; borders are bridged
/// \param np as of the other function, and `vertex_point_map`, the points of the vertices of `mesh`
/// \throw Input_error as the other function, and if `mesh` cannot be skeletonized
template <class Skeleton, class TriangleMesh, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
Simplification_report simplify_skeleton(Skeleton& skeleton, const TriangleMesh& mesh,
                                        const NamedParameters& np = parameters::default_values())
{
  check_triangle_mesh<TriangleMesh>();
  const auto point_map = internal::vertex_point_map(mesh, np);
  const Triangle_mesh_traits<TriangleMesh, std::decay_t<decltype(point_map)>> traits(mesh, point_map,
                                                                                     Border_treatment::bridge);
  return internal::simplify_skeleton(skeleton, &traits.surface(), np);
}

} // namespace CSCD

#endif // CSCD_MEASURE_SIMPLIFY_SKELETON_H
