// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs from files and from standard input: meshes, points, and graphs.

#include "types.h"
#include "write_report.h"
#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

std::string name_of(const std::string& input)
{
  return input == standard_stream ? "standard input" : input;
}

void say(const std::string& input, const std::string& sentence)
{
  std::cerr << "cscd: " << printable(name_of(input)) << ": " << sentence << '\n';
}

CSCD::Shape_file read_file(const std::string& name, const std::string& format, unsigned contents)
{
  if (name != standard_stream) {
    std::ifstream file = CSCD::internal::open_file(name);
    return CSCD::internal::read_shape(file, format.empty() ? name : "." + format, name, contents);
  }
  if (format.empty()) {
    throw Usage_error(
        "standard input has no ending: name its format by --format, such as off, obj, ply, stl, glb, vtp, "
        "graph, xyz or pcd");
  }
  return CSCD::internal::read_shape(std::cin, "." + format, name_of(name), contents);
}

Input make_input(CSCD::Indexed_triangles&& triangles)
{
  Input input;
  input.points = std::move(triangles.points);
  input.faces = std::move(triangles.faces);
  for (std::array<Index, 3>& face : input.faces) {
    std::rotate(face.begin(), face.begin() + 1, face.end()); // as CGAL's meshes number the corners of their faces
  }
  return input;
}

Input to_input(CSCD::Shape_file&& soup, const std::string& name, bool is_quiet, bool keeps_file,
               unsigned number_of_threads)
{
  Input input;
  CSCD::Shape_file as_read = keeps_file ? soup : CSCD::Shape_file();
  std::vector<Vector3> places_in_file;
  const bool has_other_columns = soup.number_of_polygons() == 0 && soup.has_other_columns;
  if (soup.number_of_polygons() == 0) {
    input.is_point_set = true;
    input.number_of_points = soup.points.size();
    input.points = std::move(soup.points);
    input.normals = std::move(soup.normals);
  } else {
    CSCD::internal::Manifold_triangles manifold =
        CSCD::internal::make_manifold(std::move(soup), name_of(name), number_of_threads);
    input = make_input(std::move(manifold.triangles));
    input.repairs = manifold.report;
    places_in_file = std::move(manifold.places_in_file);
  }
  input.as_read = std::move(as_read);
  if (!places_in_file.empty()) {
    input.as_read.points = std::move(places_in_file);
  }
  if (!is_quiet) {
    for (const std::string& sentence : input.repairs.sentences()) {
      say(name, sentence);
    }
    if (has_other_columns) {
      say(name, "three numbers behind the coordinates are not normals, but colors or the like: ignored");
    }
  }
  return input;
}

Input read_input(const std::string& name, const std::string& format, bool is_quiet, bool keeps_file,
                 unsigned number_of_threads)
{
  constexpr unsigned contents = CSCD::internal::mesh_content | CSCD::internal::point_content;
  return to_input(read_file(name, format, contents), name, is_quiet, keeps_file, number_of_threads);
}

Input read_mesh(const std::string& name, const std::string& format, bool is_quiet, bool keeps_file)
{
  Input input = read_input(name, format, is_quiet, keeps_file);
  if (input.is_point_set) {
    throw CSCD::Input_error(name_of(name) + ": has no faces; name a mesh");
  }
  return input;
}

namespace {

/// Adds the sides of the polygons of `soup`, each once.
void add_sides(const CSCD::Shape_file& soup, Skeleton& graph)
{
  std::vector<std::array<Index, 2>> sides;
  sides.reserve(soup.corners.size());
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    const std::size_t begin = soup.first_corner[polygon];
    const std::size_t end = soup.first_corner[polygon + 1];
    for (std::size_t i = begin; i < end; ++i) {
      const auto [a, b] = std::minmax(soup.corners[i], soup.corners[i + 1 < end ? i + 1 : begin]);
      sides.push_back({a, b});
    }
  }
  std::sort(sides.begin(), sides.end());
  graph.edges.insert(graph.edges.end(), sides.begin(), std::unique(sides.begin(), sides.end()));
}

} // namespace

Skeleton make_graph(const CSCD::Shape_file& soup, unsigned int number_of_neighbors)
{
  Skeleton graph{soup.points, soup.radii};
  for (const auto& [a, b] : soup.lines) {
    graph.edges.push_back({Index(a), Index(b)});
  }
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
  // The nodes of a graph without edges are not joined to their neighbors.
  return make_input(CSCD::internal::is_graph_filename(filename) && shape.lines.empty()
                        ? Skeleton{shape.points, shape.radii}
                        : make_graph(shape, options.number_of_neighbors));
}

} // namespace cscd
