// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scalings, rotations and moves of points.

#ifndef CSCD_TEST_SUPPORT_SIMILARITY_H
#define CSCD_TEST_SUPPORT_SIMILARITY_H

#include "Shape.h"

#include <cmath>
#include <vector>

namespace CSCD::test {

/// A scaling, then a rotation around an axis, then a move.
struct Similarity
{
  double scale = 1;
  Triple axis{0, 0, 1}; ///< of unit length
  double angle = 0;
  Triple offset{0, 0, 0};

  Triple operator()(const Triple& p) const
  {
    // Rodrigues' formula
    const Triple rotated =
        std::cos(angle) * p + std::sin(angle) * cross(axis, p) + ((1 - std::cos(angle)) * dot(axis, p)) * axis;
    return scale * rotated + offset;
  }
};

inline std::vector<Triple> moved(std::vector<Triple> points, const Similarity& motion)
{
  for (Triple& p : points) {
    p = motion(p);
  }
  return points;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SIMILARITY_H
