// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of the surface that a closed curve spans lies inside the body.

#ifndef CSCD_SELECTION_SPAN_INSIDE_SHARE_H
#define CSCD_SELECTION_SPAN_INSIDE_SHARE_H

#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The share of the cone from the center of a closed polygon to its points that lies inside the body: nearly 1 for a
/// curve around a limb, nearly 0 for one around a hole, which bounds no disc in the body (section 3.2.2). Sampled.
/// \tparam Traits a model of `SolidSkeletonizationTraits`
template <class Traits>
double span_inside_share(const Traits& traits, const std::vector<Vector_3>& points, const Vector_3& center)
{
  constexpr std::size_t most_directions = 8;
  constexpr double parts[] = {0.25, 0.5, 0.75}; // of the way from the center to the curve
  const std::size_t directions = std::min(points.size(), most_directions);
  std::size_t inside = traits.is_inside(center) ? 1 : 0;
  std::size_t samples = 1;
  for (std::size_t i = 0; i < directions; ++i) {
    const Vector_3& point = points[i * points.size() / directions];
    for (double part : parts) {
      inside += traits.is_inside(center + part * (point - center)) ? 1 : 0;
      ++samples;
    }
  }
  return double(inside) / double(samples);
}

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SPAN_INSIDE_SHARE_H
