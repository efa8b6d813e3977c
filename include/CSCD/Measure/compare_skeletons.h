// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How alike two skeletons are: of two seeds, resolutions, poses or methods.

#ifndef CSCD_MEASURE_COMPARE_SKELETONS_H
#define CSCD_MEASURE_COMPARE_SKELETONS_H

#include <CSCD/Measure/Branch_graph.h>
#include <CSCD/Measure/Compared_skeleton.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace CSCD {

namespace internal {

/// \throw Input_error if `skeleton`, called `name`, has no nodes or one that is not finite
inline void check_skeleton(const Indexed_skeleton& skeleton, const std::string& name)
{
  if (skeleton.number_of_nodes() == 0) {
    throw Input_error("the " + name + " skeleton has no nodes: there is nothing to compare");
  }
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    if (!skeleton.points[v].allFinite()) {
      throw Input_error("node " + std::to_string(v) + " of the " + name +
                        " skeleton has a coordinate that is not finite: correct it or remove the node");
    }
  }
}

/// The coordinates in which the bounding box of both skeletons has a diagonal of 1; any, where it is a point.
/// \throw Input_error if the coordinates are too large
inline Normalization common_normalization(const Indexed_skeleton& a, const Indexed_skeleton& b)
{
  Eigen::AlignedBox3d box;
  for (const Indexed_skeleton* skeleton : {&a, &b}) {
    for (const Vector_3& point : skeleton->points) {
      box.extend(point);
    }
  }
  const double diagonal = (box.max() - box.min()).stableNorm();
  if (!std::isfinite(diagonal)) {
    throw Input_error("the skeletons are too large to be measured: scale the coordinates");
  }
  return {box.min(), diagonal > 0 ? diagonal : 1};
}

} // namespace internal

/// measures how far two skeletons are apart, and how many of their tips, junctions and branches are at the same place.
///
/// Distances are those of points of one skeleton from the nearest point of the other, both ways. Two tips match if they
/// are not farther apart than the match distance, and likewise two junctions; two branches if the mean distance of
/// each from the other is not greater. Nearest pairs are matched first, each feature at most once. See
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
  if (!(match_distance >= 0)) {
    throw Input_error("the match distance is negative or no number: 0.02 will do in most cases");
  }
  internal::Indexed_skeleton a = internal::index_skeleton(first);
  internal::Indexed_skeleton b = internal::index_skeleton(second);
  internal::check_skeleton(a, "first");
  internal::check_skeleton(b, "second");
  const Normalization normalization = internal::common_normalization(a, b);
  for (internal::Indexed_skeleton* skeleton : {&a, &b}) {
    for (Vector_3& point : skeleton->points) {
      point = normalization.from_input(point);
    }
  }
  const internal::Compared_skeleton side_a(std::move(a));
  const internal::Compared_skeleton side_b(std::move(b));
  Skeleton_comparison result;
  result.diagonal = normalization.unit;
  result.match_distance = match_distance;
  result.from_first_to_second = side_a.distance(side_b, match_distance);
  result.from_second_to_first = side_b.distance(side_a, match_distance);
  result.tips = side_a.match_nodes(
      side_b, [](std::size_t degree) { return degree == 1; }, match_distance);
  result.junctions = side_a.match_nodes(
      side_b, [](std::size_t degree) { return degree > 2; }, match_distance);
  result.branches = side_a.match_branches(side_b, match_distance);
  result.has_same_structure = internal::have_same_structure(side_a.graph(), side_b.graph());
  return result;
}

} // namespace CSCD

#endif // CSCD_MEASURE_COMPARE_SKELETONS_H
