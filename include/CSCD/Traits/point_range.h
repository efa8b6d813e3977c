// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ranges of points have in common: vectors of points, of structures with a point, and CGAL's point sets.

#ifndef CSCD_TRAITS_POINT_RANGE_H
#define CSCD_TRAITS_POINT_RANGE_H

#include <CSCD/Named_parameters.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CSCD::internal {

/// The elements over which a range iterates.
template <class Range>
using Range_value =
    typename std::iterator_traits<std::decay_t<decltype(std::begin(std::declval<const Range&>()))>>::value_type;

/// Whether the elements of a range are its own indices, as those of `CGAL::Point_set_3`.
template <class Range, class = void>
struct Is_range_of_indices : std::false_type
{
};

template <class Range>
struct Is_range_of_indices<Range, std::void_t<typename Range::Index>>
    : std::is_same<typename Range::Index, Range_value<Range>>
{
};

/// What identifies a point of a range: its index in a `CGAL::Point_set_3`, else its number in the order of iteration.
template <class PointRange>
using Point_descriptor =
    std::conditional_t<Is_range_of_indices<PointRange>::value, Range_value<PointRange>, std::size_t>;

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

/// Calls `function(points, point_map)`, or `function(points, point_map, normal_map)` if `np` gives normals or the range
/// has them, and returns what it returns.
template <class PointRange, class NamedParameters, class Function>
auto with_maps(const PointRange& points, const NamedParameters& np, const Function& function)
{
  const auto map = point_map(points, np);
  if constexpr (!parameters::is_default_parameter<NamedParameters, CGAL::internal_np::normal_t>::value) {
    return function(points, map, parameters::get_parameter(np, CGAL::internal_np::normal_map));
  } else if constexpr (Is_range_of_indices<PointRange>::value) {
    return points.has_normal_map() ? function(points, map, points.normal_map()) : function(points, map);
  } else {
    return function(points, map);
  }
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_POINT_RANGE_H
