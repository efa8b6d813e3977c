// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a closed curve spans a part of the body or surrounds a hollow.

#ifndef CSCD_SEPARATOR_IS_AROUND_HOLLOW_H
#define CSCD_SEPARATOR_IS_AROUND_HOLLOW_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The share of the cone from the center of a closed polygon to its points that lies inside the body: nearly 1 for a
/// curve around a limb, nearly 0 for one around a hole, which bounds no disc in the body (section 3.2.2). Sampled.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
double span_inside_share(const Surface& surface, const std::vector<Vector_3>& points, const Vector_3& center)
{
  constexpr std::size_t max_directions = 8;
  constexpr double parts[] = {0.25, 0.5, 0.75}; // of the way from the center to the curve
  const std::size_t directions = std::min(points.size(), max_directions);
  std::size_t inside = surface.is_inside(center) ? 1 : 0;
  std::size_t samples = 1;
  for (std::size_t i = 0; i < directions; ++i) {
    const Vector_3& point = points[i * points.size() / directions];
    for (double part : parts) {
      inside += surface.is_inside(center + part * (point - center)) ? 1 : 0;
      ++samples;
    }
  }
  return double(inside) / double(samples);
}

/// Whether `separator` leads around something hollow, such as the wall of a cup: it is as round as the section of a
/// limb, but its center, and most of the cone from there, lie outside of the body.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
bool is_around_hollow(const Surface& surface, const Separator& separator)
{
  constexpr double min_roundness = 0.75;    // isoperimetric quotient; from 0.65 to 0.85, few cups and vases change
  constexpr double max_inside_share = 0.35; // in walls of cups up to 0.32, in hollow ears 0.4
  if (separator.is_open || separator.roundness() < min_roundness || surface.is_inside(separator.center)) {
    return false;
  }
  std::vector<Vector_3> points;
  curve_points(surface.triangulation(), separator, points);
  return span_inside_share(surface, points, separator.center) < max_inside_share;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_IS_AROUND_HOLLOW_H
