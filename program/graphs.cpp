// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs that are treated as graphs.

#include "types.h"
#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Vector3.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

/// Adds the sides of the polygons of `soup`.
void add_sides(const CSCD::Shape_file& soup, Skeleton& graph)
{
  graph.edges.reserve(graph.edges.size() + soup.corners.size());
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    const std::size_t begin = soup.first_corner[polygon];
    const std::size_t end = soup.first_corner[polygon + 1];
    for (std::size_t i = begin; i < end; ++i) {
      graph.edges.push_back({soup.corners[i], soup.corners[i + 1 < end ? i + 1 : begin]});
    }
  }
}

} // namespace

Skeleton make_graph(const CSCD::Shape_file& soup, std::vector<std::array<Index, 2>> edges,
                    unsigned int number_of_neighbors)
{
  Skeleton graph;
  graph.points = soup.points;
  graph.radii = soup.radii;
  graph.edges = std::move(edges);
  add_sides(soup, graph);
  if (graph.edges.empty()) {
    const Index number = number_of_neighbors > 0 ? number_of_neighbors : CSCD::default_number_of_neighbors;
    for (const CSCD::Spatial_graph::Edge& edge : CSCD::neighbor_edges(graph.points, number)) {
      graph.edges.push_back({edge.source, edge.target});
    }
  }
  return graph;
}

Input make_input(Skeleton graph)
{
  Input input;
  input.as_read.points = graph.points;
  input.is_point_set = true;
  input.number_of_points = graph.points.size();
  input.points = graph.points;
  input.graph = std::move(graph);
  return input;
}

Input read_graph(const Skeletonize_options& options)
{
  const CSCD::Shape_file shape = read_file(options.input, options.format, CSCD::internal::any_content);
  const std::string filename = options.format.empty() ? options.input : "." + options.format;
  std::vector<std::array<Index, 2>> edges;
  for (const auto& [a, b] : shape.lines) {
    edges.push_back({Index(a), Index(b)});
  }
  // The nodes of a graph without edges are not joined to their neighbors.
  return make_input(CSCD::internal::is_graph_filename(filename) && edges.empty()
                        ? Skeleton{shape.points, shape.radii}
                        : make_graph(shape, std::move(edges), options.number_of_neighbors));
}

} // namespace cscd
