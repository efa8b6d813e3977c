// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `cscd segment`, `cscd diameter` and `cscd loops`: from arguments to files.

#include "types.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

/// A mesh, its skeleton, and the node of each vertex.
struct Skeletonized_input
{
  Input input;
  Skeletonization_result result;
  CSCD::internal::Skeletonized_surface surface;
};

Skeletonized_input skeletonized_input(const Application_options& options)
{
  check_is_not_input(options.output, options.input, "--output");
  Skeletonize_options settings;
  settings.input = options.input;
  constexpr bool keeps_file = true; // the output follows the order of the file
  Skeletonized_input result;
  result.input = read_mesh(options.input, options.format, options.is_quiet, keeps_file);
  result.result = skeletonize_input(result.input, settings, nullptr);
  result.surface = CSCD::internal::make_skeletonized_surface(assigned_surface(result.input, result.result.skeleton),
                                                             result.result.skeleton);
  return result;
}

/// Writes the output by `write(out)`.
template <class Write>
void write_output(const std::string& filename, const Write& write)
{
  CSCD::File_group files;
  write_to(files, filename, write);
  files.publish();
}

/// For each polygon of the file, the face of the mesh that stands for it. They have the same numbers unless faces were
/// cut or removed.
std::vector<Index> faces_of_polygons(const Input& input)
{
  if (input.repairs.number_of_triangulated_polygons == 0 && input.repairs.number_of_removed_faces == 0) {
    std::vector<Index> result(input.faces.size());
    std::iota(result.begin(), result.end(), Index(0));
    return result;
  }
  return CSCD::internal::faces_of_polygons(input.as_read, input.points, input.faces);
}

} // namespace

void segment(const Segment_options& options)
{
  const Skeletonized_input input = skeletonized_input(options);
  const std::vector<Index> parts = CSCD::internal::segment_surface(input.surface, options.number_of_parts);
  write_output(options.output, [&](std::ostream& out) {
    for (const Index face : faces_of_polygons(input.input)) {
      out << (face == CSCD::no_index ? 0 : parts[face]) << '\n';
    }
  });
  if (!options.is_quiet && options.output != standard_stream) {
    std::cout << options.output << ": " << *std::max_element(parts.begin(), parts.end()) + 1 << " parts\n";
  }
}

void write_diameters(const Application_options& options)
{
  const Skeletonized_input input = skeletonized_input(options);
  const std::vector<double> diameters = CSCD::internal::shape_diameters(
      input.surface, input.input.points.size(), CSCD::default_number_of_diameter_smoothing_steps);
  std::vector<char> is_known;
  for (const double diameter : diameters) {
    is_known.push_back(diameter > 0 ? 1 : 0);
  }
  write_output(options.output, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    for (const Index vertex :
         CSCD::internal::vertices_of_file(input.input.as_read.points, input.input.points, is_known)) {
      out << (vertex != CSCD::no_index ? diameters[vertex] : 0.) << '\n';
    }
  });
}

namespace {

using Loops = std::vector<CSCD::Surface_loop<Vector3>>;

bool is_json(const std::string& filename)
{
  return filename == standard_stream || std::filesystem::path(filename).extension() == ".json";
}

Loops find_loops(const Loops_options& options, const Input& input)
{
  try {
    constexpr unsigned random_seed = 0;
    return CSCD::internal::find_surface_loops(input.points, input.faces, random_seed, options.min_depth);
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(name_of(options.input) + ": " + error.what());
  }
}

void write_loops_as_json(std::ostream& out, const Loops& loops)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CSCD::Surface_loop<Vector3>& loop : loops) {
    nlohmann::ordered_json object{{"kind", name(loop.kind)}, {"length", loop.length}};
    if (loop.kind == CSCD::Loop_kind::constriction) {
      object["depth"] = loop.depth;
    }
    object["points"] = loop.points;
    list.push_back(std::move(object));
  }
  out << list.dump() << '\n';
}

/// The viewer page of the mesh, with the loops in the place of the separators of its skeleton.
void write_loops_as_page(std::ostream& out, const std::string& name, Input& input, const Loops& loops)
{
  Skeletonization_result result = compute_skeleton(input, Skeletonize_options(), nullptr);
  result.skeleton.separators.clear();
  for (const CSCD::Surface_loop<Vector3>& loop : loops) {
    result.skeleton.separators.push_back(loop.points);
  }
  write_page(out, input, result, std::filesystem::path(name).filename().string() + ": loops as separators");
}

/// The loops as cycles of a graph, which every format of skeletons can hold; the radius of a node is that of a circle
/// as long as its loop.
Skeleton to_graph(const Loops& loops)
{
  Skeleton graph;
  for (const CSCD::Surface_loop<Vector3>& loop : loops) {
    const auto first = Index(graph.number_of_nodes());
    const auto size = Index(loop.points.size());
    graph.points.insert(graph.points.end(), loop.points.begin(), loop.points.end());
    graph.radii.resize(graph.points.size(), loop.length / (2 * boost::math::double_constants::pi));
    for (Index i = 0; i < size; ++i) {
      graph.edges.push_back({first + i, first + (i + 1) % size});
    }
  }
  return graph;
}

} // namespace

void write_loops(const Loops_options& options)
{
  check_is_not_input(options.output, options.input, "--output");
  if (is_page(options.output)) {
    check_viewer_source();
  } else {
    check_skeleton_argument(options.output, " .html");
  }
  Input input = read_mesh(options.input, options.format, options.is_quiet);
  const Loops loops = find_loops(options, input);
  write_output(options.output, [&](std::ostream& out) {
    if (is_json(options.output)) {
      write_loops_as_json(out, loops);
    } else if (is_page(options.output)) {
      write_loops_as_page(out, name_of(options.input), input, loops);
    } else {
      CSCD::write_skeleton(out, options.output, to_graph(loops));
    }
  });
  if (!options.is_quiet && options.output != standard_stream) {
    std::cout << options.output << ": " << CSCD::internal::counted(loops.size(), "loop", "loops") << '\n';
  }
}

} // namespace cscd
