// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method and the method for graphs.

#include "other_methods.h"

#include "run_skeletonization.h"
#include "types.h"
#include <CSCD/Graph_policies.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/Traits/Spatial_graph_traits.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector3.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace cscd {

const bool has_all_methods = true;

namespace {

/// A skeleton whose nodes hold numbers of points.
using Number_graph = CSCD::Skeleton_graph<Vector3, std::size_t>;

CSCD::Published_policies published_policies(const Skeletonize_options& options, bool is_of_points)
{
  CSCD::Field_search_settings settings;
  if (options.is_literal) {
    settings = CSCD::Field_search_settings::literal();
  }
  if (is_of_points) {
    settings.overlap_rule = CSCD::Overlap_rule::nearest_vertex;
  }
  return CSCD::Published_policies(settings);
}

/// Skeletonizes the mesh of `input` by the published method.
Skeletonization_result compute_published_mesh_skeleton(const Input& input, const Skeletonize_options& options,
                                                       Progress_visitor& visitor)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>; // never made
  CSCD::Indexed_triangles triangles{input.points, input.faces, input.faces.size()};
  CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size(), options.number_of_threads);
  const CSCD::Triangle_mesh_traits<Mesh> traits(std::move(triangles), std::move(pairing),
                                                engine_options(options).border_treatment, options.number_of_threads);
  return run_skeletonization(traits, published_policies(options, false), options, visitor);
}

/// Skeletonizes the graph of `input`.
Skeletonization_result compute_graph_skeleton(const Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  Skeleton skeleton = *input.graph; // is a graph with positions, too
  skeleton.radii.resize(skeleton.number_of_nodes(), 0);
  skeleton.significance.resize(skeleton.edges.size(), 0);
  const auto graph = CSCD::internal::make_skeleton_graph<Number_graph>(skeleton, std::vector<std::size_t>());
  const CSCD::Spatial_graph_traits traits(graph, CSCD::internal::bundled_point_map(graph));
  Skeletonization_result result = run_skeletonization(traits, CSCD::Graph_policies(), options, visitor);
  result.skeleton.separators.clear(); // sets of vertices, no curves
  return result;
}

/// Skeletonizes the points of `input` as published, and puts the triangles that join them into its mesh.
Skeletonization_result compute_published_point_skeleton(Input& input, const Skeletonize_options& options,
                                                        Progress_visitor& visitor)
{
  const auto traits = make_traits<CSCD::Point_set_traits<Numbers, Point_map>>(input);
  Skeletonization_result result = run_skeletonization(traits, published_policies(options, true), options, visitor);
  result.is_of_points = true;
  take_surface(traits, input);
  return result;
}

} // namespace

void compute_other_skeleton(Input& input, const Skeletonize_options& options, Progress_visitor& visitor,
                            Skeletonization_result& result)
{
  result = input.graph          ? compute_graph_skeleton(input, options, visitor)
           : input.is_point_set ? compute_published_point_skeleton(input, options, visitor)
                                : compute_published_mesh_skeleton(input, options, visitor);
}

} // namespace cscd
