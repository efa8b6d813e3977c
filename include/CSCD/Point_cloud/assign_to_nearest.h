// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// To which site points belong that are none themselves.

#ifndef CSCD_POINT_CLOUD_ASSIGN_TO_NEAREST_H
#define CSCD_POINT_CLOUD_ASSIGN_TO_NEAREST_H

#include <CSCD/Point_cloud/Point_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Gives the points that have no site that of the nearest one that has; O(n log n).
/// \param sites of every point, `no_index` where there is none
/// \pre some point has one
inline void assign_to_nearest(const std::vector<Vector_3>& points, std::vector<Index>& sites)
{
  std::vector<Index> used;
  std::vector<Vector_3> used_points;
  for (Index point = 0; point < sites.size(); ++point) {
    if (sites[point] != no_index) {
      used.push_back(point);
      used_points.push_back(points[point]);
    }
  }
  if (used.size() == sites.size()) {
    return;
  }
  const Point_tree tree(used_points);
  for (Index point = 0; point < sites.size(); ++point) {
    if (sites[point] == no_index) {
      sites[point] = sites[used[tree.nearest(points[point])]];
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_ASSIGN_TO_NEAREST_H
