// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve skeleton of a graph with positions in one call.

#ifndef CSCD_EXTRACT_CURVE_SKELETON_FROM_GRAPH_H
#define CSCD_EXTRACT_CURVE_SKELETON_FROM_GRAPH_H

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Graph_policies.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Spatial_graph_traits.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <type_traits>

namespace CSCD {
namespace internal {

/// The map from the vertices of `graph`, which is referred to, to their members `point`.
template <class Graph>
auto bundled_point_map(const Graph& graph)
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  return boost::make_function_property_map<Vertex>([&graph](Vertex vertex) -> const auto& {
    return graph[vertex].point;
  });
}

/// The point map that `np` gives, else the members `point` of the vertices of `graph`.
template <class Graph, class NamedParameters>
auto graph_point_map([[maybe_unused]] const Graph& graph, [[maybe_unused]] const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>::value) {
    return bundled_point_map(graph);
  } else {
    return parameters::get_parameter(np, CGAL::internal_np::vertex_point);
  }
}

} // namespace internal

/// extracts the curve skeleton of a graph with positions: a wire frame, a k-NN graph, the edges of triangles that do
/// not form a surface. No manifold and no orientation are needed.
///
/// Every connected component gets a connected skeleton. Thin parts are curves; a cycle of the graph is one of the
/// skeleton unless it goes around a limb or has less than five edges. A curve is its own skeleton: a path keeps all of
/// its vertices. The result is the same for any number of threads. See `Graph_policies` for the cost.
///
/// The length of an edge is its member `weight`, or else its length in space. Where vertices have a member `radius`, as
/// in `Skeleton_graph`, the radii of nodes are larger by it.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam Graph a model of Boost's `VertexListGraph` and `EdgeListGraph` without faces; directions do not count
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \param graph with vertices; it may be disconnected, with parallel edges, and edges from a vertex to itself
/// \param skeleton is cleared first; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `graph`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{the member `point` of the vertices, as in `Skeleton_graph`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// `random_seed`, `maximum_number_of_sources`, `number_of_threads` and `visitor` are as for a mesh.
///
/// \return counts, timings and warnings
/// \throw Input_error if `graph` cannot be skeletonized; the message names the element and the remedy
/// \throw Cancelled_error if the visitor stops the work
template <class ConcurrencyTag = CGAL::Sequential_tag, class Graph, class Skeleton,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_spatial_graph_v<Graph>, int> = 0>
Skeletonization_report extract_curve_skeleton(const Graph& graph, Skeleton& skeleton,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::random_seed_t,
                                   CGAL::internal_np::visitor_t, internal_np::maximum_number_of_sources_t,
                                   internal_np::number_of_threads_t>();
  const auto point_map = internal::graph_point_map(graph, np);
  using Traits = Spatial_graph_traits<Graph, std::decay_t<decltype(point_map)>>;
  const auto make_traits = [&] { return Traits(graph, point_map); };
  return internal::skeletonize<ConcurrencyTag>(make_traits, Graph_policies(), skeleton, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CURVE_SKELETON_FROM_GRAPH_H
