// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs that are taken for graphs.

#include "types.h"
#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <locale>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

using Graph = CSCD::internal::Indexed_skeleton;

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

/// Whether a line of `content` begins with `statement`.
bool has_statement(const std::string& content, const std::string& statement)
{
  return boost::algorithm::starts_with(content, statement) || boost::algorithm::contains(content, "\n" + statement);
}

/// Whether a file holds edges besides vertices and perhaps faces, in a format that may also be that of a mesh.
bool has_edges(const std::string& content, const std::string& ending)
{
  return (ending == ".obj" && has_statement(content, "l ")) ||
         (ending == ".ply" &&
          boost::algorithm::contains(content.substr(0, content.find("end_header")), "element edge"));
}

} // namespace

CSCD::internal::Indexed_skeleton make_graph(const CSCD::Shape_file& soup, std::vector<std::array<CSCD::Index, 2>> edges,
                                            unsigned int number_of_neighbors)
{
  Graph graph;
  graph.points = soup.points;
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

Input make_input(CSCD::internal::Indexed_skeleton graph)
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
  if (options.input == standard_stream && options.format.empty()) {
    throw Usage_error(
        "standard input has no ending: name its format by --format graph, edges, obj, off, ply, stl or xyz");
  }
  const std::string content = options.input == standard_stream
                                  ? CSCD::internal::read_content(std::cin, name, "." + options.format)
                                  : CSCD::internal::read_content(options.input);
  const std::string lower = CSCD::without_compression_ending(boost::algorithm::to_lower_copy(
      options.format.empty() ? options.input : "." + options.format, std::locale::classic()));
  const auto ends_with = [&lower](const char* ending) { return boost::algorithm::ends_with(lower, ending); };
  const std::string ending = lower.substr(std::min(lower.find_last_of('.'), lower.size()));
  Graph graph;
  // Streams on the content, without a copy of it.
  using Stream = boost::iostreams::stream<boost::iostreams::array_source>;
  if (ends_with(".edges") || ends_with(".graph") || ends_with(".json") || ends_with(".swc") ||
      ends_with(".polylines.txt") || has_edges(content, ending)) {
    Stream in(content.data(), content.size());
    graph = CSCD::internal::read_indexed_skeleton(in, lower, name);
  }
  if (graph.points.empty() || (ending == ".obj" && has_statement(content, "f "))) {
    Stream in(content.data(), content.size());
    CSCD::Shape_file soup = CSCD::internal::read_polygons_or_points(in, lower, name);
    graph = make_graph(soup, std::move(graph.edges), options.number_of_neighbors);
    Input input = make_input(std::move(graph));
    input.as_read = std::move(soup);
    return input;
  }
  return make_input(std::move(graph));
}

} // namespace cscd
