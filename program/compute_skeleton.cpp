// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation of the skeleton: of meshes, of points on the surface made of them or by their neighborhoods, and of
// scans of trees.

#include "Progress_bar.h"
#include "types.h"
#include "wrap.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Graph_policies.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Options.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/Traits/Reconstructed_surface_traits.h>
#include <CSCD/Traits/Spatial_graph_traits.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Tree/extract_tree_skeleton.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>
#include <CSCD/skeletonize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

using Numbers = std::vector<std::size_t>;
using Point_map = CGAL::Pointer_property_map<Vector3>::const_type;
/// A skeleton whose nodes hold numbers of points.
using Number_graph = CSCD::Skeleton_graph<Vector3, std::size_t>;

/// Makes surface traits of the numbered points of `input`, and of the normals if there are any.
template <class Traits>
Traits make_traits(const Input& input)
{
  Numbers numbers(input.number_of_points);
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  const Point_map point_map = CGAL::make_property_map(input.points);
  return input.normals.empty() ? Traits(numbers, point_map)
                               : Traits(numbers, point_map, Point_map(CGAL::make_property_map(input.normals)));
}

/// Takes over the surface of `traits`, which were made of the points of `input`: its vertices are the points, and
/// inserted ones behind them.
template <class Traits>
void take_surface(const Traits& traits, Input& input)
{
  const auto& triangulation = traits.surface().triangulation();
  std::vector<Index> place_of_vertex;
  for (Index vertex = 0; vertex < triangulation.number_of_vertices(); ++vertex) {
    const auto numbers = traits.descriptors(vertex);
    const Vector3 place = traits.to_input_point(triangulation.point(vertex));
    const auto nearest = std::min_element(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
      return (input.points[a] - place).squaredNorm() < (input.points[b] - place).squaredNorm();
    });
    place_of_vertex.push_back(Index(nearest == numbers.end() ? input.points.size() : *nearest));
    if (nearest == numbers.end()) {
      input.points.push_back(place);
    }
  }
  for (Index face = 0; face < triangulation.number_of_faces(); ++face) {
    const auto [a, b, c] = triangulation.face_halfedges(face);
    input.faces.push_back({place_of_vertex[triangulation.origin(a)], place_of_vertex[triangulation.origin(b)],
                           place_of_vertex[triangulation.origin(c)]});
  }
}

/// The plain skeleton of a graph whose nodes hold numbers of vertices or points of the input.
template <class Graph>
Skeleton to_plain(const Graph& graph)
{
  Skeleton result = CSCD::internal::index_skeleton(graph);
  for (const auto node : boost::make_iterator_range(vertices(graph))) {
    result.vertices.emplace_back();
    for (const auto number : graph[node].vertices) {
      result.vertices.back().push_back(Index(number));
    }
  }
  for (const auto edge : boost::make_iterator_range(edges(graph))) {
    result.significance.push_back(graph[edge].significance);
  }
  return result;
}

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

/// Skeletonizes the surface of `traits` by the algorithms of `policies`.
template <class Traits, class Policies>
Skeletonization_result run_skeletonization(const Traits& traits, const Policies& policies,
                                           const Skeletonize_options& options, Progress_visitor& visitor)
{
  CSCD::Curve_skeletonization<Traits, Policies, Progress_visitor&> skeletonization(traits, policies, visitor);
  const CSCD::Options settings = engine_options(options);
  skeletonization.set_random_seed(settings.random_seed)
      .set_number_of_threads(settings.number_of_threads)
      .set_maximum_number_of_sources(settings.maximum_number_of_sources);
  typename decltype(skeletonization)::Skeleton graph;
  Skeletonization_result result;
  result.report = skeletonization.template run<CGAL::Parallel_if_available_tag>(graph);
  result.skeleton = to_plain(graph);
  for (auto separator : skeletonization.packed_separators()) {
    result.skeleton.separators.push_back(
        CSCD::internal::to_vectors(skeletonization.polyline(skeletonization.separators()[separator])));
  }
  return result;
}

/// As `run_skeletonization()` with the policies of other than the local method. The page that computes omits them to
/// stay small.
template <class Traits, class Policies>
Skeletonization_result
run_other_method([[maybe_unused]] const Traits& traits, [[maybe_unused]] const Policies& policies,
                 [[maybe_unused]] const Skeletonize_options& options, [[maybe_unused]] Progress_visitor& visitor)
{
#ifdef CSCD_LOCAL_METHOD_ONLY
  throw Usage_error("--method, --as: only the local method is built into this");
#else
  return run_skeletonization(traits, policies, options, visitor);
#endif
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
  return run_other_method(traits, published_policies(options, false), options, visitor);
}

/// Skeletonizes the mesh of `input`, which is wrapped first if requested.
Skeletonization_result compute_mesh_skeleton(Input& input, const Skeletonize_options& options,
                                             Progress_visitor& visitor)
{
#ifndef CSCD_LOCAL_METHOD_ONLY
  if (options.wrap) {
    Input wrapped = make_input(
        CSCD::internal::make_manifold(wrap_mesh(input.points, input.faces, *options.wrap), "the wrap").triangles);
    input.points = std::move(wrapped.points);
    input.faces = std::move(wrapped.faces);
    input.is_wrapped = true;
  }
#endif
  if (options.method == published_method) {
    return compute_published_mesh_skeleton(input, options, visitor);
  }
  std::vector<Vector3> points = input.is_kept ? input.points : std::move(input.points);
  std::vector<std::array<Index, 3>> faces = input.is_kept ? input.faces : std::move(input.faces);
  CSCD::Skeletonization_visitor_reference<Progress_visitor> reference(visitor);
  Skeletonization_result result;
  result.report =
      CSCD::skeletonize(std::move(points), std::move(faces), engine_options(options), reference, result.skeleton);
  return result;
}

/// Skeletonizes the graph of `input`.
Skeletonization_result compute_graph_skeleton(const Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  // Skeletons are graphs with positions, too.
  using Traits = CSCD::Spatial_graph_traits<Number_graph, CSCD::internal::Bundled_point_map<Number_graph>>;
  Number_graph graph;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    auto& vertex = graph[add_vertex(graph)];
    vertex.point = input.points[i];
    vertex.radius = input.graph->has_radii() ? input.graph->radii[i] : 0;
  }
  for (const auto& [a, b] : input.graph->edges) {
    add_edge(a, b, graph);
  }
  const Traits traits(graph, CSCD::internal::Bundled_point_map<Number_graph>{&graph});
  Skeletonization_result result = run_other_method(traits, CSCD::Graph_policies(), options, visitor);
  result.skeleton.separators.clear(); // sets of vertices, no curves
  return result;
}

/// Skeletonizes the points of `input` as published, and puts the triangles that join them into its mesh.
Skeletonization_result compute_published_point_skeleton(Input& input, const Skeletonize_options& options,
                                                        Progress_visitor& visitor)
{
  const auto traits = make_traits<CSCD::Point_set_traits<Numbers, Point_map>>(input);
  Skeletonization_result result = run_other_method(traits, published_policies(options, true), options, visitor);
  result.is_of_points = true;
  take_surface(traits, input);
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
  warnings.insert(warnings.begin(), reason + ": taken for a scan of trees; --shape surface or tree decides");
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
  if (input.graph) {
    return compute_graph_skeleton(input, options, visitor);
  }
  if (!input.is_point_set) {
    return compute_mesh_skeleton(input, options, visitor);
  }
  if (options.shape == tree_shape) {
    return compute_tree_skeleton(input, options);
  }
  return options.method == published_method ? compute_published_point_skeleton(input, options, visitor)
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
