// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation of the skeleton by the local method: of meshes, of points on the surface made of them, and of scans
// of trees.

#include "other_methods.h"
#include "run_skeletonization.h"
#include "types.h"
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Options.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Reconstructed_surface_traits.h>
#include <CSCD/Tree/extract_tree_skeleton.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/skeletonize.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

CSCD::Options engine_options(const Skeletonize_options& options)
{
  CSCD::Options result;
  result.random_seed = options.seed;
  result.number_of_threads = options.number_of_threads;
  result.detail = options.detail;
  result.node_spacing = options.spacing;
  if (options.maximum_number_of_sources > 0) {
    result.maximum_number_of_sources = options.maximum_number_of_sources;
  }
  result.border_treatment = options.borders == bridged_borders ? CSCD::Border_treatment::bridge
                            : options.borders == open_borders  ? CSCD::Border_treatment::open
                                                               : CSCD::Border_treatment::automatic;
  return result;
}

namespace {

/// Skeletonizes the mesh of `input`.
Skeletonization_result compute_mesh_skeleton(Input& input, const Skeletonize_options& options,
                                             Progress_visitor& visitor)
{
  std::vector<Vector3> points = input.is_kept ? input.points : std::move(input.points);
  std::vector<std::array<Index, 3>> faces = input.is_kept ? input.faces : std::move(input.faces);
  Skeletonization_result result;
  result.report = CSCD::skeletonize(std::move(points), std::move(faces), engine_options(options),
                                    CSCD::Any_skeletonization_visitor(visitor), result.skeleton);
  return result;
}

/// Skeletonizes the points of `input` as a scan of trees.
Skeletonization_result compute_tree_skeleton(const Input& input, const Skeletonize_options& options)
{
  Skeletonization_result result;
  result.tree = CSCD::internal::skeletonize_trees(input.points, root_point(options.root), result.skeleton);
  return result;
}

/// The skeleton of points that may not sample a surface, with the reason in front of the warnings.
Skeletonization_result compute_recognized_tree_skeleton(const Input& input, const Skeletonize_options& options,
                                                        const std::string& reason)
{
  Skeletonization_result result = compute_tree_skeleton(input, options);
  std::vector<std::string>& warnings = result.tree->warnings;
  warnings.insert(warnings.begin(), reason + ": treated as a scan of trees; --shape surface or tree decides");
  return result;
}

/// Skeletonizes the points of `input`, and puts the surface that is made of them into its mesh.
Skeletonization_result compute_point_skeleton(Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  if (options.shape == automatic_shape && CSCD::is_scan_of_trees(input.points)) {
    return compute_recognized_tree_skeleton(input, options, "many points lie along curves, not on a surface");
  }
  try {
    const auto traits = make_traits<CSCD::Reconstructed_surface_traits<Numbers, Point_map>>(input);
    if (options.shape == surface_shape || !traits.is_surface_doubtful()) {
      Skeletonization_result result = run_skeletonization(
          traits, CSCD::Local_policies(CSCD::Detail(options.detail), options.spacing), options, visitor);
      result.is_of_points = true;
      take_surface(traits, input);
      return result;
    }
  } catch (const CSCD::Surface_error&) {
    if (options.shape == surface_shape) {
      throw;
    }
    return compute_recognized_tree_skeleton(input, options, "the points do not sample a surface");
  }
  return compute_recognized_tree_skeleton(input, options, "the points hardly sample the surface of a body");
}

} // namespace

Skeletonization_result compute_skeleton(Input& input, const Skeletonize_options& options,
                                        const Stage_progress& progress)
{
  Progress_visitor visitor(progress);
  visitor.on_stage_begin(CSCD::Skeletonization_stage::compile_surface);
  if (options.wrap) {
    wrap_input(input, *options.wrap);
  }
  if (input.graph || options.method == published_method) {
    Skeletonization_result result;
    compute_other_skeleton(input, options, visitor, result);
    return result;
  }
  if (!input.is_point_set) {
    return compute_mesh_skeleton(input, options, visitor);
  }
  return options.shape == tree_shape ? compute_tree_skeleton(input, options)
                                     : compute_point_skeleton(input, options, visitor);
}

std::vector<CSCD::Vertex_label> labels_of_file(const Input& input, const Skeletonization_result& result)
{
  std::vector<CSCD::Vertex_label> labels =
      CSCD::internal::label_vertices(assigned_surface(input, result.skeleton).node_of_vertex, result.branches);
  if (input.is_point_set) {
    labels.resize(input.number_of_points);
    return labels;
  }
  if (!input.is_wrapped) {
    return CSCD::internal::labels_of_file(input.as_read.points, input.points, labels);
  }
  const CSCD::internal::Point_tree tree(input.points);
  std::vector<CSCD::Vertex_label> labels_of_nearest;
  labels_of_nearest.reserve(input.as_read.points.size());
  for (const Vector3& point : input.as_read.points) {
    labels_of_nearest.push_back(labels[tree.nearest(point)]);
  }
  return labels_of_nearest;
}

CSCD::internal::Assigned_surface assigned_surface(const Input& input, const Skeleton& skeleton)
{
  CSCD::internal::Assigned_surface result{input.points, input.faces, {}};
  result.node_of_vertex.assign(input.points.size(), CSCD::no_index);
  for (Index node = 0; node < skeleton.vertices.size(); ++node) {
    for (const Index vertex : skeleton.vertices[node]) {
      result.node_of_vertex[vertex] = node;
    }
  }
  return result;
}

} // namespace cscd
