// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd loops`: from arguments to files.

#include "commands.h"
#include "compute_skeleton.h"
#include "types.h"
#include "write_with_report.h"
#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/exceptions.h>
#include <CSCD/version.h>

#include <boost/math/constants/constants.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

namespace cscd {

namespace {

using Loops = std::vector<CSCD::Surface_loop<Point>>;

bool is_json(const std::string& filename)
{
  return filename == standard_stream || std::filesystem::path(filename).extension() == ".json";
}

bool is_wanted(const Loops_options& options, CSCD::Loop_kind kind)
{
  const std::array<bool, 3> chosen{options.handles, options.tunnels, options.constrictions};
  return chosen == std::array<bool, 3>{} || chosen[static_cast<std::size_t>(kind)];
}

Loops find_loops(const Loops_options& options, const Input& input)
{
  try {
    Loops loops = CSCD::find_surface_loops(input.mesh, CSCD::parameters::default_values(), options.min_depth);
    loops.erase(
        std::remove_if(loops.begin(), loops.end(), [&](const auto& loop) { return !is_wanted(options, loop.kind); }),
        loops.end());
    return loops;
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(name_of(options.input) + ": " + error.what());
  }
}

/// Kind, length and, of a constriction, depth.
nlohmann::ordered_json to_json(const CSCD::Surface_loop<Point>& loop)
{
  constexpr std::array<const char*, 3> names{"handle", "tunnel", "constriction"};
  nlohmann::ordered_json object{{"kind", names[static_cast<std::size_t>(loop.kind)]}, {"length", loop.length}};
  if (loop.kind == CSCD::Loop_kind::constriction) {
    object["depth"] = loop.depth;
  }
  return object;
}

/// The report, without the points of the loops.
nlohmann::ordered_json report_document(const Loops_options& options, const Input& input, const Loops& loops)
{
  std::array<std::size_t, 3> numbers{};
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CSCD::Surface_loop<Point>& loop : loops) {
    ++numbers[static_cast<std::size_t>(loop.kind)];
    list.push_back(to_json(loop));
  }
  return {{"version", CSCD_VERSION},
          {"input", options.input},
          {"repairs", input.repairs.sentences()},
          {"min_depth", options.min_depth},
          {"number_of_handles", numbers[0]},
          {"number_of_tunnels", numbers[1]},
          {"number_of_constrictions", numbers[2]},
          {"loops", std::move(list)}};
}

void write_loops_as_json(std::ostream& out, const Loops& loops)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CSCD::Surface_loop<Point>& loop : loops) {
    nlohmann::ordered_json object = to_json(loop);
    for (const Point& point : loop.points) {
      object["points"].push_back({point.x(), point.y(), point.z()});
    }
    list.push_back(std::move(object));
  }
  out << list.dump() << '\n';
}

/// The viewer page of the mesh, with the loops in the place of the separators of its skeleton.
void write_loops_as_page(std::ostream& out, const std::string& name, Input& input, const Loops& loops)
{
  Skeletonization_result result = compute_skeleton(input, Skeletonize_options(), nullptr);
  result.separators.clear();
  result.separators.reserve(loops.size());
  for (const CSCD::Surface_loop<Point>& loop : loops) {
    result.separators.push_back(loop.points);
  }
  write_page(out, input, result, std::filesystem::path(name).filename().string() + ": loops as separators");
}

/// The loops as cycles of a graph, which every format of skeletons can hold; the radius of a node is that of a circle
/// as long as its loop.
Skeleton to_graph(const Loops& loops)
{
  Skeleton graph;
  for (const CSCD::Surface_loop<Point>& loop : loops) {
    const auto first = num_vertices(graph);
    for (const Point& point : loop.points) {
      const auto node = add_vertex(graph);
      graph[node].point = point;
      graph[node].radius = loop.length / (2 * boost::math::double_constants::pi);
    }
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      add_edge(first + i, first + (i + 1) % loop.points.size(), graph);
    }
  }
  return graph;
}

} // namespace

void write_loops(const Loops_options& options)
{
  check_files(options);
  if (is_page(options.output)) {
    check_viewer_source("--output");
  } else {
    check_skeleton_outputs({options.output}, options.input, " .html");
  }
  Input input = read_mesh(options.input, options.format, options.is_quiet);
  const Loops loops = find_loops(options, input);
  const auto write = [&](std::ostream& out) {
    if (is_json(options.output)) {
      write_loops_as_json(out, loops);
    } else if (is_page(options.output)) {
      write_loops_as_page(out, name_of(options.input), input, loops);
    } else {
      CSCD::write_skeleton(out, options.output, to_graph(loops));
    }
  };
  write_with_report(options, write, [&] { return report_document(options, input, loops); });
  if (!options.is_quiet && options.output != standard_stream) {
    std::cout << options.output << ": " << CSCD::internal::counted(loops.size(), "loop", "loops") << '\n';
  }
}

} // namespace cscd
