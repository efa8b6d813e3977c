// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd skeletonize`: from arguments to files.

#include "options.h"
#include "types.h"
#include "write_html_page.h"
#include "write_report.h"
#include <CSCD/Application/make_rig.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_rig.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <locale>
#include <numeric>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace cscd {

namespace {

/// Whether a rig is written to `output`, by its ending.
bool is_rig(const std::string& output)
{
  return boost::algorithm::iends_with(output, ".glb");
}

void check_outputs(const Skeletonize_options& options)
{
  std::set<std::filesystem::path> files;
  const auto check = [&](const std::string& file, const std::string& option) {
    check_is_not_input(file, options.input, option);
    if (file != standard_stream && !files.insert(std::filesystem::path(file).lexically_normal()).second) {
      throw Usage_error(option + ": " + file + " is the file of another result; name a file for each");
    }
  };
  for (const std::string& output : options.outputs) {
    if (!is_rig(output) && !is_node_volume(output) && !is_page(output)) {
      check_skeleton_argument(output, " .glb .html");
    }
    check(output, "--output");
  }
  for (const auto& [option, file] : given_files(options)) {
    check(file, option);
  }
  if (std::any_of(options.outputs.begin(), options.outputs.end(), is_page)) {
    check_viewer_source();
  }
}

/// The kinds of input that `options` allow before it is read.
unsigned possible_kinds(const Skeletonize_options& options)
{
  return is_volume(options) ? volume_input : options.domain == graph_domain ? graph_input : mesh_input | point_input;
}

void check_options(const Skeletonize_options& options)
{
  check_applicability(options, possible_kinds(options));
  check_volume_options(options);
  check_outputs(options);
  check_standard_output(number_of_results_on_standard_output(options));
}

std::vector<Vector3> centers(const std::vector<CSCD::Reconstruction_repair>& repairs)
{
  std::vector<Vector3> result;
  result.reserve(repairs.size());
  for (const CSCD::Reconstruction_repair& repair : repairs) {
    result.emplace_back(repair.center[0], repair.center[1], repair.center[2]);
  }
  return result;
}

/// The points and repairs of a point set for the page; nothing for a mesh.
CSCD::Html_page_cloud make_cloud(const Input& input, const Skeletonization_result& result)
{
  CSCD::Html_page_cloud cloud;
  if (result.tree || input.graph || result.report.reconstruction) {
    cloud.number_of_points = input.number_of_points;
  }
  if (result.tree) {
    for (const CSCD::Tree_gap& gap : result.tree->gaps) {
      cloud.joined_gaps.emplace_back((gap.from[0] + gap.to[0]) / 2, (gap.from[1] + gap.to[1]) / 2,
                                     (gap.from[2] + gap.to[2]) / 2);
    }
  } else if (result.report.reconstruction) {
    cloud.cut_handles = centers(result.report.reconstruction->cut_handles);
    cloud.joined_gaps = centers(result.report.reconstruction->joined_gaps);
  }
  return cloud;
}

/// Whether the mesh of `input` is the surface of a body, unlike the mesh of a tree or graph, which has no faces, and
/// the triangles that join points by the published method.
bool bounds_body(const Skeletonization_result& result, const Skeletonize_options& options)
{
  return !result.tree && options.domain.empty() && !(result.is_of_points && options.method == published_method);
}

/// Writes the node that each vertex of the file belongs to, and reports the number of vertices without a node.
void write_labels(CSCD::File_group& files, const Input& input, const Skeletonization_result& result,
                  const Skeletonize_options& options)
{
  if (options.correspondence.empty()) {
    return;
  }
  const std::vector<CSCD::Vertex_label> labels = labels_of_file(input, result);
  const auto number_without_node = std::count_if(
      labels.begin(), labels.end(), [](const CSCD::Vertex_label& label) { return label.node == CSCD::no_index; });
  if (number_without_node > 0 && !options.is_quiet) {
    say(options.input,
        CSCD::internal::counted(std::size_t(number_without_node), input.is_point_set ? "point" : "vertex",
                                input.is_point_set ? "points" : "vertices") +
            " of " + std::to_string(labels.size()) + " in the file without a node");
  }
  write_to(files, options.correspondence, [&](std::ostream& out) { CSCD::write_correspondence(out, labels); });
}

/// \throw CSCD::Input_error if the rig needs the surface of a body, and the input has no such surface
void write_rig(CSCD::File_group& files, const std::string& output, const Input& input,
               const Skeletonization_result& result, const Skeletonize_options& options)
{
  if (!bounds_body(result, options)) {
    throw CSCD::Input_error(name_of(options.input) +
                            ": has no surface that a rig could move; name another format by --output");
  }
  const CSCD::internal::Assigned_surface surface = assigned_surface(input, result.skeleton);
  std::optional<CSCD::Index> root;
  if (!result.roots.empty()) { // one for each component, which the rig joins
    root = *std::max_element(result.roots.begin(), result.roots.end(), [&](CSCD::Index a, CSCD::Index b) {
      return result.skeleton.radii[a] < result.skeleton.radii[b];
    });
  }
  const CSCD::Rig rig = CSCD::internal::make_rig(result.skeleton, surface, root);
  files.write(output, [&](std::ostream& out) {
    CSCD::internal::write_glb(out, surface, rig, std::filesystem::path(name_of(options.input)).stem().string());
  });
}

/// Writes a summary to standard output, unless a result goes there.
void tell_results(const Skeletonization_result& result, const Skeletonize_options& options)
{
  if (number_of_results_on_standard_output(options) == 0) {
    write_summary(std::cout, options, result);
  }
  const auto files = given_files(options);
  const bool is_nothing_written =
      options.outputs.empty() && !result.volume &&
      std::all_of(files.begin(), files.end(), [](const auto& file) { return file.first == "--report"; });
  if (is_nothing_written) {
    say(options.input, "the skeleton is not written; name a file by --output");
  }
}

unsigned kind_of(const Input& input)
{
  return input.graph ? graph_input : input.volume ? volume_input : input.is_point_set ? point_input : mesh_input;
}

/// Refuses options that do not apply to `input`.
void check_options(const Input& input, const Skeletonize_options& options)
{
  check_applicability(options, kind_of(input));
  if (!input.is_point_set && options.shape == tree_shape) {
    throw Usage_error("--shape tree: does not apply to meshes; leave it out");
  }
  if (options.method == published_method && options.shape == tree_shape) {
    throw Usage_error("--method published: does not apply to scans of trees; leave it out");
  }
}

/// Refuses options that do not apply to points after these were recognized as a surface or trees.
void check_options(const Skeletonization_result& result, const Skeletonize_options& options)
{
  if (result.tree && (options.fragments.joins_components || options.fragments.min_component_size > 0)) {
    throw Usage_error((options.fragments.joins_components ? std::string("--join") : std::string("--min-component")) +
                      ": does not apply to scans of trees; leave it out or use cscd simplify");
  }
  if (!options.cylinders.empty() && !result.tree) {
    throw Usage_error("--cylinders: does not apply to surfaces; leave it out or add --shape tree");
  }
}

/// Whether one of the results needs the mesh.
bool needs_mesh(const Skeletonize_options& options)
{
  return !given_files(options).empty() ||
         std::any_of(options.outputs.begin(), options.outputs.end(),
                     [](const std::string& output) { return is_rig(output) || is_page(output); });
}

/// As `read_input()`; if a mesh cannot be repaired, the message names the remaining options.
Input read_for_surface(const Skeletonize_options& options)
{
  try {
    const bool keeps_file = !options.correspondence.empty();
    Input input = read_input(options.input, options.format, options.is_quiet, keeps_file, options.number_of_threads);
    input.is_kept = needs_mesh(options);
    return input;
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(std::string(error.what()) + "; or skeletonize its edges: --as graph");
  }
}

/// A bar on the terminal that fills while a skeletonization runs, and is removed by the destructor.
class Progress_bar
{
public:
  Progress_bar() = default;
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  ~Progress_bar() { show(""); }

  void show(CSCD::Skeletonization_stage stage, double fraction)
  {
    // The parts of the running time that the stages take on a mesh of 50,000 vertices, roughly.
    constexpr std::array<double, CSCD::number_of_skeletonization_stages> share{0.2, 0.6, 0.1, 0.1};
    constexpr std::size_t width = 30; // characters
    const auto index = std::size_t(stage);
    const double done = std::accumulate(share.begin(), share.begin() + std::ptrdiff_t(index), share[index] * fraction);
    const auto filled = std::size_t(double(width) * done);
    show("[" + std::string(filled, '#') + std::string(width - filled, '.') + "] " + std::to_string(int(100 * done)) +
         " % " + CSCD::name(stage));
  }

private:
  void show(const std::string& text)
  {
    if (text != m_text) {
      std::cerr << '\r' << std::string(m_text.size(), ' ') << '\r' << text << std::flush;
      m_text = text;
    }
  }

  std::string m_text; ///< that is on the terminal
};

} // namespace

std::optional<Vector3> root_point(const std::string& root)
{
  std::array<double, 3> coordinates{};
  std::istringstream in(root);
  in.imbue(std::locale::classic());
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    char comma = ',';
    if ((i > 0 && !(in >> comma)) || comma != ',' || !(in >> coordinates[i]) || !std::isfinite(coordinates[i])) {
      return std::nullopt;
    }
  }
  return (in >> std::ws).eof() ? std::optional(Vector3(coordinates[0], coordinates[1], coordinates[2])) : std::nullopt;
}

std::string check_root(const std::string& root)
{
  const bool is_rule = root == thickest_root || root == lowest_root || root == longest_root;
  return is_rule || root_point(root) ? "" : "must be X,Y,Z, thickest, lowest or longest, not " + root;
}

std::vector<Index> find_roots(const Skeleton& skeleton, const std::string& root)
{
  if (root.empty()) {
    return {};
  }
  if (const std::optional<Vector3> point = root_point(root)) {
    return CSCD::internal::find_roots(skeleton, *point);
  }
  return CSCD::internal::find_roots(skeleton, root == thickest_root ? CSCD::Root_rule::thickest
                                              : root == lowest_root ? CSCD::Root_rule::lowest
                                                                    : CSCD::Root_rule::longest);
}

void write_skeleton_output(CSCD::File_group& files, const std::string& output, const Skeleton& skeleton,
                           const std::vector<Index>& roots, CSCD::Swc_options swc)
{
  if (output == standard_stream) {
    CSCD::write_gel_graph(std::cout, skeleton);
  } else if (boost::algorithm::iends_with(output, ".swc")) {
    swc.roots = roots;
    files.write(output, [&](std::ostream& out) { CSCD::write_swc(out, skeleton, swc); });
  } else {
    files.write(output, [&](std::ostream& out) { CSCD::write_skeleton(out, output, skeleton); });
  }
}

void measure_branches(const Input& input, const Skeletonize_options& options, Skeletonization_result& result)
{
  result.roots = find_roots(result.skeleton, options.root);
  if (result.tree && (result.roots.empty() || root_point(options.root))) {
    result.roots = {0}; // the first node of each object is its root
  }
  result.branches = CSCD::internal::measure_branches(result.skeleton, result.roots);
  if (result.tree) {
    CSCD::assign_limbs(*result.tree, result.branches);
    result.trees = CSCD::internal::measure_trees(result.skeleton, *result.tree, options.breast_height);
  } else if (bounds_body(result, options) && !(options.branches.empty() && options.report.empty())) {
    CSCD::internal::measure_surface_parts(result.skeleton, assigned_surface(input, result.skeleton), result.branches);
  }
}

void write_results(CSCD::File_group& files, const Input& input, const Skeletonization_result& result,
                   const Skeletonize_options& options)
{
  for (const std::string& output : options.outputs) {
    if (is_page(output)) {
      files.write(output, [&](std::ostream& out) {
        write_page(out, input, result, std::filesystem::path(name_of(options.input)).filename().string());
      });
    } else if (is_rig(output)) {
      write_rig(files, output, input, result, options);
    } else {
      write_skeleton_output(files, output, result.skeleton, result.roots, options.swc);
    }
  }
  write_to(files, options.branches, [&](std::ostream& out) { CSCD::write_branch_table(out, result.branches); });
  write_to(files, options.nodes, [&](std::ostream& out) {
    const std::vector<CSCD::Node_measures> measures =
        bounds_body(result, options)
            ? CSCD::internal::measure_nodes(result.skeleton, assigned_surface(input, result.skeleton))
            : std::vector<CSCD::Node_measures>();
    CSCD::write_node_table(out, result.skeleton, result.branches, measures);
  });
  write_to(files, options.cylinders, [&](std::ostream& out) {
    CSCD::write_cylinders(out, CSCD::internal::make_tree_cylinders(result.skeleton, *result.tree), *result.tree);
  });
  write_labels(files, input, result, options);
  write_to(files, options.report,
           [&](std::ostream& out) { write_report(out, options, input.repairs.sentences(), result); });
}

void check_skeleton_argument(const std::string& filename, const std::string& other_endings)
{
  if (filename != standard_stream) {
    try {
      CSCD::check_skeleton_filename(filename);
    } catch (const CSCD::File_error& error) {
      throw Usage_error(error.what() + other_endings);
    }
  }
}

void check_is_not_input(const std::string& output, const std::string& input, const std::string& option)
{
  std::error_code error;
  if (output != standard_stream && input != standard_stream && std::filesystem::equivalent(output, input, error) &&
      std::filesystem::is_regular_file(output, error)) {
    throw Usage_error(option + " " + output + ": is the input, which would be lost; name another file");
  }
}

Skeletonization_result skeletonize_input(Input& input, const Skeletonize_options& options,
                                         const Stage_progress& progress)
{
  check_options(input, options);
  Skeletonization_result result;
  try {
    result = compute_skeleton(input, options, progress);
    result.has_normals = !input.normals.empty();
    result.volume = input.volume;
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(name_of(options.input) + ": " + error.what());
  }
  check_options(result, options);
  treat_fragments(options.fragments, result);
  measure_branches(input, options, result);
  return result;
}

void check_viewer_source()
{
  if (!CSCD::has_three_js()) {
    throw Usage_error("pages: this was built without three.js; install libjs-three and build it again");
  }
}

bool is_page(const std::string& output)
{
  return boost::algorithm::iends_with(output, ".html");
}

void write_page(std::ostream& out, const Input& input, const Skeletonization_result& result, const std::string& name)
{
  check_viewer_source();
  CSCD::internal::write_html_page(
      out, {assigned_surface(input, result.skeleton), result.skeleton, make_cloud(input, result)},
      result.tree ? name + ", treated as a scan of trees" : name);
}

Skeletonization_result skeletonize_with_progress(Input& input, const Skeletonize_options& options)
{
  if (options.is_quiet || isatty(STDERR_FILENO) == 0) {
    return skeletonize_input(input, options, nullptr);
  }
  Progress_bar bar;
  return skeletonize_input(input, options,
                           [&bar](CSCD::Skeletonization_stage stage, double fraction) { bar.show(stage, fraction); });
}

void tell_and_write(CSCD::File_group& files, const Input& input, const Skeletonization_result& result,
                    const Skeletonize_options& options)
{
  if (!options.is_quiet) {
    const std::string label = result.volume ? "label " + std::to_string(result.volume->label) + ": " : "";
    for (const std::string& warning : result.warnings()) {
      say(options.input, label + warning);
    }
  }
  write_results(files, input, result, options);
  if (!options.is_quiet) {
    tell_results(result, options);
  }
}

void skeletonize(const Skeletonize_options& options)
{
  check_options(options);
  CSCD::File_group files;
  if (is_volume(options)) {
    skeletonize_volume(files, options);
  } else {
    Input input = options.domain == graph_domain ? read_graph(options) : read_for_surface(options);
    tell_and_write(files, input, skeletonize_with_progress(input, options), options);
  }
  files.publish();
}

} // namespace cscd
