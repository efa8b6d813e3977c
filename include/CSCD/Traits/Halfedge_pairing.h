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
#include <cstdint>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// The sides of a set of triangles as halfedges: `h` runs along side `h % 3` of face `h / 3`.
class Halfedge_pairing
{
public:
  Halfedge_pairing() = default;

  /// Pairs the halfedges of `faces`, whose corners are numbers below `number_of_points`; linear, whatever the degrees.
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
  /// Buckets the halfedges by their smaller end, then pairs each bucket through one slot for every larger end.
  void pair(const Index* origin, std::size_t number_of_points)
  {
    const Index n = number_of_halfedges();
    const auto smaller_end = [origin](Index h) { return std::min(origin[h], origin[next(h)]); };
    std::vector<Index> begin(number_of_points + 1, 0);
    for (Index h = 0; h < n; ++h) {
      ++begin[smaller_end(h) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> fill(begin.begin(), begin.end() - 1);
    std::vector<Index> bucket(n);
    for (Index h = 0; h < n; ++h) {
      bucket[fill[smaller_end(h)]++] = h;
    }
    std::vector<Slot> slots(number_of_points);
    for (Index vertex = 0; vertex < number_of_points && m_conflict == no_index; ++vertex) {
      pair_bucket(origin, vertex, bucket.data() + begin[vertex], bucket.data() + begin[vertex + 1], slots);
    }
    m_has_border = std::find(m_twin.begin(), m_twin.end(), no_index) != m_twin.end();
  }

  /// The last halfedge seen at the vertex of the slot, and the smaller end for which it was seen.
  struct Slot
  {
    Index smaller_end = no_index;
    Index halfedge = no_index;
  };

  void pair_bucket(const Index* origin, Index vertex, const Index* first, const Index* last, std::vector<Slot>& slots)
  {
    for (const Index* it = first; it != last; ++it) {
      if (origin[*it] == vertex) {
        Slot& slot = slots[origin[next(*it)]];
        if (slot.smaller_end == vertex) {
          m_conflict = *it;
        }
        slot = {vertex, *it};
      }
    }
    for (const Index* it = first; it != last; ++it) {
      if (origin[*it] == vertex) {
        continue;
      }
      Slot& slot = slots[origin[*it]];
      if (slot.smaller_end != vertex) {
        slot = {vertex, *it};
      } else if (origin[slot.halfedge] == vertex && m_twin[slot.halfedge] == no_index) {
        m_twin[*it] = slot.halfedge;
        m_twin[slot.halfedge] = *it;
      } else {
        m_conflict = *it;
      }
    }
  }

  std::vector<Index> m_twin;
  Index m_conflict = no_index;
  bool m_has_border = false;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_HALFEDGE_PAIRING_H
