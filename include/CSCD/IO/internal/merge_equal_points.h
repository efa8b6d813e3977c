// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merging points of one position.

#ifndef CSCD_IO_INTERNAL_MERGE_EQUAL_POINTS_H
#define CSCD_IO_INTERNAL_MERGE_EQUAL_POINTS_H

#include <CSCD/internal/Vector_3.h>

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CSCD::internal {

/// Hashes a point by its coordinates; equal points have equal hashes.
struct Point_hash
{
  std::size_t operator()(const Vector_3& point) const
  {
    std::size_t seed = 0;
    for (double coordinate : point) {
      boost::hash_combine(seed, coordinate + 0.0); // turns -0 into 0, which is equal
    }
    return seed;
  }
};

/// Merges points of exactly equal coordinates into the first of them; the others keep their order. Linear.
/// \param[out] new_index for each old point, its new index
/// \return the number of points that vanished
/// \pre the points are finite
inline std::size_t merge_equal_points(std::vector<Vector_3>& points, std::vector<Index>& new_index)
{
  std::unordered_map<Vector_3, Index, Point_hash> index_of;
  index_of.reserve(points.size());
  new_index.resize(points.size());
  Index size = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [place, is_new] = index_of.emplace(points[i], size);
    new_index[i] = place->second;
    if (is_new) {
      points[size++] = points[i];
    }
  }
  const std::size_t number_of_merged_points = points.size() - size;
  points.resize(size);
  return number_of_merged_points;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_MERGE_EQUAL_POINTS_H
