// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which separators are in the way of each other.

#ifndef CSCD_SELECTION_SEPARATOR_OVERLAPS_H
#define CSCD_SELECTION_SEPARATOR_OVERLAPS_H

#include <CSCD/Selection/Separator_arrangement.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Epoch_marks.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// The end of the crossed edge that `crossing` is closer to; in the middle, the same one in either direction.
inline Index nearest_vertex(const Triangulated_surface& surface, const Edge_crossing& crossing)
{
  const Index edge = surface.edge(crossing.halfedge);
  const double position = edge == crossing.halfedge ? crossing.position : 1 - crossing.position;
  return position < 0.5 ? surface.origin(edge) : surface.target(edge);
}

/// The pairs of separators that overlap: that pass closest to the same vertex.
///
/// Among these are all that cross in a face (appendix C). For let a chord cut the corner c off a face with the other
/// corners x and y, and cross another one: that has one end on c's side, say on the edge to x. If the first chord
/// meets this edge nearer to c than to x, both pass closest to c; if it meets it nearer to x, and so does the second
/// one, both pass closest to x. If the second one alone is nearer to c, the first one passes closest to c too, on the
/// edge to y, or passes closest to both x and y; and the other end of the second one, which is not on c's side, is
/// nearest to one of these. There are no parallel lines, vertices or edges to be treated in a special way. Separators
/// that coincide, and so do not cross, overlap too. And each of a set without overlaps has a closed ring of vertices of
/// its own: its part of the surface is never empty and always connected.
class Separator_overlaps
{
public:
  /// Finds all overlaps; linear in the number of crossings and of pairs that meet at a vertex.
  Separator_overlaps(const Triangulated_surface& surface, const std::vector<Separator>& separators)
      : m_surface(surface), m_separators(separators), m_found(separators.size()), m_crosses_itself(separators.size(), 0)
  {
    list_passes();
    Separator_arrangement arrangement(surface);
    for (Index i = 0; i < separators.size(); ++i) {
      m_begin.push_back(m_others.size());
      m_found.clear();
      m_found.mark(i);
      collect_touching(i);
      arrangement.clear();
      m_crosses_itself[i] = arrangement.insert(i, separators[i].crossings) ? 0 : 1;
      std::sort(m_others.begin() + std::ptrdiff_t(m_begin.back()), m_others.end());
    }
    m_begin.push_back(m_others.size());
  }

  /// The separators that overlap `separator`, in ascending order.
  CGAL::Iterator_range<const Index*> others(Index separator) const
  {
    return {m_others.data() + m_begin[separator], m_others.data() + m_begin[separator + 1]};
  }
  /// Whether `separator` is no simple curve.
  bool crosses_itself(Index separator) const { return m_crosses_itself[separator] != 0; }

private:
  /// Lists for each vertex the separators that pass closest to it.
  void list_passes()
  {
    m_first_pass.assign(m_surface.number_of_vertices() + std::size_t(1), 0);
    for_each_pass([&](Index vertex, Index) { ++m_first_pass[vertex + 1]; });
    std::partial_sum(m_first_pass.begin(), m_first_pass.end(), m_first_pass.begin());
    m_passes.resize(m_first_pass.back());
    std::vector<std::size_t> fill(m_first_pass.begin(), m_first_pass.end() - 1);
    for_each_pass([&](Index vertex, Index separator) { m_passes[fill[vertex]++] = separator; });
  }

  /// Calls `function(vertex, separator)` once for all consecutive crossings that are closest to the same vertex.
  template <class Function>
  void for_each_pass(const Function& function) const
  {
    for (Index i = 0; i < m_separators.size(); ++i) {
      Index last = no_index;
      for (const Edge_crossing& crossing : m_separators[i].crossings) {
        const Index vertex = nearest_vertex(m_surface, crossing);
        if (vertex != last) {
          function(vertex, i);
        }
        last = vertex;
      }
    }
  }

  void collect_touching(Index separator)
  {
    Index last = no_index;
    for (const Edge_crossing& crossing : m_separators[separator].crossings) {
      const Index vertex = nearest_vertex(m_surface, crossing);
      if (vertex != last) {
        for (std::size_t i = m_first_pass[vertex]; i < m_first_pass[vertex + 1]; ++i) {
          add(m_passes[i]);
        }
      }
      last = vertex;
    }
  }

  void add(Index other)
  {
    if (m_found.mark(other)) {
      m_others.push_back(other);
    }
  }

  const Triangulated_surface& m_surface;
  const std::vector<Separator>& m_separators;
  Epoch_marks m_found;
  std::vector<std::size_t> m_first_pass;
  std::vector<Index> m_passes;
  std::vector<std::uint8_t> m_crosses_itself;
  std::vector<std::size_t> m_begin;
  std::vector<Index> m_others;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_OVERLAPS_H
