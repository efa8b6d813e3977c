// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thins point clouds to the points that a skeleton needs, and averages noise away.

#ifndef CSCD_POINTS_CONSOLIDATE_POINTS_H
#define CSCD_POINTS_CONSOLIDATE_POINTS_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/internal/config.h>

#include <cstddef>

namespace CSCD::internal {

/// A cloud without outliers, thinned.
struct Consolidated_cloud
{
  Point_cloud cloud; ///< its number of thinned points includes the outliers
  /// Points of the input that are far from all others, or spread in space: they belong to the nearest of the others.
  std::size_t number_of_outliers = 0;
};

/// Leaves out outliers of `cloud`: points that have far fewer others around than most have, if they fill space, as
/// stray points do and sparse parts of a surface do not, or are far from their neighbors. Then thins it to as few
/// points as show its limbs: no two are nearer to each other than a radius, and no point of the cloud is farther than
/// that from one of them, which stands for it. The radius is the largest, of those for about 7,000, 10,000, 14,000 and
/// 20,000 points, at which the surface within twice the radius is nearly flat in 95 of 100 places. If points deviate
/// much from the surface, relative to the radius, those that are kept are moved to the mean of the points around them,
/// twice. A cloud that is hardly denser than that, and has no outliers, is returned unchanged. Does not depend on the
/// order of the input. O(n) in expectation without outliers.
Consolidated_cloud consolidate_points(Point_cloud&& cloud);

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Points/consolidate_points_impl.h>
#endif

#endif // CSCD_POINTS_CONSOLIDATE_POINTS_H
