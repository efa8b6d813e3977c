// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of points of a cloud in one call.

#ifndef CSCD_EXTRACT_CUT_LOCUS_FROM_POINTS_H
#define CSCD_EXTRACT_CUT_LOCUS_FROM_POINTS_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Published/Cut_locus_extraction.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// extracts the cut locus of some points of a cloud: the points of the surface that it samples with more than one
/// shortest path to the nearest source, and the ends of such curves.
///
/// As the supplement adapts its practical method to clouds (appendix G.2): no surface is made. Points are joined by the
/// triangles that their neighborhoods agree on; the heat method on the tufted cover of these gives the distances;
/// points are sought where the Laplacian of the distance is strongly negative and the gradients around run against each
/// other, each the mean of its immediate neighborhood. They are joined along the ORG tree, branches are made one point
/// wide, and short ones dropped. It runs from point to point; on a sphere it is a point. Unlike on a mesh, loops around
/// handles and between sources stay open at one place each, since triangles that need not form a surface do not
/// determine the inside of a loop. O(n log n), once the distances are known.
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
///   \cgalParamNBegin{distance_map}
///     \cgalParamDescription{the distances of the points from the sources, infinite without a path}
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
/// \cgalNamedParamsEnd
///
/// `minimum_branch_length` is as for a mesh.
///
/// \throw Input_error if `points` do not sample a surface, if `sources` is empty, if one is not a point of the set or
///        lies off the surface of the others, or if distances are missing; the message names the point and the remedy
template <class PointRange, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void extract_cut_locus(const PointRange& points, const std::vector<Point_descriptor<PointRange>>& sources,
                       Graph& cut_locus, const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t, CGAL::internal_np::normal_t,
                                   internal_np::distance_map_t, internal_np::laplacian_threshold_t,
                                   internal_np::angle_threshold_t, internal_np::minimum_branch_length_t>();
  const Point_cloud cloud = internal::collect_points_of(points, np);
  const internal::Point_numbering<PointRange> numbering(points);
  if (sources.empty()) {
    throw Input_error("there is no source: give at least one point");
  }
  std::vector<std::size_t> source_numbers;
  for (const auto& source : sources) {
    source_numbers.push_back(numbering.number(source));
    if (source_numbers.back() == no_index) {
      throw Input_error("a source is not a point of the set: give the number or index of one");
    }
  }
  std::vector<double> distances;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::distance_map_t>::value) {
    const auto map = parameters::get_parameter(np, internal_np::distance_map);
    distances.resize(cloud.points.size());
    for (std::size_t i = 0; i < numbering.descriptors.size(); ++i) {
      const double distance = CGAL::to_double(get(map, numbering.descriptors[i])) / cloud.normalization.unit;
      distances[cloud.input_point[i]] = internal::checked_distance(distance, "point", i);
    }
  }
  const auto result =
      internal::extract_cut_locus_of_points(cloud, source_numbers, std::move(distances),
                                            internal::cut_locus_settings(np, internal::point_cut_locus_settings()));
  std::vector<std::size_t> first_number(cloud.points.size(), 0); // of every point of the cloud
  for (std::size_t i = numbering.descriptors.size(); i-- > 0;) {
    first_number[cloud.input_point[i]] = i;
  }
  internal::write_cut_locus(
      result, cloud.normalization, [&](Index point) { return numbering.descriptors[first_number[point]]; }, cut_locus);
}

/// extracts the cut locus of the point `source`; as above.
template <class PointRange, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void extract_cut_locus(const PointRange& points, Point_descriptor<PointRange> source, Graph& cut_locus,
                       const NamedParameters& np = parameters::default_values())
{
  extract_cut_locus(points, std::vector<Point_descriptor<PointRange>>{source}, cut_locus, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CUT_LOCUS_FROM_POINTS_H
