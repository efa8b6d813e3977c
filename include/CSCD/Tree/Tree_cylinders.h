// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton of a scan of trees as cylinders, and the measures of foresters.

#ifndef CSCD_TREE_TREE_CYLINDERS_H
#define CSCD_TREE_TREE_CYLINDERS_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CSCD {

/// A cylinder of a quantitative structure model: a piece of a limb between two nodes. Lengths are in the unit of the
/// skeleton, indices are counted from 0.
struct Tree_cylinder
{
  Vector3 start;                          ///< the end nearer to the root, on the axis
  Vector3 axis;                           ///< away from the root, unit length
  double length = 0;                      ///< along the axis
  double radius = 0;                      ///< mean of both nodes
  std::optional<std::size_t> parent{};    ///< the cylinder before it; none for the first of a trunk
  std::optional<std::size_t> extension{}; ///< the cylinder after it in its limb; none for the last
  std::size_t limb = 0;                   ///< the `Tree_branch`
  std::size_t position = 0;               ///< in its limb
};

/// The foresters' measures of one object of a scan, in the unit of the skeleton. The third coordinate is the height.
struct Tree_measures
{
  double height = 0;       ///< of the highest node above the root
  double length = 0;       ///< of all limbs
  double volume = 0;       ///< of all cylinders
  double trunk_volume = 0; ///< of those of the trunk
  /// Twice the radius of the trunk at breast height above the root; not a number if the trunk does not reach it.
  double diameter_at_breast_height = std::numeric_limits<double>::quiet_NaN();
};

/// The height above the root where the diameter of a trunk is measured in most countries, in meters.
inline constexpr double default_breast_height = 1.3;

namespace internal {

std::vector<Tree_cylinder> make_tree_cylinders(const Skeleton& skeleton, const Tree_report& report);
std::vector<Tree_measures> measure_trees(const Skeleton& skeleton, const Tree_report& report, double breast_height);

} // namespace internal

/// sets for each branch of the skeleton of a scan of trees the limb that contains it: the limb along its last edge.
/// Linear.
/// \param report the result of `extract_tree_skeleton()`
/// \param branches of the same skeleton, as `measure_branches()` gives them
void assign_limbs(const Tree_report& report, Skeleton_branches& branches);

/// makes cylinders of the limbs of a scan of trees, those of a limb one after the other, parents before children. A
/// limb begins at the bark of its parent. Linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes have a radius, as `extract_tree_skeleton()` wrote it
/// \param report the result of `extract_tree_skeleton()`
template <class Skeleton>
std::vector<Tree_cylinder> make_tree_cylinders(const Skeleton& skeleton, const Tree_report& report)
{
  return internal::make_tree_cylinders(internal::index_skeleton(skeleton), report);
}

/// measures each object of a scan of trees, in the order of their numbers. Linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes have a radius, as `extract_tree_skeleton()` wrote it
/// \param report the result of `extract_tree_skeleton()`
/// \param breast_height in the unit of the skeleton
template <class Skeleton>
std::vector<Tree_measures> measure_trees(const Skeleton& skeleton, const Tree_report& report,
                                         double breast_height = default_breast_height)
{
  return internal::measure_trees(internal::index_skeleton(skeleton), report, breast_height);
}

} // namespace CSCD

#endif // CSCD_TREE_TREE_CYLINDERS_H
