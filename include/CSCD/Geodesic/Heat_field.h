// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the heat method computes for one set of sources.

#ifndef CSCD_GEODESIC_HEAT_FIELD_H
#define CSCD_GEODESIC_HEAT_FIELD_H

#include <Eigen/Core>

#include <vector>

namespace CSCD::internal {

/// Distances from a set of sources, and on request what they were computed from.
struct Heat_field
{
  /// Of every vertex, in the unit of the lengths; 0 at vertices that are sources, infinite on components without a
  /// source. Close to several sources, or to one inside a face, values may be a little below 0.
  std::vector<double> distances;
  /// Of every face, in the frame of its layout: the unit vector away from the sources, which is the gradient of the
  /// exact distance; zero where there is none. Empty unless asked for.
  std::vector<Eigen::Vector2d> directions;
  /// The natural logarithm of the heat at every vertex, up to a constant for each component; -infinity on components
  /// without a source, and where the heat is not positive, as happens where faces are not Delaunay. On Delaunay
  /// triangulations every vertex but the sources has a neighbor with more heat. Empty unless asked for.
  std::vector<double> log_heat;
};

/// Which parts of a field are wanted besides the distances.
struct Heat_field_parts
{
  bool directions = false;
  bool log_heat = false;
};

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_HEAT_FIELD_H
