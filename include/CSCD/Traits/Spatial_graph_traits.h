// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A graph with positions, as the skeletonization sees it.

#ifndef CSCD_TRAITS_SPATIAL_GRAPH_TRAITS_H
#define CSCD_TRAITS_SPATIAL_GRAPH_TRAITS_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/unordered_map.hpp>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
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
{
public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  /// The identifier of a vertex of the input.
  using Input_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  /// The surface that the pipeline runs on.
  using Surface = Spatial_graph;
  /// @}

  /// Reads `graph`, which is not referred to later; O(n log n). The length of an edge is its member `weight`, in any
  /// unit, or else its length in space. Where the vertices have a member `radius`, as in `Skeleton_graph`, the radii of
  /// nodes are larger by it.
  /// \throw Input_error naming the element and the remedy if a coordinate, weight or radius is not finite, a weight is
  ///        negative, or the graph is empty
  Spatial_graph_traits(const Graph& graph, const VertexPointMap& point_map)
  {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Input_descriptor> descriptors;
    std::vector<Vector3> points;
    std::vector<double> radii;
    boost::unordered_map<Input_descriptor, Index> number;
    for (const Input_descriptor vertex : boost::make_iterator_range(vertices(graph))) {
      number.emplace(vertex, Index(points.size()));
      descriptors.push_back(vertex);
      const auto& point = get(point_map, vertex);
      points.emplace_back(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
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
    m_graph.emplace(std::move(points), graph_edges, radii);
    const std::vector<Index>& vertex_of_point = m_graph->vertex_of_point();
    m_descriptors = internal::Compressed_rows<Input_descriptor>(m_graph->number_of_vertices(), [&](const auto& add) {
      for (std::size_t i = 0; i < descriptors.size(); ++i) {
        add(vertex_of_point[i], descriptors[i]);
      }
    });
    m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// A temporary graph is refused: the descriptors would refer to it.
  Spatial_graph_traits(Graph&&, const VertexPointMap&) = delete;

  /// The graph in flat arrays.
  const Spatial_graph& surface() const { return *m_graph; }

  /// \name Back to the input
  /// @{

  /// The vertices of the input that are at `vertex`.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index vertex) const { return m_descriptors[vertex]; }
  /// A point of the graph in the coordinates of the input.
  Point to_input_point(const Vector3& point) const
  {
    return CSCD::to_input_point<Point>(m_graph->normalization(), point);
  }
  /// A length in the unit of the input.
  double to_input_length(double length) const { return length * m_graph->normalization().unit; }
  /// Describes the input in `report`. A graph has no genus.
  void describe_input(Skeletonization_report& report) const
  {
    report.number_of_input_vertices = m_descriptors.number_of_values();
    report.number_of_surface_components = m_graph->number_of_components();
    report.seconds[std::size_t(Skeletonization_stage::compile_surface)] = m_seconds;
    report.add_warning(m_graph->number_of_duplicates(), "vertex at the place of another: it belongs to the same node",
                       "vertices at the place of others: they belong to the same nodes");
    report.add_warning(m_graph->number_of_unused_edges(),
                       "edge from a vertex to itself or parallel to another: left out",
                       "edges from a vertex to itself or parallel to others: left out");
  }
  /// @}

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

  std::optional<Spatial_graph> m_graph;
  internal::Compressed_rows<Input_descriptor> m_descriptors; // of every vertex
  double m_seconds = 0;
};

} // namespace CSCD

#endif // CSCD_TRAITS_SPATIAL_GRAPH_TRAITS_H
