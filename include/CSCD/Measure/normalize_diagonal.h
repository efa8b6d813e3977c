// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings points into the coordinates in which skeletons are measured.

#ifndef CSCD_MEASURE_NORMALIZE_DIAGONAL_H
#define CSCD_MEASURE_NORMALIZE_DIAGONAL_H

#include <CSCD/Traits/Normalization.h>
#include <CSCD/Traits/normalize_extent.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Moves the centre of the bounding box of `points` to the origin and scales its diagonal to 1; linear.
/// \pre `points` is not empty and all coordinates are finite
/// \throw Input_error if all points are equal, or their extent is beyond what can be computed with
inline Normalization normalize_diagonal(std::vector<Vector_3>& points)
{
  const Normalization to_cube = normalize_extent(points);
  Vector_3 greatest = points.front();
  for (const Vector_3& point : points) {
    greatest = greatest.cwiseMax(point);
  }
  const Normalization to_diagonal{Vector_3::Zero(), 2 * greatest.norm()}; // the box is centred already
  for (Vector_3& point : points) {
    point = to_diagonal.from_input(point);
  }
  return to_cube.then(to_diagonal);
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_NORMALIZE_DIAGONAL_H
