// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Radii for any skeleton, from the surface alone, so that skeletons of all makers can be compared.

#ifndef CSCD_MEASURE_ESTIMATE_RADII_H
#define CSCD_MEASURE_ESTIMATE_RADII_H

#include <CSCD/Skeleton.h>
#include <CSCD/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Estimates the radius of each node from points of the surface, and nothing else.
/// Each point is assigned to the nearest point of the skeleton, at distance d and at parameter t of an edge; it counts
/// for the source of the edge with weight 1 - t and for the target with weight t. The radius of a node is the weighted
/// mean of the distances; nodes to which no point was assigned are interpolated from their neighbors.
/// O(p log e) for p points and e edges, where those are well spread.
/// \throw Input_error if the edges are too many near each other, or make too many cycles
/// \pre there are points and nodes
std::vector<double> estimate_radii(const std::vector<Vector_3>& points, const Skeleton& skeleton);

} // namespace CSCD::internal

#endif // CSCD_MEASURE_ESTIMATE_RADII_H
