// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation of the skeleton: of meshes, of points on the surface made of them or by their neighborhoods, and of
// scans of trees.

#include "compute_skeleton.h"

#include "Progress_bar.h"
#include "roots.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Graph_policies.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Options.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/Traits/Reconstructed_surface_traits.h>
#include <CSCD/Traits/Spatial_graph_traits.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Tree/extract_tree_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>
#include <CSCD/skeletonize.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

/// The numbers of points, as a range, with the map that gives the points.
class Numbered_points
{
public:
  using Numbers = std::vector<std::size_t>;
  using Point_map = CGAL::Pointer_property_map<Point>::const_type;
  using Normal_map = CGAL::Pointer_property_map<Vector>::const_type;
  /// A skeleton whose nodes hold numbers of points.
  using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;

  /// \param points, normals are referred to; there may be no normals
  Numbered_points(const std::vector<Point>& points, const std::vector<Vector>& normals)
      : m_numbers(points.size()), m_points(points), m_normals(normals)
  {
    std::iota(m_numbers.begin(), m_numbers.end(), std::size_t(0));
  }

  /// Makes surface traits of the points, and of the normals if there are any.
  template <class Traits>
  Traits make_traits() const
  {
    const Point_map point_map = CGAL::make_property_map(m_points);
    return m_normals.empty() ? Traits(m_numbers, point_map)
                             : Traits(m_numbers, point_map, Normal_map(CGAL::make_property_map(m_normals)));
  }

  /// The surface of `traits`, which were made of these points; its first vertices are the points, the others were
  /// inserted. Triangles at which it would not be a surface are left out.
  template <class Traits>
  Mesh make_mesh(const Traits& traits) const
  {
    Mesh mesh;
    for (const Point& point : m_points) {
      mesh.add_vertex(point);
    }
    const auto& triangulation = traits.surface().triangulation();
    std::vector<Mesh::Vertex_index> mesh_vertex;
    for (CSCD::Index vertex = 0; vertex < triangulation.number_of_vertices(); ++vertex) {
      const auto numbers = traits.descriptors(vertex);
      const Point place = traits.to_input_point(triangulation.point(vertex));
      const auto nearest = std::min_element(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
        return CGAL::squared_distance(m_points[a], place) < CGAL::squared_distance(m_points[b], place);
      });
      mesh_vertex.push_back(nearest == numbers.end() ? mesh.add_vertex(place)
                                                     : Mesh::Vertex_index(static_cast<Mesh::size_type>(*nearest)));
    }
    for (CSCD::Index face = 0; face < triangulation.number_of_faces(); ++face) {
      const auto [a, b, c] = triangulation.face_halfedges(face);
      mesh.add_face(mesh_vertex[triangulation.origin(a)], mesh_vertex[triangulation.origin(b)],
                    mesh_vertex[triangulation.origin(c)]);
    }
    return mesh;
  }

private:
  Numbers m_numbers;
  const std::vector<Point>& m_points;
  const std::vector<Vector>& m_normals;
};

/// The same skeleton with numbers of points as vertices of a mesh.
Skeleton convert_skeleton(const CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  Skeleton result;
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    auto& converted = result[add_vertex(result)];
    converted.point = skeleton[node].point;
    converted.radius = skeleton[node].radius;
    for (std::size_t number : skeleton[node].vertices) {
      converted.vertices.emplace_back(static_cast<Mesh::size_type>(number));
    }
  }
  for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
    add_edge(source(edge, skeleton), target(edge, skeleton), skeleton[edge], result);
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

/// Skeletonizes the surface of `traits` into `skeleton` by the algorithms of `policies`. \return the rest of the result
template <class Traits, class Policies, class AnySkeleton>
Skeletonization_result run_skeletonization(const Traits& traits, const Policies& policies,
                                           const Skeletonize_options& options, Progress_visitor& visitor,
                                           AnySkeleton& skeleton)
{
  CSCD::Curve_skeletonization<Traits, Policies, Progress_visitor&> skeletonization(traits, policies, visitor);
  const CSCD::Options settings = engine_options(options);
  skeletonization.set_random_seed(settings.random_seed)
      .set_number_of_threads(settings.number_of_threads)
      .set_maximum_number_of_sources(settings.maximum_number_of_sources);
  Skeletonization_result result;
  result.report = skeletonization.template run<CGAL::Parallel_if_available_tag>(skeleton);
  for (auto separator : skeletonization.packed_separators()) {
    result.separators.push_back(skeletonization.polyline(skeletonization.separators()[separator]));
  }
  return result;
}

/// As `run_skeletonization()` with the policies of other than the local method. The page that computes omits them to
/// stay small.
template <class Traits, class Policies, class AnySkeleton>
Skeletonization_result
run_other_method([[maybe_unused]] const Traits& traits, [[maybe_unused]] const Policies& policies,
                 [[maybe_unused]] const Skeletonize_options& options, [[maybe_unused]] Progress_visitor& visitor,
                 [[maybe_unused]] AnySkeleton& skeleton)
{
#ifdef CSCD_LOCAL_METHOD_ONLY
  throw Usage_error("--method, --as: only the local method is built into this");
#else
  return run_skeletonization(traits, policies, options, visitor, skeleton);
#endif
}

/// Skeletonizes the mesh of `input` by the published method.
Skeletonization_result compute_published_mesh_skeleton(const Input& input, const Skeletonize_options& options,
                                                       Progress_visitor& visitor)
{
  const CSCD::Triangle_mesh_traits<Mesh> traits(input.mesh, get(CGAL::vertex_point, input.mesh),
                                                engine_options(options).border_treatment, options.number_of_threads);
  Skeleton skeleton;
  Skeletonization_result result =
      run_other_method(traits, published_policies(options, false), options, visitor, skeleton);
  result.skeleton = std::move(skeleton);
  return result;
}

/// The result that holds a plain skeleton.
Skeletonization_result make_result(const CSCD::Skeleton& skeleton, CSCD::Skeletonization_report report,
                                   const std::vector<Mesh::Vertex_index>& descriptors)
{
  Skeletonization_result result;
  result.report = std::move(report);
  result.skeleton = CSCD::internal::make_skeleton_graph<Skeleton, Point>(skeleton, descriptors);
  for (const std::vector<CSCD::Vector_3>& separator : skeleton.separators) {
    result.separators.emplace_back();
    for (const CSCD::Vector_3& point : separator) {
      result.separators.back().emplace_back(point.x(), point.y(), point.z());
    }
  }
  return result;
}

/// Skeletonizes the mesh of `input`, or its triangles, which are used up. The mesh is wrapped first if requested.
Skeletonization_result compute_mesh_skeleton(Input& input, const Skeletonize_options& options,
                                             Progress_visitor& visitor)
{
#ifndef CSCD_LOCAL_METHOD_ONLY
  if (options.wrap) {
    wrap_mesh(input, *options.wrap);
  }
#endif
  if (options.method == published_method) {
    return compute_published_mesh_skeleton(input, options, visitor);
  }
  CSCD::internal::Mesh_arrays<Mesh::Vertex_index> arrays;
  if (input.triangles) {
    arrays.points = std::move(input.triangles->triangles.points);
    arrays.faces = std::move(input.triangles->triangles.faces);
    for (CSCD::Index vertex = 0; vertex < arrays.points.size(); ++vertex) {
      arrays.descriptors.emplace_back(vertex);
    }
    input.triangles->pairing = {}; // the engine makes its own
  } else {
    arrays = CSCD::internal::read_mesh(input.mesh, get(CGAL::vertex_point, input.mesh));
  }
  CSCD::Skeleton skeleton;
  CSCD::Skeletonization_visitor_reference<Progress_visitor> reference(visitor);
  CSCD::Skeletonization_report report = CSCD::skeletonize(std::move(arrays.points), std::move(arrays.faces),
                                                          engine_options(options), reference, skeleton);
  return make_result(skeleton, std::move(report), arrays.descriptors);
}

/// Skeletonizes the graph of `input`.
Skeletonization_result compute_graph_skeleton(const Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  // Skeletons are graphs with positions, too.
  using Graph = Numbered_points::Skeleton;
  using Traits = CSCD::Spatial_graph_traits<Graph, CSCD::internal::Bundled_point_map<Graph>>;
  Graph graph;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    auto& vertex = graph[add_vertex(graph)];
    vertex.point = input.points[i];
    vertex.radius = input.graph->has_radii() ? input.graph->radii[i] : 0;
  }
  for (const auto& [a, b] : input.graph->edges) {
    add_edge(a, b, graph);
  }
  const Traits traits(graph, CSCD::internal::Bundled_point_map<Graph>{&graph});
  Numbered_points::Skeleton skeleton;
  Skeletonization_result result = run_other_method(traits, CSCD::Graph_policies(), options, visitor, skeleton);
  result.separators.clear(); // sets of vertices, no curves
  result.skeleton = convert_skeleton(skeleton);
  return result;
}

/// Skeletonizes the points of `input` as published, and puts the triangles that join them into its mesh.
Skeletonization_result compute_published_point_skeleton(Input& input, const Skeletonize_options& options,
                                                        Progress_visitor& visitor)
{
  using Traits = CSCD::Point_set_traits<Numbered_points::Numbers, Numbered_points::Point_map>;
  const Numbered_points points(input.points, input.normals);
  const auto traits = points.make_traits<Traits>();
  Numbered_points::Skeleton skeleton;
  Skeletonization_result result =
      run_other_method(traits, published_policies(options, true), options, visitor, skeleton);
  result.skeleton = convert_skeleton(skeleton);
  result.is_of_points = true;
  input.mesh = points.make_mesh(traits);
  return result;
}

/// Skeletonizes the points of `input` as a scan of trees, and makes them the vertices of its mesh, without faces.
Skeletonization_result compute_tree_skeleton(Input& input, const Skeletonize_options& options)
{
  Skeletonization_result result;
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  if (const std::optional<Point> root = root_point(options.root)) {
    result.tree = CSCD::extract_tree_skeleton(input.points, skeleton, CSCD::parameters::root(*root));
  } else {
    result.tree = CSCD::extract_tree_skeleton(input.points, skeleton);
  }
  result.skeleton = convert_skeleton(skeleton);
  input.mesh.clear();
  for (const Point& point : input.points) {
    input.mesh.add_vertex(point);
  }
  return result;
}

using Surface_traits = CSCD::Reconstructed_surface_traits<Numbered_points::Numbers, Numbered_points::Point_map>;

Skeletonization_result compute_surface_skeleton(const Surface_traits& traits, const Skeletonize_options& options,
                                                Progress_visitor& visitor)
{
  Numbered_points::Skeleton skeleton;
  Skeletonization_result result = run_skeletonization(
      traits, CSCD::Local_policies(CSCD::Detail(options.detail), options.spacing), options, visitor, skeleton);
  result.skeleton = convert_skeleton(skeleton);
  result.is_of_points = true;
  return result;
}

/// The skeleton of points that may not sample a surface, with the reason in front of the warnings.
Skeletonization_result compute_recognized_tree_skeleton(Input& input, const Skeletonize_options& options,
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
  const Numbered_points points(input.points, input.normals);
  try {
    const auto traits = points.make_traits<Surface_traits>();
    if (options.shape == surface_shape || !traits.is_surface_doubtful()) {
      Skeletonization_result result = compute_surface_skeleton(traits, options, visitor);
      input.mesh = points.make_mesh(traits);
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
  std::vector<CSCD::Vertex_label> labels = CSCD::label_vertices(input.mesh, result.skeleton, result.branches);
  if (input.is_point_set) { // its points are the first vertices of the mesh
    labels.resize(input.points.size());
    return labels;
  }
  const std::vector<CSCD::Vector_3> points = CSCD::internal::to_vectors(input.mesh.points());
  if (!input.is_wrapped) {
    return CSCD::internal::labels_of_file(input.as_read.points, points, labels);
  }
  const CSCD::internal::Point_tree tree(points);
  std::vector<CSCD::Vertex_label> labels_of_nearest;
  labels_of_nearest.reserve(input.as_read.points.size());
  for (const CSCD::Vector_3& point : input.as_read.points) {
    labels_of_nearest.push_back(labels[tree.nearest(point)]);
  }
  return labels_of_nearest;
}

} // namespace cscd
