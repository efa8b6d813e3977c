// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs that are treated as graphs.

#include "types.h"
#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

using Graph = CSCD::Skeleton;

/// Adds the sides of the polygons of `soup`.
void add_sides(const CSCD::Shape_file& soup, Graph& graph)
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

std::vector<std::array<CSCD::Index, 2>> edges_of(const CSCD::Shape_file& shape)
{
  std::vector<std::array<CSCD::Index, 2>> result;
  result.reserve(shape.lines.size());
  for (const auto& [a, b] : shape.lines) {
    result.push_back({CSCD::Index(a), CSCD::Index(b)});
  }
  return result;
}

} // namespace

CSCD::Skeleton make_graph(const CSCD::Shape_file& soup, std::vector<std::array<CSCD::Index, 2>> edges,
                          unsigned int number_of_neighbors)
{
  Graph graph;
  graph.points = soup.points;
  graph.radii = soup.radii;
  graph.edges = std::move(edges);
  add_sides(soup, graph);
  if (graph.edges.empty()) {
    const CSCD::Index number = number_of_neighbors > 0 ? number_of_neighbors : CSCD::default_number_of_neighbors;
    for (const CSCD::Spatial_graph::Edge& edge : CSCD::neighbor_edges(graph.points, number)) {
      graph.edges.push_back({edge.source, edge.target});
    }
  }
  return graph;
}

Input make_input(CSCD::Skeleton graph)
{
  Input input;
  input.as_read.points = graph.points;
  input.is_point_set = true;
  input.points.reserve(graph.points.size());
  for (const CSCD::Vector_3& point : graph.points) {
    input.points.emplace_back(point.x(), point.y(), point.z());
    input.mesh.add_vertex(input.points.back());
  }
  input.graph = std::move(graph);
  return input;
}

Input read_graph(const Skeletonize_options& options)
{
  const std::string name = name_of(options.input);
  const bool is_standard = options.input == standard_stream;
  if (is_standard) {
    check_format_of_standard_input(options.format);
  }
  const std::string filename = options.format.empty() ? options.input : "." + options.format;
  CSCD::Shape_file shape = read_shape(is_standard ? CSCD::internal::read_content(std::cin, name, filename)
                                                  : CSCD::internal::read_content(options.input),
                                      filename, name);
  // The nodes of a graph without edges are not joined to their neighbors.
  Graph graph = CSCD::internal::is_graph_filename(filename) && shape.lines.empty()
                    ? Graph{shape.points, shape.radii}
                    : make_graph(shape, edges_of(shape), options.number_of_neighbors);
  Input input = make_input(std::move(graph));
  input.as_read = std::move(shape);
  return input;
}

} // namespace cscd
