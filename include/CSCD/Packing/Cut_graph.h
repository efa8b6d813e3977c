// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The crossings of separators, and the pieces of a surface cut by disjoint ones.

#ifndef CSCD_PACKING_CUT_GRAPH_H
#define CSCD_PACKING_CUT_GRAPH_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
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

  /// An end of a chord.
  struct Chord_end
  {
    Index point; ///< index of an edge point
    Index chord;
    bool is_last; ///< whether the chord ends there, else it begins
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
  /// The first of the chords in `face`, `no_index` without a chord.
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

  /// Writes the ends of the chords of `face` to `ends`, in their order around it.
  void collect_ends(Index face, std::vector<Chord_end>& ends) const
  {
    ends.clear();
    for (Index i = first_chord(face); i != no_index; i = m_chords[i].next) {
      ends.push_back({m_chords[i].begin, i, false});
      ends.push_back({m_chords[i].end, i, true});
    }
    std::sort(ends.begin(), ends.end(),
              [&](const Chord_end& a, const Chord_end& b) { return is_before(a.point, b.point, face); });
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

  /// The pieces on the two sides of a separator, in no particular order; the same one twice where the separator does
  /// not disconnect anything.
  struct Sides
  {
    Index first;
    Index second;
    Index other(Index piece) const { return first == piece ? second : first; }
  };

  /// Prepares to cut `surface` along any of `separators`: parts that none of them crosses are joined once and for all.
  Cut_graph(const Triangulated_surface& surface, const std::vector<Separator>& separators) : Cut_graph(surface)
  {
    for (const Separator& separator : separators) {
      for (const Edge_crossing& crossing : separator.crossings) {
        m_crossed_edge[surface.edge(crossing.halfedge)] = 1;
      }
    }
    gather();
  }

  /// Prepares to cut `surface` along the separators in `arrangement` alone.
  Cut_graph(const Triangulated_surface& surface, const Separator_arrangement& arrangement) : Cut_graph(surface)
  {
    for (const Separator_arrangement::Edge_point& point : arrangement.points()) {
      m_crossed_edge[point.edge] = 1;
    }
    gather();
  }

  /// Cuts along the separators in `arrangement`; their positions are those in the order of insertion.
  /// Linear in the number of edges that any separator crosses, and O(m log m) in the number m of crossings.
  void cut(const Separator_arrangement& arrangement)
  {
    m_sets = Disjoint_sets(m_clusters.size());
    split_edges(arrangement);
    join_remaining_edges();
    split_faces(arrangement);
    label_pieces();
    measure_pieces(arrangement);
    find_sides(arrangement);
  }

  const std::vector<Piece>& pieces() const { return m_pieces; }
  /// The pieces on the two sides of the packed separator at position `i`.
  const Sides& sides(Index i) const { return m_sides[i]; }
  Index piece_of_vertex(Index vertex) const { return m_label[m_cluster[vertex]]; }

private:
  explicit Cut_graph(const Triangulated_surface& surface)
      : m_surface(surface), m_crossed_edge(surface.number_of_halfedges(), 0)
  {
  }

  /// A part of a face between chords, while the boundary of the face is walked.
  struct Open_chord
  {
    Index chord;
    Index interval;       ///< the set of the boundary just before the chord begins
    double taken_outside; ///< part of the face that chords before this one have cut off from the same region
    double begin_place;   ///< where the chord begins, in the order around the face
  };

  /// Vertices that every cut leaves joined, with the edges and faces between them.
  struct Cluster
  {
    int euler; ///< its vertices, edges and faces, counted as for the Euler number
    double area;
  };

  /// Joins parts that cannot be cut to clusters, and sums them up. Reads faces in the order of memory, to avoid cache
  /// misses.
  void gather()
  {
    Disjoint_sets joined(m_surface.number_of_vertices());
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      if (m_surface.edge(h) != h) {
        continue;
      }
      if (m_crossed_edge[h] != 0) {
        m_crossable_edges.push_back(h);
      } else {
        joined.join(m_surface.origin(h), m_surface.target(h));
      }
    }
    Index number_of_clusters = 0;
    m_cluster = joined.numbers(number_of_clusters);
    m_clusters.assign(number_of_clusters, {0, 0});
    for (const Index cluster : m_cluster) {
      ++m_clusters[cluster].euler;
    }
    for (Index face = 0; face < m_surface.number_of_faces(); ++face) {
      gather_face(face);
    }
  }

  /// Counts the edges that have `face` as their first face, and `face` itself unless it can be cut.
  void gather_face(Index face)
  {
    bool is_crossable = false;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index edge = m_surface.edge(h);
      if (m_crossed_edge[edge] != 0) {
        is_crossable = true;
      } else if (edge == h) {
        --m_clusters[m_cluster[m_surface.origin(h)]].euler;
      }
    }
    if (is_crossable) {
      m_crossable_faces.push_back(face);
    } else {
      Cluster& home = m_clusters[m_cluster[m_surface.origin(3 * face)]];
      ++home.euler;
      home.area += double(m_surface.face_area(face));
    }
  }

  /// Gives every part of a crossed edge its set: the outer parts the sets of the ends, the inner ones new sets.
  void split_edges(const Separator_arrangement& arrangement)
  {
    m_is_cut.assign(m_crossable_edges.size(), 0);
    auto crossable = m_crossable_edges.begin();
    const std::vector<Separator_arrangement::Edge_point>& points = arrangement.points();
    m_sorted_points.resize(points.size());
    std::iota(m_sorted_points.begin(), m_sorted_points.end(), Index(0));
    std::sort(m_sorted_points.begin(), m_sorted_points.end(), [&](Index a, Index b) {
      return points[a].edge != points[b].edge ? points[a].edge < points[b].edge
                                              : Separator_arrangement::is_before_on_edge(points[a], points[b]);
    });
    m_intervals.clear();
    m_interval_before.resize(points.size());
    for (std::size_t i = 0; i < m_sorted_points.size(); ++i) {
      const Index edge = points[m_sorted_points[i]].edge;
      const bool is_first = i == 0 || points[m_sorted_points[i - 1]].edge != edge;
      if (is_first) {
        crossable = std::lower_bound(crossable, m_crossable_edges.end(), edge); // both are in ascending order
        m_is_cut[std::size_t(crossable - m_crossable_edges.begin())] = 1;
        m_intervals.push_back(m_cluster[m_surface.origin(edge)]);
      }
      m_interval_before[m_sorted_points[i]] = Index(m_intervals.size() - 1);
      const bool is_last = i + 1 == m_sorted_points.size() || points[m_sorted_points[i + 1]].edge != edge;
      if (is_last) {
        m_intervals.push_back(m_cluster[m_surface.target(edge)]);
      } else {
        m_intervals.push_back(m_sets.add());
      }
    }
  }

  void join_remaining_edges()
  {
    for (std::size_t i = 0; i < m_crossable_edges.size(); ++i) {
      if (m_is_cut[i] == 0) {
        const Index edge = m_crossable_edges[i];
        m_sets.join(m_cluster[m_surface.origin(edge)], m_cluster[m_surface.target(edge)]);
      }
    }
  }

  /// The set of the part of the edge before (`is_after` false) or after point `point`, going around `face`.
  Index interval_beside(const Separator_arrangement& arrangement, Index point, Index face, bool is_after) const
  {
    const bool is_reversed = Triangulated_surface::face(arrangement.points()[point].edge) != face;
    return m_intervals[m_interval_before[point] + (is_after != is_reversed ? 1 : 0)];
  }

  /// A part of a face between chords.
  struct Part
  {
    Index interval; ///< the set of an adjacent part of an edge
    double area;
  };

  /// Splits every face that is cut into its parts, and joins the sets that each part connects.
  void split_faces(const Separator_arrangement& arrangement)
  {
    const std::vector<Separator_arrangement::Chord>& chords = arrangement.chords();
    std::vector<Separator_arrangement::Chord_end> ends;
    m_parts.clear();
    for (Index chord = 0; chord < chords.size(); ++chord) {
      // Handle a face only at the head of its chord list.
      if (arrangement.first_chord(chords[chord].face) == chord) {
        arrangement.collect_ends(chords[chord].face, ends);
        split_face(arrangement, chords[chord].face, ends);
      }
    }
  }

  /// Walks around `face`. The part that a chord cuts off connects the boundary just before the chord begins with that
  /// just after it ends.
  void split_face(const Separator_arrangement& arrangement, Index face,
                  const std::vector<Separator_arrangement::Chord_end>& ends)
  {
    const double area = double(m_surface.face_area(face));
    m_open.clear();
    double taken = 0;
    for (const Separator_arrangement::Chord_end& end : ends) {
      const double place = boundary_place(arrangement, end.point, face);
      const Index interval_before = interval_beside(arrangement, end.point, face, false);
      if (m_open.empty() || m_open.back().chord != end.chord) {
        m_open.push_back({end.chord, interval_before, taken, place});
        taken = 0;
        continue;
      }
      const double part = cut_off_part(m_open.back().begin_place, place);
      m_parts.push_back({interval_before, (part - taken) * area});
      m_sets.join(m_open.back().interval, interval_beside(arrangement, end.point, face, true));
      taken = m_open.back().taken_outside + part;
      m_open.pop_back();
    }
    m_parts.push_back({interval_beside(arrangement, ends.front().point, face, false), (1 - taken) * area});
  }

  /// The place of an edge point in the order around `face`, in [0, 3): side plus position along it.
  double boundary_place(const Separator_arrangement& arrangement, Index point, Index face) const
  {
    const Separator_arrangement::Edge_point& edge_point = arrangement.points()[point];
    const bool is_reversed = Triangulated_surface::face(edge_point.edge) != face;
    return arrangement.side(edge_point.edge, face) + (is_reversed ? 1 - edge_point.position : edge_point.position);
  }

  /// The part of a face's area that a chord between places `low` < `high` cuts off on the side of the boundary from
  /// `low` to `high`: the polygon of the two points and the corners between them, in barycentric coordinates.
  static double cut_off_part(double low, double high)
  {
    const auto barycentric = [](double place) {
      const int side = std::min(int(place), 2);
      const double along = place - side;
      std::array<double, 3> result{};
      result[std::size_t(side)] = 1 - along;
      result[std::size_t((side + 1) % 3)] = along;
      return result;
    };
    double doubled = 0;
    std::array<double, 3> last = barycentric(low);
    const auto go_to = [&](double place) {
      const std::array<double, 3> next = barycentric(place);
      doubled += last[1] * next[2] - last[2] * next[1];
      last = next;
    };
    for (int corner = int(low) + 1; corner <= int(high); ++corner) {
      go_to(corner);
    }
    go_to(high);
    go_to(low);
    return std::abs(doubled);
  }

  /// Numbers the pieces by their first vertex, and labels all sets.
  void label_pieces()
  {
    Index number_of_pieces = 0;
    m_label = m_sets.numbers(number_of_pieces);
    m_pieces.assign(number_of_pieces, Piece());
  }

  /// Area and Euler number. The points and chords of a separator are equally many on each of its sides and cancel in
  /// the Euler number: vertices, parts of edges and parts of faces count.
  void measure_pieces(const Separator_arrangement& arrangement)
  {
    for (Index cluster = 0; cluster < m_clusters.size(); ++cluster) {
      Piece& piece = m_pieces[m_label[cluster]];
      piece.euler += m_clusters[cluster].euler;
      piece.area += m_clusters[cluster].area;
    }
    for (std::size_t i = 0; i < m_crossable_edges.size(); ++i) {
      if (m_is_cut[i] == 0) {
        --m_pieces[piece_of_vertex(m_surface.origin(m_crossable_edges[i]))].euler;
      }
    }
    for (Index interval : m_intervals) {
      --m_pieces[m_label[interval]].euler;
    }
    for (Index face : m_crossable_faces) {
      if (arrangement.first_chord(face) == no_index) {
        Piece& piece = m_pieces[piece_of_vertex(m_surface.origin(3 * face))];
        ++piece.euler;
        piece.area += double(m_surface.face_area(face));
      }
    }
    for (const Part& part : m_parts) {
      Piece& piece = m_pieces[m_label[part.interval]];
      ++piece.euler;
      piece.area += part.area;
    }
  }

  void find_sides(const Separator_arrangement& arrangement)
  {
    m_sides.clear();
    for (Index point = 0; point < arrangement.points().size(); ++point) {
      if (arrangement.points()[point].rank == 0) {
        m_sides.push_back(
            {m_label[m_intervals[m_interval_before[point]]], m_label[m_intervals[m_interval_before[point] + 1]]});
      }
    }
    for (Index i = 0; i < m_sides.size(); ++i) {
      m_pieces[m_sides[i].first].separators.push_back(i);
      m_pieces[m_sides[i].second].separators.push_back(i);
    }
  }

  const Triangulated_surface& m_surface;
  std::vector<std::uint8_t> m_crossed_edge; ///< whether an edge may be cut
  std::vector<Index> m_crossable_edges;     ///< in ascending order, as the next
  std::vector<Index> m_crossable_faces;
  std::vector<Cluster> m_clusters;
  std::vector<std::uint8_t> m_is_cut; ///< of every crossable edge, whether a separator of the arrangement cuts it
  std::vector<Index> m_cluster;       ///< of every vertex
  Disjoint_sets m_sets;               ///< of clusters and of inner parts of edges
  std::vector<Index> m_label;         ///< the piece of each of them
  std::vector<Index> m_sorted_points;
  std::vector<Index> m_intervals;
  std::vector<Index> m_interval_before;
  std::vector<Part> m_parts;
  std::vector<Open_chord> m_open; ///< working memory
  std::vector<Piece> m_pieces;
  std::vector<Sides> m_sides;
};

} // namespace CSCD::internal

#endif // CSCD_PACKING_CUT_GRAPH_H
