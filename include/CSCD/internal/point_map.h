// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the elements of a range to points.

#ifndef CSCD_INTERNAL_POINT_MAP_H
#define CSCD_INTERNAL_POINT_MAP_H

#include <CSCD/Named_parameters.h>

#include <CGAL/property_map.h>

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

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_POINT_MAP_H
