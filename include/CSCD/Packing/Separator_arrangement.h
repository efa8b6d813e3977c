// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint separators on a surface, face by face.

#ifndef CSCD_PACKING_SEPARATOR_ARRANGEMENT_H
#define CSCD_PACKING_SEPARATOR_ARRANGEMENT_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A set of simple, pairwise disjoint separators, held as chords in the faces that they pass.
/// Whether two chords cross is decided by the order of their ends around the face alone. The order along an edge is
/// total: crossings at the same position are told apart by their separators, as if moved by infinitesimal amounts, and
/// alike from both faces of the edge. So the answer is exact and consistent for any positions.
/// \tparam Triangulation a model of `SurfaceTriangulation`
template <class Triangulation>
class Separator_arrangement_on
{
public:
  /// A point where a separator crosses an edge.
  struct Edge_point
  {
    Index edge;      ///< the smaller halfedge of the edge
    double position; ///< along that halfedge
    Index separator;
    Index rank; ///< in the list of crossings of the separator
  };

  /// A piece of a separator within one face, from one edge point to the next.
  struct Chord
  {
    Index begin; ///< index of an edge point
    Index end;   ///< index of an edge point
    Index face;
    Index next; ///< index of another chord in the same face, or `no_index`
  };

  explicit Separator_arrangement_on(const Triangulation& surface)
      : m_surface(surface), m_first_chord(surface.number_of_faces(), no_index)
  {
  }

  /// Removes all separators; linear in what they cross.
  void clear()
  {
    for (const Chord& chord : m_chords) {
      m_first_chord[chord.face] = no_index;
    }
    m_chords.clear();
    m_points.clear();
  }

  /// Inserts `separator` unless it crosses itself or one that is there.
  /// \param crossings the crossings of the separator \return whether it was inserted
  bool insert(Index separator, const std::vector<Edge_crossing>& crossings)
  {
    const std::size_t size = crossings.size();
    const auto first_point = Index(m_points.size());
    const std::size_t first_chord = m_chords.size();
    for (std::size_t i = 0; i < size; ++i) {
      const Edge_crossing& crossing = crossings[i];
      const Index edge = edge_of(m_surface, crossing.halfedge);
      const double position = edge == crossing.halfedge ? crossing.position : 1 - crossing.position;
      m_points.push_back({edge, position, separator, Index(i)});
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Index face = Triangulation::face(crossings[i].halfedge);
      const Chord chord{first_point + Index(i > 0 ? i - 1 : size - 1), first_point + Index(i), face,
                        m_first_chord[face]};
      if (crosses_any(chord)) {
        remove_from(first_chord);
        m_points.resize(first_point);
        return false;
      }
      m_first_chord[face] = Index(m_chords.size());
      m_chords.push_back(chord);
    }
    return true;
  }

  const std::vector<Edge_point>& points() const { return m_points; }
  const std::vector<Chord>& chords() const { return m_chords; }
  /// The first of the chords in `face`, `no_index` if there is none.
  Index first_chord(Index face) const { return m_first_chord[face]; }

  /// The total order of the crossings of one edge, along its smaller halfedge.
  static bool is_before_on_edge(const Edge_point& a, const Edge_point& b)
  {
    return std::tie(a.position, a.separator, a.rank) < std::tie(b.position, b.separator, b.rank);
  }

  /// Whether point `a` comes before point `b` on the way around `face`.
  bool is_before(Index a, Index b, Index face) const
  {
    const Edge_point& p = m_points[a];
    const Edge_point& q = m_points[b];
    if (p.edge == q.edge) {
      return is_reversed(p.edge, face) ? is_before_on_edge(q, p) : is_before_on_edge(p, q);
    }
    return side(p.edge, face) < side(q.edge, face);
  }

  /// The side of `face`, 0 to 2, that lies on `edge`.
  Index side(Index edge, Index face) const { return (is_reversed(edge, face) ? m_surface.twin(edge) : edge) % 3; }

private:
  static bool is_reversed(Index edge, Index face) { return Triangulation::face(edge) != face; }

  bool crosses_any(const Chord& chord) const
  {
    const Index face = chord.face;
    Index low = chord.begin;
    Index high = chord.end;
    if (is_before(high, low, face)) {
      std::swap(low, high);
    }
    const auto is_between = [&](Index point) { return is_before(low, point, face) && is_before(point, high, face); };
    for (Index other = chord.next; other != no_index; other = m_chords[other].next) {
      if (is_between(m_chords[other].begin) != is_between(m_chords[other].end)) {
        return true;
      }
    }
    return false;
  }

  void remove_from(std::size_t first_chord)
  {
    while (m_chords.size() > first_chord) {
      m_first_chord[m_chords.back().face] = m_chords.back().next;
      m_chords.pop_back();
    }
  }

  const Triangulation& m_surface;
  std::vector<Index> m_first_chord;
  std::vector<Edge_point> m_points;
  std::vector<Chord> m_chords;
};

/// The arrangements of the local method.
using Separator_arrangement = Separator_arrangement_on<Triangulated_surface>;

} // namespace CSCD::internal

#endif // CSCD_PACKING_SEPARATOR_ARRANGEMENT_H
