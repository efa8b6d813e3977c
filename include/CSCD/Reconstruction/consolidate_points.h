// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thins point clouds to what a skeleton needs, and averages noise away.

#ifndef CSCD_RECONSTRUCTION_CONSOLIDATE_POINTS_H
#define CSCD_RECONSTRUCTION_CONSOLIDATE_POINTS_H

#include <CSCD/Surface/Point_cloud.h>
#include <CSCD/internal/config.h>

namespace CSCD::internal {

/// Thins `cloud` to as few points as show its limbs: no two are nearer to each other than a radius, and no point of the
/// cloud is farther than that from one of them, which stands for it. The radius is the largest, of those for about
/// 7,000, 10,000, 14,000 and 20,000 points, at which the surface within twice the radius is nearly flat in 95 of 100
/// places. If points deviate much from the surface, relative to the radius, those that are kept are moved to the mean
/// of the points around them, twice. Clouds that are hardly denser than that are returned unchanged. Does not depend on
/// the order of the input. O(n) in expectation.
Point_cloud consolidate_points(Point_cloud&& cloud);

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Reconstruction/consolidate_points_impl.h>
#endif

#endif // CSCD_RECONSTRUCTION_CONSOLIDATE_POINTS_H
