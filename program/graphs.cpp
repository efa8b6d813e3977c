// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs that are treated as graphs.

#include "types.h"
#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <locale>
#include <string>
#include <string_view>
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

bool contains(std::string_view content, std::string_view part)
{
  return content.find(part) != std::string_view::npos;
}

/// Whether a line of an OBJ begins with `statement`.
bool has_statement(std::string_view content, const std::string& statement)
{
  return content.substr(0, statement.size()) == statement || contains(content, "\n" + statement);
}

/// Whether `attribute` of a VTP is given and not 0.
bool has_attribute(std::string_view content, const std::string& attribute)
{
  const std::string begin = attribute + "=\"";
  const std::size_t place = content.find(begin);
  return place != std::string_view::npos && content.substr(place + begin.size(), 1) != "0";
}

/// Whether a file of the format `ending` holds faces, or edges, in a format that may hold both.
/// \param statement of OBJ \param element of PLY \param attribute of VTP
bool has_cells(std::string_view content, const std::string& ending, const char* statement, const char* element,
               const char* attribute)
{
  return (ending == ".obj" && has_statement(content, statement)) ||
         (ending == ".ply" && contains(content.substr(0, content.find("end_header")), element)) ||
         (ending == ".vtp" && has_attribute(content, attribute));
}

/// Whether the ending of `filename` is that of a format for graphs alone.
bool is_graph_file(const std::string& filename)
{
  const std::string name = CSCD::without_compression_ending(filename);
  const std::array<const char*, 5> endings{".edges", ".graph", ".json", ".swc", ".polylines.txt"};
  return std::any_of(endings.begin(), endings.end(), [&name](const char* ending) {
    return boost::algorithm::iends_with(name, ending, std::locale::classic());
  });
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

CSCD::Shape_file read_shape(const std::string& content, const std::string& filename, const std::string& name)
{
  const std::string lower =
      CSCD::without_compression_ending(boost::algorithm::to_lower_copy(filename, std::locale::classic()));
  const std::string ending = lower.substr(std::min(lower.find_last_of('.'), lower.size()));
  const bool has_edges = has_cells(content, ending, "l ", "element edge", "NumberOfLines");
  CSCD::Shape_file shape;
  if (!is_graph_file(lower) && (!has_edges || has_cells(content, ending, "f ", "element face", "NumberOfPolys"))) {
    shape = CSCD::internal::read_polygons_or_points(content, lower, name);
    shape.radii.clear();
  }
  if (is_graph_file(lower) || has_edges) {
    Graph graph = CSCD::internal::read_indexed_skeleton(content, lower, name);
    shape.points = std::move(graph.points);
    shape.radii = std::move(graph.radii);
    for (const auto& [a, b] : graph.edges) {
      shape.lines.push_back({a, b});
    }
  }
  return shape;
}

Input read_graph(const Skeletonize_options& options)
{
  const std::string name = name_of(options.input);
  const bool is_standard = options.input == standard_stream;
  if (is_standard && options.format.empty()) {
    throw Usage_error(
        "standard input has no ending: name its format by --format graph, edges, obj, off, ply, stl or xyz");
  }
  const std::string filename = options.format.empty() ? options.input : "." + options.format;
  CSCD::Shape_file shape = read_shape(is_standard ? CSCD::internal::read_content(std::cin, name, filename)
                                                  : CSCD::internal::read_content(options.input),
                                      filename, name);
  // The nodes of a graph without edges are not joined to their neighbors.
  Graph graph = is_graph_file(filename) && shape.lines.empty()
                    ? Graph{shape.points, shape.radii}
                    : make_graph(shape, edges_of(shape), options.number_of_neighbors);
  Input input = make_input(std::move(graph));
  input.as_read = std::move(shape);
  return input;
}

} // namespace cscd
