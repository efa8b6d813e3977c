// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd simplify`, and the treatment of fragments by `cscd skeletonize`.

#include "types.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace cscd {

namespace {

using CSCD::internal::counted;

void check_options(const Simplify_options& options)
{
  check_skeleton_argument(options.skeleton);
  for (const std::string& output : options.outputs) {
    check_skeleton_argument(output);
    check_is_not_input(output, options.skeleton, "--output");
    check_is_not_input(output, options.mesh, "--output");
  }
  check_standard_output(std::count(options.outputs.begin(), options.outputs.end(), standard_stream));
  if (options.mesh == standard_stream && options.skeleton == standard_stream) {
    throw Usage_error("only one of SKELETON and --mesh can be standard input");
  }
}

void write_summary(const Simplify_options& options, const CSCD::Simplification_report& report)
{
  std::cout << printable(options.skeleton) << ": " << counted(report.number_of_removed_nodes, "node") << " pruned, "
            << counted(report.number_of_removed_components, "component") << " removed, "
            << counted(report.number_of_joined_edges, "edge") << " added\nskeleton: " << in_words(report) << '\n';
}

} // namespace

CSCD::Simplification_report simplify_skeleton(const Simplify_options& options, const Input* mesh, Skeleton& skeleton)
{
  try {
    if (mesh == nullptr) {
      return CSCD::internal::simplify_skeleton(skeleton, options.steps, nullptr);
    }
    const CSCD::Triangulated_solid solid(std::vector(mesh->points), std::vector(mesh->faces),
                                         CSCD::Border_treatment::bridge);
    return CSCD::internal::simplify_skeleton(skeleton, options.steps, &solid);
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(options.skeleton + ": " + error.what());
  }
}

void simplify(const Simplify_options& options)
{
  check_options(options);
  std::optional<Input> input;
  if (!options.mesh.empty()) {
    input = read_input(options.mesh, options.format, options.is_quiet);
    if (input->is_point_set) {
      throw CSCD::Input_error(options.mesh + ": has no faces: only a mesh has an inside; leave out --mesh");
    }
  }
  Skeleton skeleton = read_skeleton_argument(options.skeleton);
  if (!skeleton.has_radii() && input) {
    skeleton.radii = CSCD::internal::estimate_radii(input->points, skeleton);
  }
  const CSCD::Simplification_report report = simplify_skeleton(options, input ? &*input : nullptr, skeleton);
  const std::vector<Index> roots = find_roots(skeleton, options.root);
  CSCD::File_group files;
  for (const std::string& output : options.outputs) {
    write_skeleton_output(files, output, skeleton, roots, options.swc);
  }
  files.publish();
  if (!options.is_quiet && std::count(options.outputs.begin(), options.outputs.end(), standard_stream) == 0) {
    write_summary(options, report);
  }
}

void treat_fragments(const CSCD::internal::Simplification_parameters& options, Skeletonization_result& result)
{
  if (options.min_component_size == 0 && !options.joins_components) {
    return;
  }
  const CSCD::Simplification_report report = CSCD::internal::simplify_skeleton(result.skeleton, options, nullptr);
  CSCD::Skeletonization_report& counts = result.report;
  counts.number_of_nodes = report.number_of_nodes;
  counts.number_of_edges = report.number_of_edges;
  counts.number_of_skeleton_components = report.number_of_components;
  counts.betti_number = report.betti_number;
  counts.number_of_tips = report.number_of_tips;
  counts.number_of_junctions = report.number_of_junctions;
  if (report.number_of_removed_components > 0) {
    counts.warnings.push_back(counted(report.number_of_removed_components, "component") + " of less than " +
                              std::to_string(options.min_component_size) + " vertices or points removed: " +
                              std::to_string(report.number_of_removed_vertices) + " of these belong to no node");
  }
  result.fragments = report;
}

} // namespace cscd
