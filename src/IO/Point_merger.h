// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes points at one place one.

#ifndef CSCD_SRC_IO_POINT_MERGER_H
#define CSCD_SRC_IO_POINT_MERGER_H

#include <CSCD/Vector3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
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

/// Makes points of exactly equal coordinates one, the first of them. Open addressing in one array, at most half full:
/// the nodes of std::unordered_map take five times as long. The array grows with the number of different points: the
/// smaller it is, the more of it is in the cache.
class Point_merger
{
public:
  /// \param expected the number of points that will be added
  explicit Point_merger(std::size_t expected) : m_places(first_size, no_index) { m_indices.reserve(expected); }

  /// Adds a finite point.
  void add(const Vector3& point)
  {
    Pending& pending = m_pending[m_number % m_pending.size()];
    if (m_number >= m_pending.size()) {
      insert(pending);
    }
    pending = {point, hash_point(point)};
#ifdef __GNUC__
    __builtin_prefetch(&m_places[place_of(pending.hash)]);
#endif
    ++m_number;
  }

  /// Hands over the different points, in the order of their first addition, and the index among them of each point that
  /// was added. To be called once, at the end.
  void move_to(std::vector<Vector3>& points, std::vector<Index>& indices)
  {
    for (std::size_t i = m_number - std::min(m_number, m_pending.size()); i < m_number; ++i) {
      insert(m_pending[i % m_pending.size()]);
    }
    points = std::move(m_points);
    indices = std::move(m_indices);
  }

private:
  /// A point that waits for the memory that its place needs.
  struct Pending
  {
    Vector3 point;
    std::uint64_t hash;
  };

  static constexpr std::size_t first_size = 1024; // a power of 2, as all sizes
  static constexpr std::size_t number_of_pending = 16;

  std::size_t place_of(std::uint64_t hash) const
  {
    return std::size_t(hash) & (m_places.size() - 1);
  }

  /// The place of a point, or a free one.
  std::size_t find_place(const Pending& pending) const
  {
    std::size_t place = place_of(pending.hash);
    while (m_places[place] != no_index && m_points[m_places[place]] != pending.point) {
      place = place_of(place + 1);
    }
    return place;
  }

  void insert(const Pending& pending)
  {
    std::size_t place = find_place(pending);
    if (m_places[place] == no_index) {
      if (2 * (m_points.size() + 1) > m_places.size()) {
        grow();
        place = find_place(pending);
      }
      m_places[place] = Index(m_points.size());
      m_points.push_back(pending.point);
    }
    m_indices.push_back(m_places[place]);
  }

  void grow()
  {
    m_places.assign(4 * m_places.size(), no_index);
    for (Index point = 0; point < m_points.size(); ++point) {
      m_places[find_place({m_points[point], hash_point(m_points[point])})] = point;
    }
  }

  std::vector<Index> m_places; // by hash
  std::vector<Vector3> m_points;
  std::vector<Index> m_indices;
  std::array<Pending, number_of_pending> m_pending;
  std::size_t m_number = 0; // of points that were added
};

/// Merges points of exactly equal coordinates into the first of them; the others keep their order. Linear.
/// \param[out] new_index for each old point, its new index
/// \return the number of points that vanished
/// \pre the points are finite
inline std::size_t merge_equal_points(std::vector<Vector3>& points, std::vector<Index>& new_index)
{
  const std::size_t size = points.size();
  Point_merger merger(size);
  for (const Vector3& point : points) {
    merger.add(point);
  }
  merger.move_to(points, new_index);
  return size - points.size();
}

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_POINT_MERGER_H
