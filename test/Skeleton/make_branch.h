// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of one branch.

#ifndef CSCD_TEST_SKELETON_MAKE_BRANCH_H
#define CSCD_TEST_SKELETON_MAKE_BRANCH_H

#include "support/Shape_solid.h"
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>

#include <vector>

namespace CSCD::test {

/// A branch over `points` of the shape of `solid`, with nodes of `radius` in the unit of the shape.
inline Skeleton_builder make_branch(const Shape_solid& solid, const std::vector<Vector_3>& points, double radius)
{
  Skeleton_builder builder;
  for (Index i = 0; i < points.size(); ++i) {
    builder.add_node(solid.at(points[i].x(), points[i].y(), points[i].z()), radius / solid.unit());
    if (i > 0) {
      builder.add_edge(i - 1, i);
    }
  }
  return builder;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SKELETON_MAKE_BRANCH_H
