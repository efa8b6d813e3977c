// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points at equal distances along a closed polygon.

#ifndef CSCD_SEPARATOR_RESAMPLE_POLYGON_H
#define CSCD_SEPARATOR_RESAMPLE_POLYGON_H

#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Writes to `samples` so many points at equal distances along the closed polygon `points`, beginning at its first
/// point. Linear.
/// \pre `points` is not empty and `number` is positive
inline void resample_polygon(const std::vector<Vector_3>& points, std::size_t number, std::vector<Vector_3>& samples)
{
  CGAL_precondition(!points.empty() && number > 0);
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += (points[(i + 1) % points.size()] - points[i]).norm();
  }
  samples.clear();
  const double step = length / double(number);
  double begin = 0; // of the side that follows `side`
  std::size_t side = 0;
  double side_length = (points[1 % points.size()] - points[0]).norm();
  for (std::size_t k = 0; k < number; ++k) {
    const double position = double(k) * step;
    while (begin + side_length < position && side + 1 < points.size()) {
      begin += side_length;
      ++side;
      side_length = (points[(side + 1) % points.size()] - points[side]).norm();
    }
    const double part = side_length > 0 ? std::clamp((position - begin) / side_length, 0., 1.) : 0.;
    samples.push_back((1 - part) * points[side] + part * points[(side + 1) % points.size()]);
  }
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_RESAMPLE_POLYGON_H
