// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes points at one place one.

#ifndef CSCD_SRC_IO_MERGE_EQUAL_POINTS_H
#define CSCD_SRC_IO_MERGE_EQUAL_POINTS_H

#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CSCD::internal {

/// Hashes a point by its coordinates; equal points have equal hashes.
inline std::uint64_t hash_point(const Vector3& point)
{
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15; // 2^64 by the golden ratio, odd: spreads near numbers
  std::uint64_t hash = 0;
  for (double coordinate : point) {
    coordinate += 0.0; // turns -0 into 0, which is equal
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash = (hash ^ bits) * factor;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Merges points of exactly equal coordinates into the first of them; the others keep their order. Linear.
///
/// Open addressing in one array, at most half full: the nodes of std::unordered_map take five times as long. The array
/// grows with the number of different points: the smaller it is, the more of it is in the cache.
/// \param[out] new_index for each old point, its new index
/// \return the number of points that vanished
/// \pre the points are finite
inline std::size_t merge_equal_points(std::vector<Vector3>& points, std::vector<Index>& new_index)
{
  constexpr std::size_t first_size = 1024; // a power of 2, as all sizes
  constexpr std::size_t look_ahead = 16;   // points whose places are fetched into the cache
  std::vector<Index> places(first_size, no_index);
  const auto find_place = [&](const Vector3& point) -> Index& {
    std::size_t place = hash_point(point) & (places.size() - 1);
    while (places[place] != no_index && points[places[place]] != point) {
      place = (place + 1) & (places.size() - 1);
    }
    return places[place];
  };
  const std::size_t size = points.size();
  new_index.resize(size);
  Index kept = 0;
  for (std::size_t i = 0; i < size; ++i) {
#ifdef __GNUC__
    __builtin_prefetch(&places[hash_point(points[std::min(i + look_ahead, size - 1)]) & (places.size() - 1)]);
#endif
    const Vector3 point = points[i];
    if (2 * std::size_t(kept + 1) > places.size()) {
      places.assign(4 * places.size(), no_index);
      for (Index k = 0; k < kept; ++k) {
        find_place(points[k]) = k;
      }
    }
    Index& place = find_place(point);
    if (place == no_index) {
      place = kept;
      points[kept++] = point;
    }
    new_index[i] = place;
  }
  points.resize(kept);
  return size - kept;
}

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_MERGE_EQUAL_POINTS_H
