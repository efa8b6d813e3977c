// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The elements of a range of points, and the identifiers of its points.

#ifndef CSCD_TRAITS_INPUT_POINTS_H
#define CSCD_TRAITS_INPUT_POINTS_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// The elements of a range.
template <class Range>
using Range_value =
    typename std::iterator_traits<std::decay_t<decltype(std::begin(std::declval<const Range&>()))>>::value_type;

/// Whether the elements of a range are its own indices, as in a `CGAL::Point_set_3`.
template <class Range, class = void>
struct Is_range_of_indices : std::false_type
{
};

template <class Range>
struct Is_range_of_indices<Range, std::void_t<typename Range::Index>>
    : std::is_same<typename Range::Index, Range_value<Range>>
{
};

} // namespace internal

/// The identifier of a point of a range: its index in a `CGAL::Point_set_3`, else its number in the order of iteration.
template <class PointRange>
using Point_descriptor = std::conditional_t<internal::Is_range_of_indices<PointRange>::value,
                                            internal::Range_value<PointRange>, std::size_t>;

namespace internal {

using CSCD::Point_descriptor;

/// The descriptors of the points of a range, in the order of iteration.
template <class PointRange>
std::vector<Point_descriptor<PointRange>> descriptors_of(const PointRange& points)
{
  std::vector<Point_descriptor<PointRange>> result;
  for ([[maybe_unused]] const auto& element : points) {
    if constexpr (Is_range_of_indices<PointRange>::value) {
      result.push_back(element);
    } else {
      result.push_back(result.size());
    }
  }
  return result;
}

/// The points of a range by their numbers in the order of iteration.
template <class PointRange>
struct Point_numbering
{
  /// Linear.
  explicit Point_numbering(const PointRange& points) : descriptors(descriptors_of(points))
  {
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      numbers.resize(std::max(numbers.size(), std::size_t(descriptors[i]) + 1), no_index);
      numbers[std::size_t(descriptors[i])] = Index(i);
    }
  }

  /// The number of a point, `no_index` if the range does not have it; constant time.
  Index number(const Point_descriptor<PointRange>& descriptor) const
  {
    return std::size_t(descriptor) < numbers.size() ? numbers[std::size_t(descriptor)] : no_index;
  }

  std::vector<Point_descriptor<PointRange>> descriptors; ///< of every number
  std::vector<Index> numbers;                            ///< of every descriptor
};

/// The map from the elements of a range to points where none is given: that of a `CGAL::Point_set_3`, or the identity.
template <class PointRange>
auto default_point_map(const PointRange& points)
{
  if constexpr (Is_range_of_indices<PointRange>::value) {
    return points.point_map();
  } else {
    return CGAL::Identity_property_map<const Range_value<PointRange>>();
  }
}

/// The point map that `np` gives, else that of the range.
template <class PointRange, class NamedParameters>
auto point_map(const PointRange& points, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, CGAL::internal_np::point_t>::value) {
    return default_point_map(points);
  } else {
    return parameters::get_parameter(np, CGAL::internal_np::point_map);
  }
}

/// The replacement of a map to normals for points without normals.
struct No_normals
{
};

/// Calls `function(map)` with the normal map that `np` gives, else with that of the range, if it has one, else with
/// `No_normals`. \return the result of the function, in all cases of the same type
template <class PointRange, class NamedParameters, class Function>
auto with_normal_map([[maybe_unused]] const PointRange& points, [[maybe_unused]] const NamedParameters& np,
                     const Function& function)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, CGAL::internal_np::normal_t>::value) {
    return function(parameters::get_parameter(np, CGAL::internal_np::normal_map));
  } else if constexpr (Is_range_of_indices<PointRange>::value) {
    return points.has_normal_map() ? function(points.normal_map()) : function(No_normals());
  } else {
    return function(No_normals());
  }
}

/// The coordinates of the points of a range, in order.
template <class PointRange, class PointMap>
std::vector<Vector3> coordinates_of(const PointRange& points, const PointMap& point_map)
{
  std::vector<Vector3> result;
  result.reserve(std::size_t(std::distance(std::begin(points), std::end(points))));
  for (const auto& element : points) {
    result.push_back(to_vector_3(get(point_map, element)));
  }
  return result;
}

/// Reads points that a surface can be made of into flat arrays; O(n log n).
/// \param point_map, normal_map readable maps from the elements of `range` to objects with coordinates `x()`, `y()`,
///        `z()`; the second may be `No_normals`
/// \throw Input_error as `make_point_cloud()` and `check_extent()` do
template <class PointRange, class PointMap, class NormalMap>
Point_cloud collect_points(const PointRange& range, const PointMap& point_map,
                           [[maybe_unused]] const NormalMap& normal_map)
{
  std::vector<Vector3> normals;
  if constexpr (!std::is_same_v<NormalMap, No_normals>) {
    normals = coordinates_of(range, normal_map);
  }
  Point_cloud cloud = make_point_cloud(coordinates_of(range, point_map), std::move(normals));
  check_extent(cloud);
  return cloud;
}

/// The same with the maps that `np` gives, else the maps of the range.
template <class PointRange, class NamedParameters>
Point_cloud collect_points_of(const PointRange& range, const NamedParameters& np)
{
  const auto map = point_map(range, np);
  return with_normal_map(range, np, [&](const auto& normal_map) { return collect_points(range, map, normal_map); });
}

} // namespace internal
} // namespace CSCD

#endif // CSCD_TRAITS_INPUT_POINTS_H
