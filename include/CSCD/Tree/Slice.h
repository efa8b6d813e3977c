// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of an object on the way from its root to its tips.

#ifndef CSCD_TREE_SLICE_H
#define CSCD_TREE_SLICE_H

#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// A connected piece of a band of distances from the root.
struct Slice
{
  Index parent = no_index; ///< the slice through which the shortest paths to the root go
  float begin = 0;         ///< the band
  float end = 0;
  std::vector<Index> points;
  Vector_3 centroid = Vector_3::Zero();
  double spacing = 0; ///< mean over the points
  double radius = 0;  ///< scatter around the direction of growth
};

} // namespace CSCD::internal

#endif // CSCD_TREE_SLICE_H
