// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The crossings of separators, and the pieces of a surface cut by disjoint ones.

#ifndef CSCD_PACKING_CUT_GRAPH_H
#define CSCD_PACKING_CUT_GRAPH_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
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

  /// A piece of a separator within one face, from one edge point to the next; it has the number of its end.
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

  /// Removes all separators; linear in the number of their crossings.
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
        for (; m_chords.size() > first_chord; m_chords.pop_back()) {
          m_first_chord[m_chords.back().face] = m_chords.back().next;
        }
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

  /// The total order of the crossings of one edge, along its smaller halfedge.
  static bool is_before_on_edge(const Edge_point& a, const Edge_point& b)
  {
    return std::tie(a.position, a.separator, a.rank) < std::tie(b.position, b.separator, b.rank);
  }

  /// All points, sorted by edges, and along these. O(m log m).
  std::vector<Index> points_along_edges() const
  {
    std::vector<Index> result = all_indices(m_points.size());
    std::sort(result.begin(), result.end(), [&](Index a, Index b) {
      return m_points[a].edge != m_points[b].edge ? m_points[a].edge < m_points[b].edge
                                                  : is_before_on_edge(m_points[a], m_points[b]);
    });
    return result;
  }

  /// Moves points at the same position of an edge apart, in their order, so that there is room between them.
  /// O(m log m).
  void spread_points()
  {
    const std::vector<Index> order = points_along_edges();
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < order.size(); begin = end) {
      const auto [edge, position, separator, rank] = m_points[order[begin]];
      end = begin + 1;
      while (end < order.size() && m_points[order[end]].edge == edge && m_points[order[end]].position == position) {
        ++end;
      }
      const bool is_last = end == order.size() || m_points[order[end]].edge != edge;
      const double room = (is_last ? 1 : m_points[order[end]].position) - position;
      for (std::size_t i = begin + 1; i < end; ++i) {
        m_points[order[i]].position += room * double(i - begin) / double(end - begin);
      }
    }
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

  /// Whether the separator crosses the edge of `point` from its greater halfedge.
  bool leaves_reversed(Index point) const { return is_reversed(m_points[point].edge, m_chords[point].face); }

  /// The part of the area of its face that `chord` cuts off from the corner where the sides of the face begin.
  double part_cut_off(const Chord& chord) const
  {
    Index low = chord.begin;
    Index high = chord.end;
    if (is_before(high, low, chord.face)) {
      std::swap(low, high);
    }
    const Index first_side = side(m_points[low].edge, chord.face);
    const Index last_side = side(m_points[high].edge, chord.face);
    const double from = position_along_side(low, chord.face);
    const double to = position_along_side(high, chord.face);
    if (first_side == last_side) {
      return 0;
    }
    return last_side - first_side == 1 ? (1 - from) * to : 1 - from * (1 - to);
  }

private:
  static bool is_reversed(Index edge, Index face) { return Triangulation::face(edge) != face; }

  /// The side of `face`, 0 to 2, that lies on `edge`.
  Index side(Index edge, Index face) const { return (is_reversed(edge, face) ? m_surface.twin(edge) : edge) % 3; }

  double position_along_side(Index point, Index face) const
  {
    return is_reversed(m_points[point].edge, face) ? 1 - m_points[point].position : m_points[point].position;
  }

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

  const Triangulation& m_surface;
  std::vector<Index> m_first_chord;
  std::vector<Edge_point> m_points;
  std::vector<Chord> m_chords;
};

/// The arrangements of the local method.
using Separator_arrangement = Separator_arrangement_on<Triangulated_surface>;

/// The parts that the points of an arrangement divide edges into. A part at an end of its edge has the number of the
/// vertex there, the others follow the vertices.
struct Edge_parts
{
  /// O(m log m) for m points.
  Edge_parts(const Triangulated_surface& surface, const Separator_arrangement& arrangement)
      : size(surface.number_of_vertices()), left(arrangement.points().size()), right(left.size())
  {
    const std::vector<Separator_arrangement::Edge_point>& points = arrangement.points();
    const std::vector<Index> order = arrangement.points_along_edges();
    Index after = no_index;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Index edge = points[order[i]].edge;
      const bool is_first = i == 0 || points[order[i - 1]].edge != edge;
      const bool is_last = i + 1 == order.size() || points[order[i + 1]].edge != edge;
      const Index before = is_first ? surface.origin(edge) : after;
      after = is_last ? surface.target(edge) : size++;
      const bool is_reversed = arrangement.leaves_reversed(order[i]);
      left[order[i]] = is_reversed ? before : after;
      right[order[i]] = is_reversed ? after : before;
    }
  }

  Index size;               ///< the number of parts and of vertices
  std::vector<Index> left;  ///< for each point, the part on the left of its separator
  std::vector<Index> right; ///< likewise
};

/// The surface cut along disjoint separators: a graph whose vertices are the pieces and whose edges are the separators.
/// Its first Betti number is at most the genus of the surface, and equal to it if no piece has a handle.
class Cut_graph
{
public:
  /// A piece of the surface.
  struct Piece
  {
    std::vector<Index>
        separators; ///< positions of the separators around it; one that it has on both sides stands twice
    double area = 0;
    int euler = 0; ///< Euler number of the piece with its boundary

    /// Handles that no separator cuts.
    int genus() const { return (2 - euler - int(separators.size())) / 2; }
  };

  /// The pieces on the two sides of a separator; the same one twice where the separator does not disconnect anything.
  struct Sides
  {
    Index right;
    Index left; ///< where the normal of the separator points to
    Index other(Index piece) const { return right == piece ? left : right; }
  };

  /// Cuts `surface` along the separators in `arrangement`; their positions are those in the order of insertion.
  /// Near-linear in the size of the surface, and O(m log m) in the number m of crossings.
  Cut_graph(const Triangulated_surface& surface, const Separator_arrangement& arrangement)
  {
    const Edge_parts parts(surface, arrangement);
    label_pieces(surface, arrangement, parts);
    measure_pieces(surface, arrangement, parts);
    for (Index point = 0; point < parts.left.size(); ++point) {
      if (arrangement.points()[point].rank == 0) {
        const auto separator = Index(m_sides.size());
        m_sides.push_back({m_piece[parts.right[point]], m_piece[parts.left[point]]});
        m_pieces[m_sides.back().right].separators.push_back(separator);
        m_pieces[m_sides.back().left].separators.push_back(separator);
      }
    }
  }

  const std::vector<Piece>& pieces() const { return m_pieces; }
  /// The pieces on the two sides of the packed separator at position `i`.
  const Sides& sides(Index i) const { return m_sides[i]; }
  Index piece_of_vertex(Index vertex) const { return m_piece[vertex]; }

private:
  /// Numbers the pieces by their first vertex.
  void label_pieces(const Triangulated_surface& surface, const Separator_arrangement& arrangement,
                    const Edge_parts& parts)
  {
    std::vector<char> is_cut(surface.number_of_halfedges(), 0);
    for (const Separator_arrangement::Edge_point& point : arrangement.points()) {
      is_cut[point.edge] = 1;
    }
    Disjoint_sets sets(parts.size);
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (surface.edge(h) == h && is_cut[h] == 0) {
        sets.join(surface.origin(h), surface.target(h));
      }
    }
    // All that is between two chords of a face borders on one of them: this joins all parts that a face connects.
    for (const Separator_arrangement::Chord& chord : arrangement.chords()) {
      sets.join(parts.left[chord.begin], parts.left[chord.end]);
      sets.join(parts.right[chord.begin], parts.right[chord.end]);
    }
    Index number_of_pieces = 0;
    m_piece = sets.numbers(number_of_pieces);
    m_pieces.assign(number_of_pieces, Piece());
  }

  /// Area and Euler number. The points and chords of a separator are equally many on each of its sides and cancel in
  /// the Euler number: vertices, parts of edges and parts of faces count. Each edge and each face counts where it
  /// begins; then each point adds the part of the edge after it, and each chord the part of the face that it cuts off
  /// from where the face begins.
  void measure_pieces(const Triangulated_surface& surface, const Separator_arrangement& arrangement,
                      const Edge_parts& parts)
  {
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      ++m_pieces[m_piece[vertex]].euler;
    }
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      m_pieces[m_piece[surface.origin(h)]].euler -= surface.edge(h) == h ? 1 : 0;
    }
    for (Index face = 0; face < surface.number_of_faces(); ++face) {
      Piece& piece = m_pieces[m_piece[surface.origin(3 * face)]];
      ++piece.euler;
      piece.area += double(surface.face_area(face));
    }
    for (const Separator_arrangement::Chord& chord : arrangement.chords()) {
      Piece& left = m_pieces[m_piece[parts.left[chord.end]]];
      Piece& right = m_pieces[m_piece[parts.right[chord.end]]];
      --(arrangement.leaves_reversed(chord.end) ? right : left).euler;
      const bool cuts_off_right = arrangement.is_before(chord.begin, chord.end, chord.face);
      ++(cuts_off_right ? right : left).euler;
      const double area = double(surface.face_area(chord.face)) * arrangement.part_cut_off(chord);
      right.area += cuts_off_right ? area : -area;
      left.area -= cuts_off_right ? area : -area;
    }
  }

  std::vector<Index> m_piece; ///< of every vertex, and of every inner part of an edge
  std::vector<Piece> m_pieces;
  std::vector<Sides> m_sides;
};

} // namespace CSCD::internal

#endif // CSCD_PACKING_CUT_GRAPH_H
