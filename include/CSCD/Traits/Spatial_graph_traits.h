// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A graph with positions, as the skeletonization sees it.

#ifndef CSCD_TRAITS_SPATIAL_GRAPH_TRAITS_H
#define CSCD_TRAITS_SPATIAL_GRAPH_TRAITS_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Surface_adapter.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/unordered_map.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// The adapter of a graph to a `Spatial_graph`; a model of `SkeletonizationTraits`.
///
/// The graph needs not be a surface, nor anything of one: it may be disconnected, with vertices without edges, with
/// parallel edges, and edges from a vertex to itself. Edges have no direction here. Every vertex of the input belongs
/// to one vertex of the graph: its own, or that of the vertices at the same place.
/// \tparam Graph a model of Boost's `VertexListGraph` and `EdgeListGraph`
/// \tparam VertexPointMap a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`,
///         constructible from three coordinates
template <class Graph, class VertexPointMap>
class Spatial_graph_traits
    : public Surface_adapter<Spatial_graph, typename boost::property_traits<VertexPointMap>::value_type,
                             typename boost::graph_traits<Graph>::vertex_descriptor>
{
public:
  /// The identifier of a vertex of the input.
  using Input_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;

  /// Reads `graph`, which is not referred to later; O(n log n). The length of an edge is its member `weight`, in any
  /// unit, or else its length in space. Where the vertices have a member `radius`, as in `Skeleton_graph`, the radii of
  /// nodes are larger by it.
  /// \throw Input_error naming the element and the remedy if a coordinate, weight or radius is not finite, a weight is
  ///        negative, or the graph is empty
  Spatial_graph_traits(const Graph& graph, const VertexPointMap& point_map)
  {
    std::vector<Input_descriptor> descriptors;
    std::vector<Vector3> points;
    std::vector<double> radii;
    boost::unordered_map<Input_descriptor, Index> number;
    for (const Input_descriptor vertex : boost::make_iterator_range(vertices(graph))) {
      number.emplace(vertex, Index(points.size()));
      descriptors.push_back(vertex);
      points.push_back(internal::to_vector_3(get(point_map, vertex)));
      check(points.back().allFinite(), "vertex", points.size() - 1, "has a coordinate that is not finite");
      if constexpr (CSCD_GIVES(double, const Graph&, t[*vertices(t).first].radius)) {
        radii.push_back(double(graph[vertex].radius));
        check(std::isfinite(radii.back()), "vertex", points.size() - 1, "has a radius that is not finite");
      }
    }
    std::vector<Spatial_graph::Edge> graph_edges;
    for (const auto edge : boost::make_iterator_range(edges(graph))) {
      const Index a = number.at(source(edge, graph));
      const Index b = number.at(target(edge, graph));
      graph_edges.push_back({a, b, length(graph, edge, points[a], points[b])});
      check(std::isfinite(graph_edges.back().length) && graph_edges.back().length >= 0, "edge", graph_edges.size() - 1,
            "has a weight that is negative or not finite");
    }
    if (points.empty()) {
      throw Input_error("the graph has no vertices: check how the input was written");
    }
    const Spatial_graph& surface = this->m_surface.emplace(std::move(points), graph_edges, radii);
    this->m_normalization = surface.normalization();
    Skeletonization_report& report = this->m_report; // without a genus: a graph has none
    report.number_of_surface_components = surface.number_of_components();
    report.add_warning(surface.number_of_duplicates(), "vertex at the place of another: it belongs to the same node",
                       "vertices at the place of others: they belong to the same nodes");
    report.add_warning(surface.number_of_unused_edges(),
                       "edge from a vertex to itself or parallel to another: left out",
                       "edges from a vertex to itself or parallel to others: left out");
    this->describe(descriptors, surface.vertex_of_point());
  }
  /// A temporary graph is refused: the descriptors would refer to it.
  Spatial_graph_traits(Graph&&, const VertexPointMap&) = delete;

private:
  template <class Edge>
  static double length([[maybe_unused]] const Graph& graph, [[maybe_unused]] const Edge& edge,
                       [[maybe_unused]] const Vector3& a, [[maybe_unused]] const Vector3& b)
  {
    if constexpr (CSCD_GIVES(double, const Graph&, t[*edges(t).first].weight)) {
      return double(graph[edge].weight);
    } else {
      return (a - b).norm();
    }
  }

  static void check(bool is_good, const char* element, std::size_t number, const char* fault)
  {
    if (!is_good) {
      throw Input_error(std::string(element) + " " + std::to_string(number) + " " + fault + ": correct or remove it");
    }
  }
};

} // namespace CSCD

#endif // CSCD_TRAITS_SPATIAL_GRAPH_TRAITS_H
