// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How alike two skeletons are: of two seeds, resolutions, poses or methods.

#ifndef CSCD_MEASURE_COMPARE_SKELETONS_H
#define CSCD_MEASURE_COMPARE_SKELETONS_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>

namespace CSCD {

namespace internal {

Skeleton_comparison compare_skeletons(Skeleton&& first, Skeleton&& second, double match_distance);

} // namespace internal

/// measures how far two skeletons are apart, and how many of their tips and junctions are at the same place.
///
/// Distances are those of points of one skeleton from the nearest point of the other, in both directions. Two tips
/// match if they are not farther apart than the match distance, and likewise two junctions. Nearest pairs are matched
/// first, each feature at most once. See `doc/measures.md`. O(n log n) for n nodes and edges that are well spread.
///
/// \tparam Skeleton1,Skeleton2 models of `CurveSkeletonGraph`
/// \param first,second skeletons in the same coordinates
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{match_distance}
///     \cgalParamDescription{the greatest distance between features that count as the same, relative to the diagonal of
///     the bounding box of both skeletons}
///     \cgalParamType{double}
///     \cgalParamDefault{0.02}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if a skeleton has no nodes or a coordinate is not finite, the match distance is negative, or too
///        many tips or junctions are near each other: 4 million pairs of them
template <class Skeleton1, class Skeleton2, class NamedParameters = parameters::Default_named_parameters>
Skeleton_comparison compare_skeletons(const Skeleton1& first, const Skeleton2& second,
                                      const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, internal_np::match_distance_t>();
  constexpr double default_match_distance = 0.02; // a thin limb's radius; skeletons of two seeds agree up to this
  const double match_distance = double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::match_distance), default_match_distance));
  return internal::compare_skeletons(internal::index_skeleton(first), internal::index_skeleton(second), match_distance);
}

} // namespace CSCD

#endif // CSCD_MEASURE_COMPARE_SKELETONS_H
