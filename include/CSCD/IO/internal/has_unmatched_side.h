// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether polygons have a border, found without further memory.

#ifndef CSCD_IO_INTERNAL_HAS_UNMATCHED_SIDE_H
#define CSCD_IO_INTERNAL_HAS_UNMATCHED_SIDE_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <cstdint>

namespace CSCD::internal {

/// Whether there are more sides of polygons from some point to another one than in the opposite direction, as on a
/// border. Compares sums of hashes over all sides; different ones are taken for equal once in 2^64 times. Linear.
inline bool has_unmatched_side(const Polygon_soup& soup)
{
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15; // 2^64 by the golden ratio, odd: spreads near numbers
  const auto hash = [](Index source, Index target) {
    std::uint64_t bits = (std::uint64_t(source) << 32U | target) * factor;
    bits = (bits ^ bits >> 32U) * factor;
    return bits ^ bits >> 32U;
  };
  std::uint64_t difference = 0;
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    const Index* const corners = soup.corners.data() + soup.first_corner[polygon];
    const std::size_t size = soup.size_of_polygon(polygon);
    for (std::size_t i = 0; i < size; ++i) {
      const Index target = corners[i + 1 < size ? i + 1 : 0];
      difference += hash(corners[i], target) - hash(target, corners[i]);
    }
  }
  return difference != 0;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_HAS_UNMATCHED_SIDE_H
