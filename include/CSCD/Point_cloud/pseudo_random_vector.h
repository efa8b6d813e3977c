// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small shifts of points, for no four of them to lie on one circle.

#ifndef CSCD_POINT_CLOUD_PSEUDO_RANDOM_VECTOR_H
#define CSCD_POINT_CLOUD_PSEUDO_RANDOM_VECTOR_H

#include <CSCD/internal/Vector_3.h>

#include <random>

namespace CSCD::internal {

/// A vector with coordinates in [-1, 1] that depends on the number of the point alone.
inline Vector_3 pseudo_random_vector(Index point)
{
  std::minstd_rand random(point + 1);
  random.discard(2); // the first numbers of neighboring seeds are alike
  Vector_3 result = Vector_3::Zero();
  for (double& coordinate : result) {
    coordinate = 2 * double(random()) / double(std::minstd_rand::max()) - 1;
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_PSEUDO_RANDOM_VECTOR_H
