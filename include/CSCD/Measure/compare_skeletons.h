// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How alike two skeletons are: of two seeds, resolutions, poses or methods.

#ifndef CSCD_MEASURE_COMPARE_SKELETONS_H
#define CSCD_MEASURE_COMPARE_SKELETONS_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>

#include <algorithm>
#include <cstddef>

namespace CSCD {

/// How far the points of one skeleton are from another one. Lengths are relative to the diagonal of the bounding box of
/// both skeletons.
struct Skeleton_distance
{
  double mean = 0;             ///< over the length of the edges
  double maximum = 0;          ///< over edges and nodes
  double fraction_matched = 0; ///< of the length: what is not farther away than the match distance
};

/// How many features of two skeletons are at the same place.
struct Match_count
{
  std::size_t number_in_first = 0;  ///< features of the first skeleton
  std::size_t number_in_second = 0; ///< features of the second skeleton
  std::size_t number_matched = 0;   ///< pairs of features at the same place; each is in one pair at most

  /// 1 if all are matched, 0 if none are; 1 if there are none.
  double fraction() const
  {
    const std::size_t sum = number_in_first + number_in_second;
    return sum > 0 ? 2 * double(number_matched) / double(sum) : 1;
  }
};

/// How alike two skeletons are.
struct Skeleton_comparison
{
  double diagonal = 0;                    ///< of the bounding box of both, in their unit
  double match_distance = 0;              ///< up to which features count as the same, relative to the diagonal
  Skeleton_distance from_first_to_second; ///< of the points of the first from the second
  Skeleton_distance from_second_to_first; ///< of the points of the second from the first
  Match_count tips;                       ///< nodes with one edge
  Match_count junctions;                  ///< nodes with three edges or more
  Match_count branches;                   ///< paths between nodes that have not two edges, and cycles
  /// Whether branches are joined in the same way, wherever they are: the skeletons of a body in two poses should agree.
  bool has_same_structure = false;

  /// The mean of both mean distances.
  double mean_distance() const { return (from_first_to_second.mean + from_second_to_first.mean) / 2; }
  /// The greater one of both maxima.
  double hausdorff_distance() const { return std::max(from_first_to_second.maximum, from_second_to_first.maximum); }
};

namespace internal {

Skeleton_comparison compare_skeletons(Indexed_skeleton&& first, Indexed_skeleton&& second, double match_distance);

} // namespace internal

/// measures how far two skeletons are apart, and how many of their tips, junctions and branches are at the same place.
///
/// Distances are those of points of one skeleton from the nearest point of the other, in both directions. Two tips
/// match if they are not farther apart than the match distance, and likewise two junctions; two branches if the mean
/// distance of each from the other is not greater. Nearest pairs are matched first, each feature at most once. See
/// `doc/measures.md`. O(n log n + p) for n nodes and samples and p pairs of branches.
///
/// \tparam Skeleton1,Skeleton2 models of `CurveSkeletonGraph`
/// \param first,second skeletons in the same coordinates
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{match_distance}
///     \cgalParamDescription{up to which features count as the same, relative to the diagonal of the bounding box of
///     both skeletons}
///     \cgalParamType{double}
///     \cgalParamDefault{0.02}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if a skeleton has no nodes or a coordinate is not finite, or the match distance is negative
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

#ifndef CSCD_COMPILED
#include <CSCD/Measure/compare_skeletons_impl.h>
#endif

#endif // CSCD_MEASURE_COMPARE_SKELETONS_H
