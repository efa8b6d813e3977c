// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton of a scan of trees in one call.

#ifndef CSCD_TREE_EXTRACT_TREE_SKELETON_H
#define CSCD_TREE_EXTRACT_TREE_SKELETON_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <type_traits>
#include <vector>

namespace CSCD {
namespace internal {

/// Skeletonizes a scan of trees; see `CSCD::extract_tree_skeleton()`.
/// \param skeleton is replaced; its nodes hold the numbers of the points
Tree_report skeletonize_trees(const std::vector<Vector3>& points, const std::optional<Vector3>& root,
                              Skeleton& skeleton);

/// 50,000 to 100,000 of `points`, or all if they are fewer: those whose coordinates have a certain remainder, so that
/// the choice does not depend on their order. Linear.
inline std::vector<Vector3> sample_of(const std::vector<Vector3>& points)
{
  constexpr std::size_t size = 50000;
  const std::size_t divisor = std::max<std::size_t>(1, points.size() / size);
  const auto key = [](const Vector3& point) {
    std::uint64_t result = 0;
    for (const double coordinate : point) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      // The finalizer of SplitMix64.
      result = (result ^ bits) + 0x9e3779b97f4a7c15U;
      result = (result ^ (result >> 30U)) * 0xbf58476d1ce4e5b9U;
      result = (result ^ (result >> 27U)) * 0x94d049bb133111ebU;
      result ^= result >> 31U;
    }
    return result;
  };
  std::vector<Vector3> result;
  std::copy_if(points.begin(), points.end(), std::back_inserter(result),
               [&](const Vector3& point) { return key(point) % divisor == 0; });
  return result;
}

} // namespace internal

/// returns whether dense points are a scan of trees, or of other branching thin things, by the form of their
/// neighborhoods: in 8 to 60 % of them the points lie along curves, not on a surface. Fewer than 20,000 points show
/// too little of their form: the answer is no. Linear, and fast: a sample of at most 100,000 points is examined. Does
/// not depend on the order of the points.
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \param points at least one point
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements of `points`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
///     \cgalParamDefault{`points.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if `points` is empty
/// \pre all coordinates are finite
template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
bool is_scan_of_trees(const PointRange& points, const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t>();
  constexpr std::size_t min_number_of_points = 20000;
  const std::vector<Vector3> coordinates = internal::coordinates_of(points, internal::point_map(points, np));
  const Point_cloud cloud = make_point_cloud(internal::sample_of(coordinates), {});
  return cloud.points.size() >= min_number_of_points && internal::is_scan_of_trees(internal::forms_of(cloud.points));
}

/// extracts the skeletons of trees, or of other branching thin things, from a scan of them.
///
/// Scans of trees are not surfaces: twigs are hit by few points, limbs are seen from one side, and parts behind others
/// are missing. So no surface is made. Points near each other for the spacing around are joined to a graph; its pieces
/// are joined across gaps; the shortest paths from the root cut it into slices, and these form limbs; circles are
/// fitted across the limbs. Every object becomes a tree of the skeleton, with radii that do not increase from base to
/// tip. A part that stands apart on the ground is an object of its own: the third coordinate is the height.
///
/// Nodes stand in the order of the branches that the report names, parents before children; the first of each object is
/// its root. Every point of the input belongs to exactly one node. The skeleton is the same, to the last bit, from call
/// to call and for any order of the points. O(n log n).
///
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \tparam Skeleton a model of `CurveSkeletonGraph`; its nodes hold the indices of the points in a `CGAL::Point_set_3`,
///         for other ranges the numbers of the points in the order of iteration, as `std::size_t`
/// \param points at least one point
/// \param skeleton is cleared first; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements of `points`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
///     \cgalParamDefault{`points.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{root}
///     \cgalParamDescription{where the trunk of the object next to it begins}
///     \cgalParamType{a point with coordinates `x()`, `y()`, `z()`}
///     \cgalParamDefault{the lowest points of the object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return branches with parent, order, length and radii; the gaps that were bridged; counts and warnings
/// \throw Input_error if there are too many points or none, or a coordinate of a point or of the root is not finite;
///        the message names the point and the remedy
template <class PointRange, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Tree_report extract_tree_skeleton(const PointRange& points, Skeleton& skeleton,
                                  const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t, internal_np::root_t>();
  static_assert(is_point_range_v<PointRange>, "CSCD: extract_tree_skeleton requires a range of points");
  check_curve_skeleton_graph<Skeleton>();
  const auto point_map = internal::point_map(points, np);
  std::optional<Vector3> root;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::root_t>::value) {
    root = internal::to_vector_3(parameters::get_parameter(np, internal_np::root));
  }
  CSCD::Skeleton trees;
  Tree_report report = internal::skeletonize_trees(internal::coordinates_of(points, point_map), root, trees);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  skeleton = internal::make_skeleton_graph<Skeleton, Point>(trees, internal::descriptors_of(points));
  return report;
}

} // namespace CSCD

#endif // CSCD_TREE_EXTRACT_TREE_SKELETON_H
