// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The partner of every halfedge of a set of triangles, whether or not the triangles form a surface.

#ifndef CSCD_TRAITS_HALFEDGE_PAIRING_H
#define CSCD_TRAITS_HALFEDGE_PAIRING_H

#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// The sides of a set of triangles as halfedges: `h` runs along side `h % 3` of face `h / 3`.
class Halfedge_pairing
{
public:
  Halfedge_pairing() = default;

  /// Pairs the halfedges of `faces`, of which there are less than 2^29, by the numbers of their ends; near linear,
  /// whatever the degrees.
  /// \pre the corners of `faces` are less than `number_of_points`, and each face has three different ones
  Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points)
      : m_twin(3 * faces.size(), no_index)
  {
    if (!faces.empty()) {
      pair(faces.front().data(), number_of_points);
    }
  }

  static Index next(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
  static Index previous(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }

  Index number_of_halfedges() const { return Index(m_twin.size()); }
  /// The oppositely directed halfedge of the same edge; `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  /// A halfedge that has the ends and the direction of another one, or `no_index`: two faces are then oriented
  /// inconsistently, or more than two meet in one edge.
  Index conflict() const { return m_conflict; }
  bool has_border() const { return m_has_border; }

private:
  /// A halfedge in the bucket of its smaller end.
  struct Entry
  {
    Index larger_end;
    Index code; ///< twice the halfedge, and one more if it leaves the smaller end

    Index halfedge() const { return code / 2; }
    bool operator<(const Entry& other) const
    {
      return std::tie(larger_end, code) < std::tie(other.larger_end, other.code);
    }
  };

  /// Buckets of more entries than this are sorted, so that vertices of high degree do not cost their degree squared.
  static constexpr std::ptrdiff_t small_bucket = 32;

  void pair(const Index* origin, std::size_t number_of_points)
  {
    const Index n = number_of_halfedges();
    std::vector<Index> begin(number_of_points + 1, 0);
    for (Index h = 0; h < n; ++h) {
      ++begin[std::min(origin[h], origin[next(h)]) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> fill(begin.begin(), begin.end() - 1);
    std::vector<Entry> entries(n);
    for (Index h = 0; h < n; ++h) {
      const auto [smaller, larger] = std::minmax(origin[h], origin[next(h)]);
      entries[fill[smaller]++] = {larger, 2 * h + (origin[h] == smaller)};
    }
    for (std::size_t vertex = 0; vertex < number_of_points && m_conflict == no_index; ++vertex) {
      pair_bucket(entries.data() + begin[vertex], entries.data() + begin[vertex + 1]);
    }
    m_has_border = std::find(m_twin.begin(), m_twin.end(), no_index) != m_twin.end();
  }

  void pair_bucket(Entry* first, Entry* last)
  {
    const bool is_sorted = last - first > small_bucket;
    if (is_sorted) {
      std::sort(first, last);
    }
    for (; first != last; ++first) {
      if (m_twin[first->halfedge()] == no_index) {
        pair_first(*first, first + 1, last, is_sorted);
      }
    }
  }

  /// Finds the partner of `entry`, the first halfedge of its edge, among the others of its bucket.
  void pair_first(const Entry& entry, const Entry* other, const Entry* last, bool is_sorted)
  {
    Index& twin = m_twin[entry.halfedge()];
    for (; other != last; ++other) {
      if (other->larger_end != entry.larger_end) {
        if (is_sorted) {
          return;
        }
        continue;
      }
      if (twin != no_index || other->code % 2 == entry.code % 2) {
        m_conflict = other->halfedge();
        return;
      }
      twin = other->halfedge();
      m_twin[twin] = entry.halfedge();
    }
  }

  std::vector<Index> m_twin;
  Index m_conflict = no_index;
  bool m_has_border = false;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_HALFEDGE_PAIRING_H
