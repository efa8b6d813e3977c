// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of points of a cloud, in one call; apart from that of a mesh, which needs less.

#ifndef CSCD_EXTRACT_CUT_LOCUS_FROM_POINTS_H
#define CSCD_EXTRACT_CUT_LOCUS_FROM_POINTS_H

#include <CSCD/Cut_locus/Cut_locus_graph.h>
#include <CSCD/Cut_locus/Cut_locus_indicators.h>
#include <CSCD/Cut_locus/Cut_locus_settings.h>
#include <CSCD/Cut_locus/Cut_locus_smoothing.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/Cut_locus/Point_derivatives.h>
#include <CSCD/Cut_locus/Smoothing_domains.h>
#include <CSCD/Geodesic/Cotangent_elements.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Geodesic/Tufted_cover.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Surface/Intrinsic_triangulation.h>
#include <CSCD/Surface/Point_cloud.h>
#include <CSCD/Surface/Point_complex.h>
#include <CSCD/Surface/build_point_complex.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector_3.h>
#include <CSCD/concepts.h>
#include <CSCD/exceptions.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// Finds the cut locus of points of a cloud; see `extract_cut_locus()`. \tparam Descriptor of the points of the input
template <class Descriptor>
class Point_cut_locus_extraction
{
public:
  /// Joins the points of a range.
  template <class PointRange, class PointMap, class NormalMap>
  Point_cut_locus_extraction(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map)
      : m_cloud(collect_points(points, point_map, normal_map)), m_complex(build_point_complex(m_cloud)),
        m_frames(m_complex), m_cover(m_complex), m_triangulation(make_intrinsic_delaunay(m_cover))
  {
    name_points(points);
  }
  template <class PointRange, class PointMap>
  Point_cut_locus_extraction(const PointRange& points, const PointMap& point_map)
      : Point_cut_locus_extraction(points, point_map, No_normals())
  {
  }

  Point_cut_locus_extraction(const Point_cut_locus_extraction&) = delete;
  Point_cut_locus_extraction& operator=(const Point_cut_locus_extraction&) = delete;

  /// Finds `sources` among the points.
  void set_sources(const std::vector<Descriptor>& sources)
  {
    if (sources.empty()) {
      throw Input_error("there is no source: give at least one point");
    }
    for (const Descriptor& source : sources) {
      const std::size_t number = number_of(source);
      if (number == m_descriptors.size()) {
        throw Input_error("a source is no point of the set: give the number or index of one");
      }
      const Index vertex = m_cloud.input_point[number];
      if (m_complex.outgoing(vertex).empty()) {
        throw Input_error("the source, point " + std::to_string(number) +
                          ", lies off the surface of the others: choose another one");
      }
      m_sources.push_back(vertex);
    }
  }

  /// Estimates the distances by the heat method, on the intrinsic Delaunay triangulation of the tufted cover.
  void estimate_distances() { m_distances = distances_from_vertices(m_triangulation, m_sources); }

  template <class PointDistanceMap>
  void read_distances(const PointDistanceMap& map)
  {
    m_distances.resize(m_complex.number_of_vertices());
    for (std::size_t i = 0; i < m_descriptors.size(); ++i) {
      const double distance = CGAL::to_double(get(map, m_descriptors[i])) / m_cloud.normalization.unit;
      if (std::isnan(distance)) {
        throw Input_error("the distance of point " + std::to_string(i) +
                          " is not a number: use infinity where no source is connected");
      }
      m_distances[m_cloud.input_point[i]] = distance;
    }
  }

  template <class CutLocusPolicy, class Graph>
  void operator()(const CutLocusPolicy& policy, const Cut_locus_settings& settings, Graph& graph)
  {
    const Point_derivatives derivatives(m_frames, Cotangent_elements(m_triangulation));
    const Point_cut_locus_indicators measures(derivatives, m_distances);
    const Org_tree tree(measures, std::vector<char>(m_distances.size(), 0));
    const Cut_tree cut = filter_org_tree(measures, tree, settings.criterion, policy, settings.minimum_branch_length,
                                         [](const Cut_tree&) {});
    collect_points_of(cut);
    const Point_smoothing_domain ground(measures);
    Cut_locus_smoothing<Point_smoothing_domain> smoothing(ground);
    smoothing(m_points, m_edges, settings.number_of_iterations);
    fill(graph);
  }

private:
  template <class PointRange>
  void name_points(const PointRange& points)
  {
    m_descriptors.reserve(m_cloud.input_point.size());
    for ([[maybe_unused]] const auto& element : points) {
      if constexpr (Is_range_of_indices<PointRange>::value) {
        m_descriptors.push_back(element);
      } else {
        m_descriptors.push_back(m_descriptors.size());
      }
    }
    m_input_point_of.assign(m_complex.number_of_vertices(), 0);
    for (std::size_t i = m_descriptors.size(); i-- > 0;) {
      m_input_point_of[m_cloud.input_point[i]] = i;
    }
  }

  /// The number of the point in the order of iteration, or that of points if there is none.
  std::size_t number_of(const Descriptor& descriptor) const
  {
    return std::size_t(std::find(m_descriptors.begin(), m_descriptors.end(), descriptor) - m_descriptors.begin());
  }

  void collect_points_of(const Cut_tree& cut)
  {
    std::vector<Index> point_of(m_complex.number_of_vertices(), no_index);
    for (Index vertex : cut.tree().order()) {
      if (cut.is_kept(vertex)) {
        point_of[vertex] = Index(m_points.size());
        m_points.push_back({vertex, m_complex.point(vertex)});
        if (!cut.is_root(vertex)) {
          m_edges.emplace_back(point_of[cut.tree().parent(vertex)], point_of[vertex]);
        }
      }
    }
  }

  template <class Graph>
  void fill(Graph& graph) const
  {
    using Point = std::decay_t<decltype(graph[0].point)>;
    using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
    graph = Graph(m_points.size());
    for (Index i = 0; i < m_points.size(); ++i) {
      const Vector_3 position = m_cloud.normalization.to_input(m_points[i].position);
      graph[i].point = Point(Coordinate(position.x()), Coordinate(position.y()), Coordinate(position.z()));
      graph[i].nearest = m_descriptors[m_input_point_of[m_points[i].nearest]];
      graph[i].distance = m_cloud.normalization.unit * m_distances[m_points[i].nearest];
    }
    for (const auto& [a, b] : m_edges) {
      add_edge(a, b, graph);
    }
  }

  Point_cloud m_cloud;
  Point_complex m_complex;
  Point_frames m_frames;
  Tufted_cover m_cover;
  Intrinsic_triangulation<Tufted_cover> m_triangulation;
  std::vector<Descriptor> m_descriptors;     // of the points of the input
  std::vector<std::size_t> m_input_point_of; // of every vertex, the first
  std::vector<Index> m_sources;
  std::vector<double> m_distances; // of every vertex
  std::vector<Cloud_point> m_points;
  std::vector<std::pair<Index, Index>> m_edges;
};

} // namespace internal

/// extracts the cut locus of some points of a cloud: the points of the surface that it samples with more than one
/// shortest way to the nearest source, and the ends of such curves.
///
/// As the supplement adapts its practical method to clouds (appendix G.2): no surface is made. Points are joined by the
/// triangles on which their neighborhoods agree; distances are those of the heat method on the tufted cover of these;
/// points are sought at which the Laplacian of the distance is strongly negative and the gradients around run against
/// each other, each the mean of its immediate neighborhood. They are joined along the ORG tree, branches are made one
/// point wide, and short ones dropped; the result is smoothed near the surface. On a sphere it is a point. Unlike on a
/// mesh, loops around handles and between sources stay open at one place each, since triangles that need not make up a
/// surface do not say what a loop encloses. O(n log n), once the distances are known.
///
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \tparam Graph a `Point_cut_locus_graph` of the point type; points in it are named by their indices in a
///         `CGAL::Point_set_3`, for other ranges by their numbers in the order of iteration
/// \param points at least four points, not all on a line, with or without noise
/// \param sources the points at distance 0, named in the same way
/// \param cut_locus is cleared first; if the function throws, it is left as it was. It has a connected component for
///        each component of the cloud with a source, and the farthest point of that component is in it
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements of `points`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
///     \cgalParamDefault{`points.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{normal_map}
///     \cgalParamDescription{normals of the surface at the points, of any length and of either orientation}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
///     \cgalParamDefault{`points.normal_map()` for a `CGAL::Point_set_3` that has normals, else none}
///   \cgalParamNEnd
///   \cgalParamNBegin{point_distance_map}
///     \cgalParamDescription{the distances of the points from the sources, infinite where there is no way}
///     \cgalParamType{a model of `ReadablePropertyMap` with the names of points as key and a number as value}
///     \cgalParamDefault{distances are estimated by the heat method}
///   \cgalParamNEnd
///   \cgalParamNBegin{laplacian_threshold}
///     \cgalParamDescription{at a cut point the Laplacian of the distance, times the spacing of the points, is not
///       greater; scale-free}
///     \cgalParamType{double}
///     \cgalParamDefault{-0.35}
///   \cgalParamNEnd
///   \cgalParamNBegin{angle_threshold}
///     \cgalParamDescription{at a cut point gradients around it converge by this angle at least, in radians}
///     \cgalParamType{double}
///     \cgalParamDefault{pi / 4}
///   \cgalParamNEnd
///   \cgalParamNBegin{cut_locus_policy}
///     \cgalParamDescription{which part of the tree is kept}
///     \cgalParamType{`Pruning_policy` or `Growing_policy`; the latter wants weaker thresholds, since it stops at every
///       point that fails them}
///     \cgalParamDefault{`Pruning_policy`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_branch_length}
///     \cgalParamDescription{shorter branches are dropped; relative to the distance of the farthest point}
///     \cgalParamType{double}
///     \cgalParamDefault{0.03}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how often the curves are smoothed; 0 leaves them at the points of the cloud}
///     \cgalParamType{int}
///     \cgalParamDefault{10}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if no surface can be seen in `points`, if there is no source, if one is no point of the set or
///        lies off the surface of the others, or if distances are missing; the message names the point and the remedy
template <class PointRange, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void extract_cut_locus(const PointRange& points, const std::vector<internal::Point_descriptor<PointRange>>& sources,
                       Graph& cut_locus, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t, CGAL::internal_np::normal_t,
                                   CGAL::internal_np::number_of_iterations_t, internal_np::point_distance_map_t,
                                   internal_np::laplacian_threshold_t, internal_np::angle_threshold_t,
                                   internal_np::cut_locus_policy_t, internal_np::minimum_branch_length_t>();
  using Extraction = internal::Point_cut_locus_extraction<internal::Point_descriptor<PointRange>>;
  const auto settings = internal::cut_locus_settings(np, internal::Point_cut_locus_indicators::default_criterion());
  const auto point_map = internal::point_map(points, np);
  Extraction extraction = internal::with_normal_map(
      points, np, [&](const auto&... normal_map) { return Extraction(points, point_map, normal_map...); });
  extraction.set_sources(sources);
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::point_distance_map_t>::value) {
    extraction.estimate_distances();
  } else {
    extraction.read_distances(get_parameter(np, internal_np::point_distance_map));
  }
  Graph result;
  extraction(choose_parameter(get_parameter(np, internal_np::cut_locus_policy), Pruning_policy()), settings, result);
  cut_locus = std::move(result);
}

/// extracts the cut locus of the point `source`; as above.
template <class PointRange, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void extract_cut_locus(const PointRange& points, internal::Point_descriptor<PointRange> source, Graph& cut_locus,
                       const NamedParameters& np = parameters::default_values())
{
  extract_cut_locus(points, std::vector<internal::Point_descriptor<PointRange>>{source}, cut_locus, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CUT_LOCUS_FROM_POINTS_H
