// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which separators overlap, and set packing by overlaps.

#ifndef CSCD_PUBLISHED_SEPARATOR_OVERLAPS_H
#define CSCD_PUBLISHED_SEPARATOR_OVERLAPS_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>
#include <CSCD/internal/Epoch_marks.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// For each of `separators`, 1 if it crosses itself in a face. Linear in the number of crossings.
/// \tparam Triangulation a model of `SurfaceTriangulation`
template <class Triangulation>
std::vector<std::uint8_t> find_self_crossings(const Triangulation& surface, const std::vector<Separator>& separators)
{
  std::vector<std::uint8_t> result;
  result.reserve(separators.size());
  Separator_arrangement_on<Triangulation> arrangement(surface);
  for (Index i = 0; i < separators.size(); ++i) {
    arrangement.clear();
    result.push_back(arrangement.insert(i, separators[i].crossings) ? 0 : 1);
  }
  return result;
}

/// For each of `separators`, 1 if it crosses an edge twice: among points there are no faces in which curves could be
/// followed more closely. Linear in the number of crossings.
inline std::vector<std::uint8_t> find_self_crossings(const Point_complex& surface,
                                                     const std::vector<Separator>& separators)
{
  std::vector<std::uint8_t> result;
  result.reserve(separators.size());
  Epoch_marks crossed(surface.number_of_halfedges());
  for (const Separator& separator : separators) {
    crossed.clear();
    const bool is_simple =
        std::all_of(separator.crossings.begin(), separator.crossings.end(),
                    [&](const Edge_crossing& crossing) { return crossed.mark(edge_of(surface, crossing.halfedge)); });
    result.push_back(is_simple ? 0 : 1);
  }
  return result;
}

/// The end of the crossed edge that `crossing` is closer to; in the middle, the same one in either direction.
template <class Surface>
Index nearest_vertex(const Surface& surface, const Edge_crossing& crossing)
{
  const Index edge = edge_of(surface, crossing.halfedge);
  const double position = edge == crossing.halfedge ? crossing.position : 1 - crossing.position;
  return position < 0.5 ? surface.origin(edge) : surface.target(edge);
}

/// Whether the segments from `a` to `b` and from `c` to `d` meet, which are given by barycentric coordinates: by
/// equations 7 and 8 of appendix C, and where the lines are parallel, if they are one and the segments have a point in
/// common.
inline bool do_segments_meet(const std::array<double, 2>& a, const std::array<double, 2>& b,
                             const std::array<double, 2>& c, const std::array<double, 2>& d)
{
  // Of areas in barycentric coordinates: rounding errors.
  constexpr double tolerance = 1e-12;
  const auto turn = [](const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  const double denominator = (a[0] - b[0]) * (d[1] - c[1]) - (d[0] - c[0]) * (a[1] - b[1]);
  if (std::abs(denominator) > tolerance) {
    const double first = (a[0] * (d[1] - c[1]) + c[0] * (a[1] - d[1]) + d[0] * (c[1] - a[1])) / denominator;
    const double second = (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1])) / denominator;
    return first >= 0 && first <= 1 && second >= 0 && second <= 1;
  }
  if (std::abs(turn(a, b, c)) > tolerance || std::abs(turn(c, d, a)) > tolerance) {
    return false;
  }
  const auto overlap = [&](std::size_t k) {
    return std::max(std::min(a[k], b[k]), std::min(c[k], d[k])) <= std::min(std::max(a[k], b[k]), std::max(c[k], d[k]));
  };
  return overlap(0) && overlap(1);
}

/// The pairs of separators that overlap: that pass closest to the same vertex, or as `Overlap_rule` says.
///
/// Among the pairs that pass closest to the same vertex are all that cross in a face (appendix C). For let a chord cut
/// the corner c off a face with the other corners x and y, and cross another one: that has one end on c's side, say on
/// the edge to x. If the first chord meets this edge nearer to c than to x, both pass closest to c; if it meets it
/// nearer to x, and so does the second one, both pass closest to x. If the second one alone is nearer to c, the first
/// one passes closest to c too, on the edge to y, or passes closest to both x and y; and the other end of the second
/// one, which is not on c's side, is nearest to one of these. There are no parallel lines, vertices or edges to be
/// treated in a special way. Separators that coincide, and so do not cross, overlap too. And each of a set without
/// overlaps has a closed ring of vertices of its own: its part of the surface is never empty and always connected.
class Separator_overlaps
{
public:
  /// Finds all overlaps; linear in the number of crossings and of pairs that meet at a vertex.
  /// \param surface whose edges the separators cross
  template <class Surface>
  Separator_overlaps(const Surface& surface, const std::vector<Separator>& separators)
      : Separator_overlaps(surface, separators, find_self_crossings(surface, separators))
  {
  }
  /// The same where it is known already which separators cross themselves.
  template <class Surface>
  Separator_overlaps(const Surface& surface, const std::vector<Separator>& separators,
                     std::vector<std::uint8_t> crosses_itself)
      : m_crosses_itself(std::move(crosses_itself))
  {
    collect_rings(surface, separators, [](const Edge_crossing&) { return true; });
    list_passes(surface.number_of_vertices());
    collect_others(Index(separators.size()), [](Index, Epoch_marks&) {});
  }
  /// Finds the pairs that meet: in a face, or at a vertex that both pass through. Linear in the number of crossings and
  /// of pairs of them in one face.
  /// \tparam Surface a model of `SurfaceTriangulation`
  template <class Surface>
  static Separator_overlaps meeting(const Surface& surface, const std::vector<Separator>& separators)
  {
    Separator_overlaps result;
    result.m_crosses_itself = find_self_crossings(surface, separators);
    result.collect_rings(surface, separators, [](const Edge_crossing& crossing) {
      return std::min(crossing.position, 1 - crossing.position) <= vertex_offset;
    });
    result.list_passes(surface.number_of_vertices());
    result.list_chords(surface, separators);
    result.collect_others(Index(separators.size()),
                          [&result](Index separator, Epoch_marks& found) { result.collect_meeting(separator, found); });
    return result;
  }

  /// The separators that overlap `separator`, in ascending order.
  CGAL::Iterator_range<const Index*> others(Index separator) const
  {
    return {m_others.data() + m_begin[separator], m_others.data() + m_begin[separator + 1]};
  }
  /// Whether `separator` is no simple curve.
  bool crosses_itself(Index separator) const { return m_crosses_itself[separator] != 0; }

private:
  /// A piece of a separator in a face, between two barycentric coordinates of its ends each.
  struct Chord
  {
    Index separator;
    Index face;
    std::array<double, 2> begin;
    std::array<double, 2> end;
  };

  Separator_overlaps() = default;

  /// Lists for each separator the vertices that it passes closest to where `is_passing(crossing)` holds, each once for
  /// consecutive crossings.
  template <class Surface, class Predicate>
  void collect_rings(const Surface& surface, const std::vector<Separator>& separators, const Predicate& is_passing)
  {
    for (const Separator& separator : separators) {
      m_ring_begin.push_back(m_rings.size());
      for (const Edge_crossing& crossing : separator.crossings) {
        const Index vertex = nearest_vertex(surface, crossing);
        if (is_passing(crossing) && (m_rings.size() == m_ring_begin.back() || m_rings.back() != vertex)) {
          m_rings.push_back(vertex);
        }
      }
    }
    m_ring_begin.push_back(m_rings.size());
  }

  CGAL::Iterator_range<const Index*> ring(Index separator) const
  {
    return {m_rings.data() + m_ring_begin[separator], m_rings.data() + m_ring_begin[separator + 1]};
  }

  /// Lists for each vertex the separators that pass closest to it.
  void list_passes(std::size_t number_of_vertices)
  {
    m_passes = Compressed_rows<Index, std::size_t>(number_of_vertices, [this](const auto& add) {
      for (Index separator = 0; separator + 1 < m_ring_begin.size(); ++separator) {
        for (const Index vertex : ring(separator)) {
          add(vertex, separator);
        }
      }
    });
  }

  /// Collects the others of all separators: those that touch at a vertex, and what `collect_more(separator, found)`
  /// adds.
  template <class Function>
  void collect_others(Index number_of_separators, const Function& collect_more)
  {
    Epoch_marks found(number_of_separators);
    for (Index i = 0; i < number_of_separators; ++i) {
      m_begin.push_back(m_others.size());
      found.clear();
      found.mark(i);
      collect_touching(i, found);
      collect_more(i, found);
      std::sort(m_others.begin() + std::ptrdiff_t(m_begin.back()), m_others.end());
    }
    m_begin.push_back(m_others.size());
  }

  /// Lists the chords of all separators, one after the other, and those in each face.
  template <class Surface>
  void list_chords(const Surface& surface, const std::vector<Separator>& separators)
  {
    const auto coordinates = [](Index side, double position) {
      std::array<double, 3> weights{};
      weights[side] = 1 - position;
      weights[(side + 1) % 3] = position;
      return std::array<double, 2>{weights[0], weights[1]};
    };
    for (Index i = 0; i < separators.size(); ++i) {
      m_first_chord.push_back(m_chords.size());
      const std::vector<Edge_crossing>& crossings = separators[i].crossings;
      for (std::size_t k = 0; k < crossings.size(); ++k) {
        const Edge_crossing& before = crossings[k > 0 ? k - 1 : crossings.size() - 1];
        m_chords.push_back({i, Surface::face(crossings[k].halfedge),
                            coordinates(surface.twin(before.halfedge) % 3, 1 - before.position),
                            coordinates(crossings[k].halfedge % 3, crossings[k].position)});
      }
    }
    m_first_chord.push_back(m_chords.size());
    m_chords_in_face = Compressed_rows<Index, std::size_t>(surface.number_of_faces(), [this](const auto& add) {
      for (Index chord = 0; chord < m_chords.size(); ++chord) {
        add(m_chords[chord].face, chord);
      }
    });
  }

  void collect_meeting(Index separator, Epoch_marks& found)
  {
    for (std::size_t k = m_first_chord[separator]; k < m_first_chord[separator + 1]; ++k) {
      const Chord& chord = m_chords[k];
      for (const Index other : m_chords_in_face[chord.face]) {
        const Chord& candidate = m_chords[other];
        if (!found.is_marked(candidate.separator) &&
            do_segments_meet(chord.begin, chord.end, candidate.begin, candidate.end)) {
          found.mark(candidate.separator);
          m_others.push_back(candidate.separator);
        }
      }
    }
  }

  void collect_touching(Index separator, Epoch_marks& found)
  {
    for (const Index vertex : ring(separator)) {
      for (const Index other : m_passes[vertex]) {
        if (found.mark(other)) {
          m_others.push_back(other);
        }
      }
    }
  }

  std::vector<std::uint8_t> m_crosses_itself;
  std::vector<std::size_t> m_ring_begin; ///< of every separator
  std::vector<Index> m_rings;
  Compressed_rows<Index, std::size_t> m_passes; ///< of every vertex
  std::vector<Chord> m_chords;
  std::vector<std::size_t> m_first_chord; ///< of every separator
  Compressed_rows<Index, std::size_t> m_chords_in_face;
  std::vector<std::size_t> m_begin;
  std::vector<Index> m_others;
};

/// Packs separators that do not overlap, greedily (section 3.2.3): first those whose weight is large against the
/// weights of all that they would exclude, w / (1 + sum of the w of its overlaps), as Baerentzen and Rotenberg order
/// local separators.
/// \param weights for each separator, how good it is; those of weight 0 and those that cross themselves are not packed
/// \return the packed separators, the first packed first; equal ones in the order of their numbers
inline std::vector<Index> pack_by_overlap(const Separator_overlaps& overlaps, const std::vector<double>& weights)
{
  const std::size_t size = weights.size();
  std::vector<double> order_weight(size, 0);
  std::vector<Index> order;
  const auto is_allowed = [&](Index i) { return weights[i] > 0 && !overlaps.crosses_itself(i); };
  for (Index i = 0; i < size; ++i) {
    if (!is_allowed(i)) {
      continue;
    }
    double excluded = 0;
    for (Index other : overlaps.others(i)) {
      excluded += is_allowed(other) ? weights[other] : 0;
    }
    order_weight[i] = weights[i] / (1 + excluded);
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return order_weight[a] > order_weight[b]; });
  std::vector<std::uint8_t> is_packed(size, 0);
  std::vector<Index> packed;
  for (Index i : order) {
    const auto others = overlaps.others(i);
    if (std::none_of(others.begin(), others.end(), [&](Index other) { return is_packed[other] != 0; })) {
      is_packed[i] = 1;
      packed.push_back(i);
    }
  }
  return packed;
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SEPARATOR_OVERLAPS_H
