// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve skeleton of a point set in one call; apart from that of a mesh, which compiles in half the time.

#ifndef CSCD_EXTRACT_CURVE_SKELETON_FROM_POINTS_H
#define CSCD_EXTRACT_CURVE_SKELETON_FROM_POINTS_H

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/Traits/Reconstructed_surface_traits.h>
#include <CSCD/concepts.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CSCD {
/// extracts the curve skeleton of a point set that samples the surface of one or several bodies.
///
/// A closed surface is made of the points first: see `Reconstructed_surface_traits`; the report lists the repairs. The
/// skeleton is that of this surface. Every point of the input belongs to exactly one node: duplicates to the same, and
/// points off the surface to that of the nearest point. The skeleton is the same, to the last bit, from call to call,
/// for any number of threads and any order of the points. O(n log n).
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \tparam Skeleton a model of `CurveSkeletonGraph`; its nodes hold the indices of the points in a `CGAL::Point_set_3`,
///         for other ranges the numbers of the points in the order of iteration, as `std::size_t`
/// \param points at least four points, not all on a line
/// \param skeleton is cleared first; if the function throws, it is left as it was
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
///   \cgalParamNBegin{policies}
///     \cgalParamDescription{the algorithms of the stages; `Published_policies` for the method as published. Policies
///       that work on a `Point_solid` get the points as they are, without a surface made of them}
///     \cgalParamType{a model of `SkeletonizationPolicies`}
///     \cgalParamDefault{`Local_policies`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// `geom_traits`, `random_seed`, `maximum_number_of_sources`, `number_of_threads`, `detail`, `node_spacing` and
/// `visitor` are as for a mesh.
///
/// \return counts, timings and warnings; `reconstruction` says how the surface was made
/// \throw Input_error if no surface can be made of `points`; the message names the point and the remedy
/// \throw Cancelled_error if the visitor stops the work
template <class ConcurrencyTag = CGAL::Sequential_tag, class PointRange, class Skeleton,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
Skeletonization_report extract_curve_skeleton(const PointRange& points, Skeleton& skeleton,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<
      NamedParameters, CGAL::internal_np::geom_traits_t, CGAL::internal_np::point_t, CGAL::internal_np::normal_t,
      CGAL::internal_np::random_seed_t, CGAL::internal_np::visitor_t, internal_np::maximum_number_of_sources_t,
      internal_np::number_of_threads_t, internal_np::detail_t, internal_np::node_spacing_t, internal_np::policies_t>();
  const auto point_map = internal::point_map(points, np);
  const auto policies = internal::skeletonization_policies(np);
  using Point_map = std::decay_t<decltype(point_map)>;
  using Traits =
      std::conditional_t<is_skeletonization_policies_v<std::decay_t<decltype(policies)>, Point_solid>,
                         Point_set_traits<PointRange, Point_map>, Reconstructed_surface_traits<PointRange, Point_map>>;
  const auto make_traits = [&] {
    return internal::with_normal_map(points, np, [&](const auto& normal_map) {
      if constexpr (std::is_same_v<typename Traits::Surface, Point_solid>) {
        return Traits(points, point_map, normal_map);
      } else {
        return Traits(points, point_map, normal_map, internal::to_options<ConcurrencyTag>(np).number_of_threads);
      }
    });
  };
  return internal::skeletonize<ConcurrencyTag>(make_traits, policies, skeleton, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CURVE_SKELETON_FROM_POINTS_H
