// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of a source on a triangle mesh in one call.

#ifndef CSCD_EXTRACT_CUT_LOCUS_H
#define CSCD_EXTRACT_CUT_LOCUS_H

#include <CSCD/Cut_locus/Cut_locus_graph.h>
#include <CSCD/Cut_locus/Cut_locus_indicators.h>
#include <CSCD/Cut_locus/Cut_locus_settings.h>
#include <CSCD/Cut_locus/Cut_locus_smoothing.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/Cut_locus/Smoothing_domains.h>
#include <CSCD/Cut_locus/Surface_walk.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Cut_locus/close_loops.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Surface/Edge_trace.h>
#include <CSCD/Surface/Intrinsic_triangulation.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/concepts.h>
#include <CSCD/exceptions.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// Finds the cut locus of sources on a mesh; see `extract_cut_locus()`.
template <class TriangleMesh, class VertexPointMap>
class Cut_locus_extraction
{
public:
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

  /// Reads `mesh`, and finds `sources` among its vertices.
  Cut_locus_extraction(const TriangleMesh& mesh, const VertexPointMap& point_map,
                       const std::vector<Vertex_descriptor>& sources)
      : m_mesh(mesh), m_collected(collect_triangles(mesh, point_map)),
        m_normalization(normalize_extent(m_collected.triangles.points)),
        m_surface(std::move(m_collected.triangles), std::move(m_collected.pairing)), m_surface_frames(m_surface),
        m_triangulation(make_intrinsic_delaunay(m_surface))
  {
    auto numbers = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
    for (const Vertex_descriptor vertex : vertices(mesh)) {
      put(numbers, vertex, no_index);
    }
    for (Index i = 0; i < m_collected.descriptors.size(); ++i) {
      put(numbers, m_collected.descriptors[i], i);
    }
    for (const Vertex_descriptor source : sources) {
      m_sources.push_back(get(numbers, source));
      if (m_sources.back() == no_index) {
        throw Input_error("a source has no faces: choose a vertex of the surface");
      }
    }
    if (m_sources.empty()) {
      throw Input_error("there is no source: give at least one vertex");
    }
  }

  /// Estimates the distances by the heat method.
  void estimate_distances() { m_distances = distances_from_vertices(m_triangulation, m_sources); }

  template <class VertexDistanceMap>
  void read_distances(const VertexDistanceMap& map)
  {
    for (Index i = 0; i < m_surface.number_of_vertices(); ++i) {
      m_distances.push_back(CGAL::to_double(get(map, m_collected.descriptors[i])) / m_normalization.unit);
      if (std::isnan(m_distances.back())) {
        throw Input_error("the distance of vertex " + std::to_string(i) +
                          " is not a number: use infinity where no source is connected");
      }
    }
  }

  template <class CutLocusPolicy, class Graph>
  void operator()(const CutLocusPolicy& policy, const Cut_locus_settings& settings, Graph& graph)
  {
    const Tangent_frames<Triangulation> frames(m_triangulation);
    const Cut_locus_indicators<Triangulation> measures(frames, m_distances);
    const Org_tree tree(measures, find_loop_vertices(measures, m_sources));
    const Cut_tree cut =
        find_cut_tree(measures, tree, m_sources, settings.criterion, policy, settings.minimum_branch_length);
    collect_points(cut);
    const Cut_locus_indicators<Open_triangulation> surface_measures(m_surface_frames, m_distances);
    const Surface_smoothing_domain ground(surface_measures);
    Cut_locus_smoothing<Surface_smoothing_domain> smoothing(ground);
    smoothing(m_points, m_edges, settings.number_of_iterations);
    fill(graph);
  }

private:
  using Triangulation = Intrinsic_triangulation<Open_triangulation>;

  /// Turns vertices of the tree into points, and what joins them into curves over the faces.
  void collect_points(const Cut_tree& cut)
  {
    const Surface_walk walk(m_surface_frames);
    std::vector<Index> point_of(m_surface.number_of_vertices(), no_index);
    for (Index vertex : cut.tree().order()) {
      if (cut.is_kept(vertex)) {
        point_of[vertex] = Index(m_points.size());
        m_points.push_back(walk.at_vertex(vertex));
      }
    }
    for (Index vertex : cut.tree().order()) {
      if (cut.is_kept(vertex) && !cut.is_root(vertex)) {
        add_curve(cut.tree().halfedge_to_parent(vertex), point_of);
      }
    }
    for (Index halfedge : cut.chords()) {
      add_curve(halfedge, point_of);
    }
  }

  /// Adds the points in which an edge of the triangulation crosses those of the mesh, and what joins them.
  void add_curve(Index halfedge, const std::vector<Index>& point_of)
  {
    Index last = point_of[m_triangulation.origin(halfedge)];
    if (!m_triangulation.is_input_edge(halfedge)) {
      m_triangulation.trace(halfedge, m_trace);
      for (const Edge_crossing& crossing : m_trace.crossings()) {
        Face_point point{Open_triangulation::face(crossing.halfedge), {}};
        point.weights[crossing.halfedge % 3] = 1 - crossing.position;
        point.weights[Open_triangulation::next(crossing.halfedge) % 3] = crossing.position;
        m_edges.emplace_back(last, Index(m_points.size()));
        last = Index(m_points.size());
        m_points.push_back(point);
      }
    }
    m_edges.emplace_back(last, point_of[m_triangulation.target(halfedge)]);
  }

  template <class Graph>
  void fill(Graph& graph) const
  {
    const auto face_range = faces(m_mesh);
    const std::vector<Face_descriptor> face_descriptors(face_range.begin(), face_range.end());
    const Surface_walk walk(m_surface_frames);
    graph = Graph(m_points.size());
    for (Index i = 0; i < m_points.size(); ++i) {
      const Face_point& at = m_points[i];
      graph[i].point = to_input_point<Point>(m_normalization, walk.position(at));
      // Triangles are collected from the target of the face's halfedge on.
      graph[i].location = {face_descriptors[at.face], {at.weights[2], at.weights[0], at.weights[1]}};
      double distance = 0;
      for (Index k = 0; k < 3; ++k) {
        // A face between reached vertices has none at infinity.
        distance += at.weights[k] * m_distances[m_surface.origin(3 * at.face + k)];
      }
      graph[i].distance = m_normalization.unit * distance;
    }
    for (const auto& [a, b] : m_edges) {
      add_edge(a, b, graph);
    }
  }

  const TriangleMesh& m_mesh;
  Collected_triangles<Vertex_descriptor> m_collected; // of which the descriptors remain
  Normalization m_normalization;
  Open_triangulation m_surface;
  Tangent_frames<Open_triangulation> m_surface_frames;
  Triangulation m_triangulation;
  std::vector<Index> m_sources;
  std::vector<double> m_distances; // of every vertex
  std::vector<Face_point> m_points;
  std::vector<std::pair<Index, Index>> m_edges;
  Edge_trace m_trace;
};

} // namespace internal

/// extracts the cut locus of some vertices of a triangle mesh: the points of the surface with more than one shortest
/// way to the nearest source, and the ends of such curves.
///
/// As the practical method of the supplement (appendix G.1), on the intrinsic Delaunay triangulation of the mesh:
/// vertices are sought at which the Laplacian of the distance
/// is strongly negative and gradients run against each other; they are joined along the ORG tree, the spanning tree
/// that follows the ridges of the distance; loops around handles are closed, so that on a closed connected surface of
/// genus g the cut locus of one source has first Betti number 2 g, and of k sources 2 g + k - 1; branches are made one
/// vertex wide, and short ones dropped; the result is smoothed on the surface. On a sphere it is a point.
/// Borders count as closed by discs. O(n log n) for n vertices, once the distances are known.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Graph a `Cut_locus_graph` of the point type of the mesh and its `face_descriptor`
/// \param mesh a triangle mesh, open or closed, of any number of components; those without a source have no cut locus
/// \param sources the vertices at distance 0; those that are neighbors count as one source
/// \param cut_locus is cleared first; if the function throws, it is left as it was. It has a connected component for
///        each component of the mesh with a source, and the farthest point of that component is in it
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_distance_map}
///     \cgalParamDescription{the distances of the vertices of `mesh` from the sources, infinite where there is no way}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a number as value}
///     \cgalParamDefault{distances are estimated by the heat method}
///   \cgalParamNEnd
///   \cgalParamNBegin{laplacian_threshold}
///     \cgalParamDescription{at a cut point the Laplacian of the distance, times the spacing of the vertices, is not
///       greater; scale-free}
///     \cgalParamType{double}
///     \cgalParamDefault{-0.5}
///   \cgalParamNEnd
///   \cgalParamNBegin{angle_threshold}
///     \cgalParamDescription{at a cut point gradients around the vertex converge by this angle at least, in radians}
///     \cgalParamType{double}
///     \cgalParamDefault{pi / 3}
///   \cgalParamNEnd
///   \cgalParamNBegin{cut_locus_policy}
///     \cgalParamDescription{which part of the tree is kept}
///     \cgalParamType{`Pruning_policy` or `Growing_policy`; the latter wants weaker thresholds, since it stops at every
///       vertex that fails them}
///     \cgalParamDefault{`Pruning_policy`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_branch_length}
///     \cgalParamDescription{shorter branches are dropped; relative to the distance of the farthest point}
///     \cgalParamType{double}
///     \cgalParamDefault{0.03}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how often the curves are smoothed; 0 leaves them on the edges of `mesh`}
///     \cgalParamType{int}
///     \cgalParamDefault{10}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if `mesh` is no oriented manifold of triangles with finite coordinates, if there is no source or
///        one has no faces, or if distances are missing; the message names the element and the remedy
template <class TriangleMesh, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_point_range_v<TriangleMesh>, int> = 0>
void extract_cut_locus(const TriangleMesh& mesh,
                       const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& sources,
                       Graph& cut_locus, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                   CGAL::internal_np::number_of_iterations_t, internal_np::vertex_distance_map_t,
                                   internal_np::laplacian_threshold_t, internal_np::angle_threshold_t,
                                   internal_np::cut_locus_policy_t, internal_np::minimum_branch_length_t>();
  check_triangle_mesh<TriangleMesh>();
  const auto settings = internal::cut_locus_settings(np, internal::Cut_criterion());
  const auto point_map = internal::vertex_point_map(mesh, np);
  internal::Cut_locus_extraction<TriangleMesh, std::decay_t<decltype(point_map)>> extraction(mesh, point_map, sources);
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::vertex_distance_map_t>::value) {
    extraction.estimate_distances();
  } else {
    extraction.read_distances(get_parameter(np, internal_np::vertex_distance_map));
  }
  Graph result;
  extraction(choose_parameter(get_parameter(np, internal_np::cut_locus_policy), Pruning_policy()), settings, result);
  cut_locus = std::move(result);
}

/// extracts the cut locus of the vertex `source`; as above.
template <class TriangleMesh, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_point_range_v<TriangleMesh>, int> = 0>
void extract_cut_locus(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                       Graph& cut_locus, const NamedParameters& np = parameters::default_values())
{
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  extract_cut_locus(mesh, std::vector<Vertex_descriptor>{source}, cut_locus, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CUT_LOCUS_H
