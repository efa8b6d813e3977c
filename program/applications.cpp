// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `cscd segment`, `cscd diameter` and `cscd loops`: from arguments to files.

#include "commands.h"
#include "compute_skeleton.h"
#include "types.h"
#include "write_report.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/version.h>

#include <CGAL/mesh_segmentation.h>

#include <boost/math/constants/constants.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

/// Refuses files that are the input, and two results on standard output.
/// \throw Usage_error
void check_files(const Application_options& options)
{
  check_is_not_input(options.output, options.input, "--output");
  check_is_not_input(options.report, options.input, "--report");
  check_standard_output((options.output == standard_stream ? 1 : 0) + (options.report == standard_stream ? 1 : 0));
}

/// Writes the result by `write(out)`, and the report if requested.
/// \param document makes the report
template <class Write, class MakeDocument>
void write_with_report(const Application_options& options, const Write& write, const MakeDocument& document)
{
  CSCD::File_group files;
  write_to(files, options.output, write);
  if (!options.report.empty()) {
    write_to(files, options.report, [&](std::ostream& out) { out << dump_json(document()) << '\n'; });
  }
  files.publish();
}

/// A mesh, its skeleton, and the report of the computation.
struct Skeletonized_input
{
  Skeletonize_options options;
  Input input;
  Skeletonization_result result;

  Mesh& mesh() { return input.mesh; }
  const Skeleton& skeleton() const { return result.skeleton; }

  /// The report of the skeleton and of its application.
  nlohmann::ordered_json document(const std::string& name, nlohmann::ordered_json part) const
  {
    nlohmann::ordered_json all = report_document(options, input.repairs.sentences(), result);
    all[name] = std::move(part);
    return all;
  }
};

Skeletonized_input skeletonized_input(const Application_options& options)
{
  check_files(options);
  Skeletonized_input result;
  result.options.input = options.input;
  constexpr bool keeps_file = true; // the output follows the order of the file
  result.input = read_mesh(options.input, options.format, options.is_quiet, keeps_file);
  result.result = skeletonize_input(result.input, result.options, nullptr);
  return result;
}

/// CGAL's segmentation of shape diameters, with CGAL's default number of clusters. Its default of the weight of short
/// boundaries, 0.26, is for noisier diameters, found by rays: with ours, most bodies stay in one part.
constexpr std::size_t number_of_clusters = 5;
constexpr double smoothness = 0.1;

/// CGAL's segmentation, by the shape diameters of the faces. \return the number of parts
template <class FaceLabelMap>
std::size_t segment_by_diameter(Skeletonized_input& input, FaceLabelMap labels)
{
  const auto diameters = input.mesh().add_property_map<Mesh::Face_index, double>("f:diameter").first;
  CSCD::estimate_face_shape_diameters(input.mesh(), input.skeleton(), diameters);
  CGAL::sdf_values_postprocessing(input.mesh(), diameters);
  return CGAL::segmentation_from_sdf_values(input.mesh(), diameters, labels, number_of_clusters, smoothness);
}

using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;

/// The faces of the mesh and the faces of the file that they come from. They have the same numbers unless faces were
/// cut or removed.
CSCD::internal::Faces_of_file faces_of_file(const Input& input)
{
  CSCD::internal::Faces_of_file result;
  if (input.repairs.number_of_triangulated_polygons == 0 && input.repairs.number_of_removed_faces == 0) {
    result.polygon_of_face.resize(input.mesh.number_of_faces());
    std::iota(result.polygon_of_face.begin(), result.polygon_of_face.end(), CSCD::Index(0));
    result.face_of_polygon = result.polygon_of_face;
    return result;
  }
  std::vector<std::array<CSCD::Index, 3>> faces;
  for (const Mesh::Face_index face : input.mesh.faces()) {
    const auto h = input.mesh.halfedge(face);
    faces.push_back({source(h, input.mesh), target(h, input.mesh), target(next(h, input.mesh), input.mesh)});
  }
  return CSCD::internal::match_faces(input.as_read, CSCD::internal::to_vectors(input.mesh.points()), faces);
}

/// Checks options that exclude each other.
void check(const Segment_options& options)
{
  if (options.by == by_diameter && options.number_of_parts > 0) {
    throw Usage_error("--parts: only a segmentation by the skeleton has a choice of parts; leave out --by diameter");
  }
}

/// The parts of a mesh: their numbers of faces and their areas.
nlohmann::ordered_json parts_document(const Segment_options& options, const Mesh& mesh, Labels labels)
{
  std::map<std::size_t, std::pair<std::size_t, double>> parts;
  for (const Mesh::Face_index face : mesh.faces()) {
    auto& [number, area] = parts[labels[face]];
    const auto h = mesh.halfedge(face);
    ++number;
    area += std::sqrt(CGAL::squared_area(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                         mesh.point(target(next(h, mesh), mesh))));
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [label, part] : parts) {
    list.push_back({{"label", label}, {"number_of_faces", part.first}, {"area", part.second}});
  }
  nlohmann::ordered_json result{{"by", options.by}, {"number_of_parts", parts.size()}};
  result["parts"] = std::move(list);
  return result;
}

/// Statistics of the shape diameters at vertices with a face.
nlohmann::ordered_json diameters_document(std::vector<double> values)
{
  values.erase(std::remove(values.begin(), values.end(), 0.), values.end());
  std::sort(values.begin(), values.end());
  if (values.empty()) {
    return nlohmann::ordered_json::object();
  }
  return {{"minimum", values.front()},
          {"median", values[values.size() / 2]},
          {"mean", std::accumulate(values.begin(), values.end(), 0.) / double(values.size())},
          {"maximum", values.back()}};
}

} // namespace

void segment(const Segment_options& options)
{
  check(options);
  Skeletonized_input input = skeletonized_input(options);
  const Labels labels = input.mesh().add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  const std::size_t number_of_parts =
      options.by == by_diameter ? segment_by_diameter(input, labels)
                                : CSCD::segment_mesh(input.mesh(), input.skeleton(), labels,
                                                     CSCD::parameters::default_values(), options.number_of_parts);
  write_with_report(
      options,
      [&](std::ostream& out) {
        for (const CSCD::Index face : faces_of_file(input.input).face_of_polygon) {
          out << (face == CSCD::no_index ? 0 : labels[Mesh::Face_index(face)]) << '\n';
        }
      },
      [&] { return input.document("segmentation", parts_document(options, input.mesh(), labels)); });
  if (!options.is_quiet && options.output != standard_stream) {
    std::cout << options.output << ": " << number_of_parts << " parts\n";
  }
}

void write_diameters(const Application_options& options)
{
  Skeletonized_input input = skeletonized_input(options);
  const auto diameters = input.mesh().add_property_map<Mesh::Vertex_index, double>("v:diameter").first;
  CSCD::estimate_vertex_shape_diameters(input.mesh(), input.skeleton(), diameters);
  write_with_report(
      options,
      [&](std::ostream& out) {
        out.precision(std::numeric_limits<double>::max_digits10);
        std::vector<char> is_known;
        for (const double diameter : diameters) {
          is_known.push_back(diameter > 0 ? 1 : 0);
        }
        for (const CSCD::Index vertex : CSCD::internal::vertices_of_file(
                 input.input.as_read.points, CSCD::internal::to_vectors(input.mesh().points()), is_known)) {
          out << (vertex != CSCD::no_index ? diameters[Mesh::Vertex_index(vertex)] : 0.) << '\n';
        }
      },
      [&] {
        return input.document("diameters", diameters_document({diameters.begin(), diameters.end()}));
      });
}

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
