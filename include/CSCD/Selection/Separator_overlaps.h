// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which separators are in the way of each other.

#ifndef CSCD_SELECTION_SEPARATOR_OVERLAPS_H
#define CSCD_SELECTION_SEPARATOR_OVERLAPS_H

#include <CSCD/Selection/Separator_arrangement.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The end of the crossed edge that `crossing` is closer to.
inline Index nearest_vertex(const Triangulated_surface& surface, const Edge_crossing& crossing)
{
  return crossing.position < 0.5 ? surface.origin(crossing.halfedge) : surface.target(crossing.halfedge);
}

/// The pairs of separators that overlap: that cross in a face (appendix C), or pass closest to the same vertex. The
/// second keeps apart separators that coincide and so do not cross, and leaves to each of a disjoint set a closed ring
/// of vertices of its own: its part of the surface is never empty and always connected.
class Separator_overlaps
{
public:
  /// Finds all overlaps; linear in the number of crossings and of pairs that meet in a face or at a vertex.
  Separator_overlaps(const Triangulated_surface& surface, const std::vector<Separator>& separators)
      : m_crosses_itself(separators.size(), 0), m_begin(separators.size() + 1, 0)
  {
    std::vector<std::pair<Index, Index>> pairs;
    collect_crossing_pairs(surface, separators, pairs);
    collect_touching_pairs(surface, separators, pairs);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    m_others.reserve(pairs.size());
    for (const auto& [separator, other] : pairs) {
      ++m_begin[separator + 1];
      m_others.push_back(other);
    }
    for (std::size_t i = 1; i < m_begin.size(); ++i) {
      m_begin[i] += m_begin[i - 1];
    }
  }

  /// The separators that overlap `separator`, in ascending order.
  CGAL::Iterator_range<const Index*> others(Index separator) const
  {
    return {m_others.data() + m_begin[separator], m_others.data() + m_begin[separator + 1]};
  }
  /// Whether `separator` is no simple curve.
  bool crosses_itself(Index separator) const { return m_crosses_itself[separator] != 0; }

private:
  void collect_crossing_pairs(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                              std::vector<std::pair<Index, Index>>& pairs)
  {
    Separator_arrangement arrangement(surface);
    for (Index i = 0; i < separators.size(); ++i) {
      arrangement.append(i, separators[i].crossings);
    }
    for (const Separator_arrangement::Chord& chord : arrangement.chords()) {
      const Index separator = arrangement.points()[chord.begin].separator;
      for (Index i = chord.next; i != no_index; i = arrangement.chords()[i].next) {
        if (!arrangement.do_cross(chord, arrangement.chords()[i])) {
          continue;
        }
        const Index other = arrangement.points()[arrangement.chords()[i].begin].separator;
        if (other == separator) {
          m_crosses_itself[separator] = 1;
        } else {
          pairs.emplace_back(separator, other);
          pairs.emplace_back(other, separator);
        }
      }
    }
  }

  static void collect_touching_pairs(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                                     std::vector<std::pair<Index, Index>>& pairs)
  {
    std::vector<std::pair<Index, Index>> touches;
    for (Index i = 0; i < separators.size(); ++i) {
      for (const Edge_crossing& crossing : separators[i].crossings) {
        touches.emplace_back(nearest_vertex(surface, crossing), i);
      }
    }
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
    for (auto begin = touches.begin(); begin != touches.end();) {
      const auto end =
          std::find_if(begin, touches.end(), [&](const auto& touch) { return touch.first != begin->first; });
      for (auto a = begin; a != end; ++a) {
        for (auto b = begin; b != end; ++b) {
          if (a != b) {
            pairs.emplace_back(a->second, b->second);
          }
        }
      }
      begin = end;
    }
  }

  std::vector<std::uint8_t> m_crosses_itself;
  std::vector<std::size_t> m_begin;
  std::vector<Index> m_others;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_OVERLAPS_H
