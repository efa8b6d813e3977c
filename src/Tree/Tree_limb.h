// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slices, sections and limbs of a scanned tree.

#ifndef CSCD_SRC_TREE_TREE_LIMB_H
#define CSCD_SRC_TREE_TREE_LIMB_H

#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>

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

/// A section of a limb, derived from a slice.
struct Section
{
  Vector_3 center = Vector_3::Zero();
  Vector_3 direction = Vector_3::Zero(); ///< of the limb, unit length
  double radius = 0;
  double confidence = 0; ///< of center and radius, in [0, 1]
  bool is_rough = true;  ///< whether no circle near it gives the radius
  Circle_outcome outcome = Circle_outcome::few_points;

  /// Whether center and radius are those of a circle.
  bool is_circle() const { return outcome == Circle_outcome::fitted; }
};

/// A limb from its base to its tip.
struct Tree_limb
{
  Index parent = no_index; ///< the limb from which it grows; none for a trunk
  Index joint = no_index;  ///< the slice of the parent from which it grows
  std::vector<Index> slices;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_TREE_LIMB_H
