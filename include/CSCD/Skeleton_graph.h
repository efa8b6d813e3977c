// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graph that holds a curve skeleton.

#ifndef CSCD_SKELETON_GRAPH_H
#define CSCD_SKELETON_GRAPH_H

#include <CSCD/Skeleton.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <CGAL/number_utils.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/unordered_map.hpp>

#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// A node of a curve skeleton.
/// The members `point` and `vertices` are spelled as in CGAL's `Mean_curvature_flow_skeletonization`, so that code
/// written for its skeletons reads ours.
/// \tparam Point the point type of the input
/// \tparam InputDescriptor the identifier of a vertex or point of the input: a `vertex_descriptor` of the mesh, or the
///         index of a point
template <class Point, class InputDescriptor>
struct Skeleton_vertex
{
  /// Position, in the coordinates of the input.
  Point point{};
  /// The vertices or points of the input that belong to this node: over all nodes, each is in exactly one of these
  /// lists, which may be empty.
  std::vector<InputDescriptor> vertices{};
  /// Mean distance from the curve to the surface around this node, in the unit of the input; at an opening, mean
  /// distance from the node to the border.
  double radius = 0;
  /// Whether a limb is open here: it ends at a border of the input, and the node is in the middle of that border.
  bool is_opening = false;
};

/// An edge of a curve skeleton.
struct Skeleton_edge
{
  /// How far the limb that the edge belongs to reaches beyond the body it stands on, in radii of the limb; infinite if
  /// pruning never cuts the edge. See `compute_significance()`.
  double significance = std::numeric_limits<double>::infinity();
  /// Whether the edge was added by `simplify_skeleton()` to join two components: it may leave the body.
  bool is_joined = false;
};

/// A curve skeleton: nodes with position, radius and input vertices; its edges are straight segments.
template <class Point, class InputDescriptor>
using Skeleton_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                             Skeleton_vertex<Point, InputDescriptor>, Skeleton_edge>;

/// Whether the nodes of `Skeleton` carry a `radius`; CGAL's own skeleton type has none.
template <class Skeleton>
inline constexpr bool has_radius_v = CSCD_IS_VALID(typename Skeleton::vertex_bundled&, t.radius);

/// Whether the nodes of `Skeleton` have a flag `is_opening`: the node is in the middle of a border where a limb ends.
template <class Skeleton>
inline constexpr bool has_is_opening_v = CSCD_IS_VALID(typename Skeleton::vertex_bundled&, t.is_opening);

/// Whether the edges of `Skeleton` carry a `significance`; CGAL's own skeleton type has none.
template <class Skeleton>
inline constexpr bool has_significance_v = CSCD_IS_VALID(Skeleton&, t[*edges(t).first].significance);

/// Whether the edges of `Skeleton` have a flag `is_joined`: the edge was added to join components.
template <class Skeleton>
inline constexpr bool has_is_joined_v = CSCD_IS_VALID(Skeleton&, t[*edges(t).first].is_joined);

#ifdef DOXYGEN_RUNNING
/// A Boost `VertexListGraph`, `EdgeListGraph` and `MutableGraph` that can be default constructed and moved; the bundles
/// of its vertices have a `point`, assignable from the points of the input, the container `vertices` of the identifiers
/// of vertices or points of the input, appended by `push_back()`, and perhaps a `radius` and a flag `is_opening`. The
/// bundles of its edges may have a `significance` and a flag `is_joined`.
///
/// \cgalRefines{Boost's `VertexListGraph`, `EdgeListGraph`, `MutableGraph`}
/// \cgalHasModels{`Skeleton_graph`, `CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton`}
/// \cgalArchetype{Skeleton_archetype.h}
/// \cgalConcept
class CurveSkeletonGraph
{
};
#endif

/// refuses at compile time a type that is not a model of `CurveSkeletonGraph`.
/// \ingroup PkgCSCDConceptChecks
template <class T>
constexpr void check_curve_skeleton_graph()
{
  static_assert(CSCD_IS_VALID(const T&, vertices(t)), "CSCD: CurveSkeletonGraph requires vertices(g)");
  static_assert(CSCD_GIVES(std::size_t, const T&, num_vertices(t)),
                "CSCD: CurveSkeletonGraph requires num_vertices(g)");
  static_assert(CSCD_IS_VALID(const T&, edges(t)), "CSCD: CurveSkeletonGraph requires edges(g)");
  static_assert(CSCD_IS_VALID(T&, add_vertex(t)), "CSCD: CurveSkeletonGraph requires add_vertex(g)");
  static_assert(CSCD_IS_VALID(T&, add_edge(add_vertex(t), add_vertex(t), t)),
                "CSCD: CurveSkeletonGraph requires add_edge(v, w, g)");
  static_assert(CSCD_IS_VALID(T&, t[add_vertex(t)].point), "CSCD: CurveSkeletonGraph requires g[v].point");
  static_assert(CSCD_IS_VALID(T&, std::begin(t[add_vertex(t)].vertices)),
                "CSCD: CurveSkeletonGraph requires g[v].vertices, a range of input descriptors");
  static_assert(std::is_default_constructible_v<T> && std::is_move_assignable_v<T>,
                "CSCD: CurveSkeletonGraph requires a default constructor and a move assignment");
}

namespace internal {

/// The neighbors of the nodes of `skeleton`, in the order of its edges. An edge from a node to itself counts twice.
inline std::vector<std::vector<Index>> node_neighbors(const Skeleton& skeleton)
{
  std::vector<std::vector<Index>> neighbors(skeleton.number_of_nodes());
  for (const auto& [u, v] : skeleton.edges) {
    neighbors[u].push_back(v);
    neighbors[v].push_back(u);
  }
  return neighbors;
}

/// Copies `skeleton`, nodes and edges in iteration order; expectedly linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph`; radii are copied if its nodes have any
template <class Skeleton>
CSCD::Skeleton index_skeleton(const Skeleton& skeleton)
{
  using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  CSCD::Skeleton result;
  boost::unordered_map<Vertex, Index> index;
  for (const Vertex v : boost::make_iterator_range(vertices(skeleton))) {
    index.emplace(v, Index(result.points.size()));
    result.points.push_back(to_vector_3(skeleton[v].point));
    if constexpr (has_is_opening_v<Skeleton>) {
      result.is_opening.push_back(skeleton[v].is_opening ? 1 : 0);
    }
    if constexpr (has_radius_v<Skeleton>) {
      result.radii.push_back(CGAL::to_double(skeleton[v].radius));
    }
  }
  for (const auto e : boost::make_iterator_range(edges(skeleton))) {
    result.edges.push_back({index.at(source(e, skeleton)), index.at(target(e, skeleton))});
    if constexpr (has_is_joined_v<Skeleton>) {
      result.is_joined.push_back(skeleton[e].is_joined ? 1 : 0);
    } else {
      result.is_joined.push_back(0);
    }
  }
  return result;
}

/// The type of the points of the nodes of a `CurveSkeletonGraph`.
template <class Graph>
using Skeleton_point = std::decay_t<decltype(std::declval<const typename Graph::vertex_bundled&>().point)>;

/// The type of the input descriptors that they hold.
template <class Graph>
using Skeleton_descriptor =
    std::decay_t<decltype(*std::begin(std::declval<const typename Graph::vertex_bundled&>().vertices))>;

/// `skeleton` as a graph.
/// \tparam Graph a model of `CurveSkeletonGraph` \tparam Point constructible from three coordinates
/// \param descriptors identifies, by its number, each input vertex that `skeleton.vertices` names
/// \pre there are radii and significances if nodes and edges of `Graph` have them
template <class Graph, class Point = Skeleton_point<Graph>, class Descriptors>
Graph make_skeleton_graph(const Skeleton& skeleton, const Descriptors& descriptors)
{
  Graph graph;
  std::vector<decltype(add_vertex(graph))> vertex;
  vertex.reserve(skeleton.number_of_nodes());
  for (std::size_t node = 0; node < skeleton.number_of_nodes(); ++node) {
    vertex.push_back(add_vertex(graph));
    auto& bundle = graph[vertex[node]];
    bundle.point = make_point<Point>(skeleton.points[node]);
    if constexpr (has_radius_v<Graph>) {
      bundle.radius = skeleton.radii[node];
    }
    if constexpr (has_is_opening_v<Graph>) {
      bundle.is_opening = !skeleton.is_opening.empty() && skeleton.is_opening[node] != 0;
    }
    if (!skeleton.vertices.empty()) {
      for (const Index number : skeleton.vertices[node]) {
        bundle.vertices.push_back(descriptors[number]);
      }
    }
  }
  for (std::size_t i = 0; i < skeleton.edges.size(); ++i) {
    [[maybe_unused]] const auto edge =
        add_edge(vertex[skeleton.edges[i][0]], vertex[skeleton.edges[i][1]], graph).first;
    if constexpr (has_significance_v<Graph>) {
      graph[edge].significance = skeleton.significance[i];
    }
    if constexpr (has_is_joined_v<Graph>) {
      graph[edge].is_joined = !skeleton.is_joined.empty() && skeleton.is_joined[i] != 0;
    }
  }
  return graph;
}

} // namespace internal
} // namespace CSCD

#endif // CSCD_SKELETON_GRAPH_H
