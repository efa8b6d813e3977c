// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances on a point set in one call; apart from those on a mesh, which compile in half the time.

#ifndef CSCD_GEODESIC_ESTIMATE_GEODESIC_DISTANCES_ON_POINTS_H
#define CSCD_GEODESIC_ESTIMATE_GEODESIC_DISTANCES_ON_POINTS_H

#include <CSCD/Geodesic/Point_set_distance_estimator.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Traits/input_concepts.h>

#include <array>
#include <type_traits>

namespace CSCD {

/// estimates the geodesic distance of every point of a set from the nearest one of some sources, along the surface that
/// the points sample.
///
/// What is said in `Point_set_distance_estimator` holds; to ask for distances from other sources too, use that class:
/// nearly all the time of this function goes into preparing the points.
///
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \tparam Sources the descriptor of a point, or a range of them: its index in a `CGAL::Point_set_3`, for other ranges
///         its number in the order of iteration
/// \tparam PointDistanceMap a model of `WritablePropertyMap` with the descriptor of a point as key, to which `double`
///         can be written
/// \param points at least four points, not all on a line
/// \param sources what distance is measured from
/// \param distances gets 0 for sources, infinity for points that no path joins to a source; if the function throws, it
///        is left as it was
/// \param np an optional sequence of named parameters: `point_map`, `normal_map` and `time_step_factor`, as
///        `Point_set_distance_estimator` has them
/// \throw Input_error if a coordinate is not finite, or the points do not sample a surface; the message names the point
///        and the remedy
/// \pre the sources are descriptors of points
template <class PointRange, class Sources, class PointDistanceMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void estimate_geodesic_distances(const PointRange& points, const Sources& sources, PointDistanceMap distances,
                                 const NamedParameters& np = parameters::default_values())
{
  using Estimator = Point_set_distance_estimator<PointRange>;
  using Descriptor = typename Estimator::Point_descriptor;
  const Estimator estimator(points, np);
  if constexpr (std::is_convertible_v<const Sources&, Descriptor>) {
    estimator.estimate(std::array<Descriptor, 1>{Descriptor(sources)}, distances);
  } else {
    estimator.estimate(sources, distances);
  }
}

} // namespace CSCD

#endif // CSCD_GEODESIC_ESTIMATE_GEODESIC_DISTANCES_ON_POINTS_H
