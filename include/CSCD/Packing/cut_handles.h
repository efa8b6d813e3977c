// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The packing stage of the default engine: packs separators, and cuts the handles that no separator cuts.

#ifndef CSCD_PACKING_CUT_HANDLES_H
#define CSCD_PACKING_CUT_HANDLES_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CSCD::internal {

/// Finds loops in a piece of the cut surface that do not separate it: a basis of its homology, with a disc put over
/// each of its borders. A separator that the piece has on both sides makes two borders. From a tree of shortest paths
/// in the piece and a cotree of the faces that leaves the edges of the shortest loops to the last (Erickson and
/// Whittlesey, "Greedy optimal homotopy and homology generators", 2005), each edge that is in neither closes one loop.
/// O(n log n) for n vertices of the surface.
class Handle_loops
{
public:
  /// Prepares to find loops on the surface `finest` cut along the separators in `arrangement`.
  Handle_loops(const Surface_level& finest, const Separator_arrangement& arrangement)
      : m_surface(finest.surface), m_corners(finest.corners()), m_arrangement(arrangement),
        m_is_crossed(m_surface.number_of_halfedges(), 0), m_region(m_surface.number_of_halfedges()),
        m_capped(m_surface.number_of_faces() + 2 * arrangement.points().size()),
        m_front(m_surface.number_of_vertices()), m_parent(m_surface.number_of_vertices())
  {
    for (const Separator_arrangement::Edge_point& point : arrangement.points()) {
      m_is_crossed[point.edge] = 1;
    }
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      m_region[h] = Triangulated_surface::face(h);
    }
    cap_borders();
  }

  /// The loops of the piece with the vertex `root`, twice its genus of them, each simple, through `root` or with its
  /// stem from there left out; the shortest first. They are fewer where all edges between two parts of the piece are
  /// crossed.
  std::vector<Vertex_loop> operator()(Index root)
  {
    m_front.clear();
    grow_tree(root);
    return close_loops();
  }

  /// The loops of all pieces, likewise, from a root in each part of them.
  std::vector<Vertex_loop> of_all_pieces()
  {
    m_front.clear();
    for (Index vertex = 0; vertex < m_surface.number_of_vertices(); ++vertex) {
      if (!m_front.is_reached(vertex)) {
        grow_tree(vertex);
      }
    }
    return close_loops();
  }

private:
  struct Cotree_edge
  {
    Index halfedge;
    float loop_length;
  };

  bool is_crossed(Index halfedge) const { return m_is_crossed[m_surface.edge(halfedge)] != 0; }

  /// One side of a separator at a point, which is all of its border there.
  Index border(Index point, bool is_left) const { return m_surface.number_of_faces() + 2 * point + (is_left ? 1 : 0); }

  /// Makes one region of each border of a piece, with its disc, and of borders that meet within a face.
  void cap_borders()
  {
    const std::vector<Separator_arrangement::Chord>& chords = m_arrangement.chords();
    for (Index i = 0; i < chords.size(); ++i) {
      for (bool is_left : {false, true}) {
        m_capped.join(border(chords[i].begin, is_left), border(chords[i].end, is_left));
      }
      // Each face once: at the chord that its list begins with.
      if (m_arrangement.first_chord(chords[i].face) == i) {
        join_parts_of_face(chords[i].face);
      }
    }
  }

  /// Walks around `face`: from one end of a chord to the next, the boundary belongs to one part of the face.
  void join_parts_of_face(Index face)
  {
    m_arrangement.collect_ends(face, m_ends);
    Index region = region_after(m_ends.back());
    auto end = m_ends.begin();
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      // Of an edge that is crossed, this region is only the first part; but no loop runs along it.
      m_region[h] = region;
      for (; end != m_ends.end() && m_arrangement.side(m_arrangement.points()[end->point].edge, face) == h % 3; ++end) {
        m_capped.join(region, border(end->point, !end->is_last));
        region = region_after(*end);
      }
    }
  }

  /// A chord leaves the face with its left side after it in the order around the face, and enters with its right side.
  Index region_after(const Separator_arrangement::Chord_end& end) const { return border(end.point, end.is_last); }

  void grow_tree(Index root)
  {
    m_front.reach(root, 0);
    m_parent[root] = no_index;
    m_front.spread([&](Index vertex, float distance) {
      const Corner* corner = m_corners.fan(vertex).begin();
      for (Index halfedge : m_surface.outgoing(vertex)) {
        const float next_distance = distance + corner->length;
        if (!is_crossed(halfedge) && m_front.reach(corner->neighbor, next_distance)) {
          m_parent[corner->neighbor] = vertex;
        }
        ++corner;
      }
    });
  }

  std::vector<Vertex_loop> close_loops()
  {
    Disjoint_sets regions = m_capped;
    collect_cotree_edges(regions);
    std::vector<Vertex_loop> loops;
    // The longest loops first: their edges go to the cotree, and the edges of the shortest remain.
    for (auto edge = m_edges.rbegin(); edge != m_edges.rend(); ++edge) {
      if (!join_across(edge->halfedge, regions)) {
        loops.push_back(close_loop(edge->halfedge));
      }
    }
    std::reverse(loops.begin(), loops.end());
    return loops;
  }

  /// Unites the regions on the two sides of an edge that is not crossed. \return whether they were two
  bool join_across(Index halfedge, Disjoint_sets& regions) const
  {
    return regions.join(m_region[halfedge], m_region[m_surface.twin(halfedge)]);
  }

  /// Collects the edges that the tree reaches and does not take, by increasing length of the loops that they close;
  /// edges that it does not reach do not obstruct the cotree.
  void collect_cotree_edges(Disjoint_sets& regions)
  {
    m_edges.clear();
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      const Index a = m_surface.origin(h);
      const Index b = m_surface.target(h);
      if (m_surface.edge(h) != h || is_crossed(h)) {
        continue;
      }
      if (!m_front.is_reached(a) || !m_front.is_reached(b)) {
        join_across(h, regions);
      } else if (m_parent[a] != b && m_parent[b] != a) {
        m_edges.push_back({h, m_front.distance(a) + m_front.distance(b) + float(m_surface.length(h))});
      }
    }
    std::stable_sort(m_edges.begin(), m_edges.end(),
                     [](const Cotree_edge& a, const Cotree_edge& b) { return a.loop_length < b.loop_length; });
  }

  /// The two tree paths to the ends of `halfedge` without their common part.
  Vertex_loop close_loop(Index halfedge) const
  {
    Vertex_loop first = path_from(m_surface.origin(halfedge));
    Vertex_loop second = path_from(m_surface.target(halfedge));
    Index meeting = first.back();
    while (!first.empty() && !second.empty() && first.back() == second.back()) {
      meeting = first.back();
      first.pop_back();
      second.pop_back();
    }
    std::reverse(second.begin(), second.end());
    first.push_back(meeting);
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  Vertex_loop path_from(Index vertex) const
  {
    Vertex_loop path;
    for (; vertex != no_index; vertex = m_parent[vertex]) {
      path.push_back(vertex);
    }
    return path;
  }

  const Triangulated_surface& m_surface;
  const Vertex_fan_table& m_corners;
  const Separator_arrangement& m_arrangement;
  std::vector<std::uint8_t> m_is_crossed;
  std::vector<Index> m_region; ///< of every halfedge that is not crossed: its face or, if that is cut, a border
  Disjoint_sets m_capped;      ///< of faces and of both sides of the separators at every point
  Dijkstra_search m_front;
  std::vector<Index> m_parent;
  std::vector<Separator_arrangement::Chord_end> m_ends;
  std::vector<Cotree_edge> m_edges;
};

/// Adds one separator for every handle that the packed ones leave uncut, so that the first Betti number of the cut
/// graph is the genus of the surface. Of the loops that do not separate a piece, it takes one that spans the body
/// rather than a hole, the shorter the better.
class Handle_cutting
{
public:
  /// `separators` are those of `packing`; the new ones are appended to them.
  Handle_cutting(const Triangulated_solid& solid, std::vector<Separator>& separators, Separator_packing& packing)
      : m_solid(solid), m_surface(solid.levels().finest().surface), m_separators(separators), m_packing(packing)
  {
  }

  /// Cuts all handles that can be cut; O(n log n) for each round, and a round cuts many. \return the number of
  /// separators that were added
  std::size_t operator()()
  {
    std::size_t count = 0;
    bool is_any_allowed = false;
    while (has_handles()) {
      const std::size_t added = cut(is_any_allowed);
      if (added == 0 && is_any_allowed) {
        break;
      }
      is_any_allowed = added == 0;
      count += added;
    }
    return count;
  }

private:
  /// A loop spans the body if at least this share of the samples of its disc is inside: the middles between points of
  /// the loop and its center ...
  static constexpr double min_inside_part = 0.5;
  /// ... of at most this many samples.
  static constexpr std::size_t max_number_of_samples = 32;

  struct Candidate
  {
    Vertex_loop loop;
    double length = 0;
    bool is_inside = false;
  };

  bool has_handles() const
  {
    const std::vector<Cut_graph::Piece>& pieces = m_packing.cut_graph().pieces();
    return std::any_of(pieces.begin(), pieces.end(), [](const Cut_graph::Piece& piece) { return piece.genus() > 0; });
  }

  /// Cuts along all loops that span the body, or if `is_any_allowed`, along any, that are disjoint and each lower the
  /// genus by one. \return their number
  std::size_t cut(bool is_any_allowed)
  {
    std::vector<Candidate> candidates;
    for (const Vertex_loop& loop : Handle_loops(m_solid.levels().finest(), m_packing.arrangement()).of_all_pieces()) {
      candidates.push_back(measure(loop));
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.is_inside != b.is_inside ? a.is_inside : a.length < b.length;
    });
    std::vector<Separator> trial;
    Separator_arrangement arrangement = m_packing.arrangement();
    m_room.assign(m_surface.number_of_halfedges(), 1.);
    for (const Index packed : m_packing.packed()) {
      take_room(m_separators[packed].crossings);
    }
    for (const Candidate& candidate : candidates) {
      if (candidate.is_inside || is_any_allowed) {
        insert(candidate.loop, trial, arrangement);
      }
    }
    return pack(needed(trial, arrangement));
  }

  /// The disjoint separators of `trial`, the last in `arrangement`, that lower the genus: from the worst to the best,
  /// one with different pieces on its sides is left out, and the pieces become one.
  std::vector<Separator> needed(const std::vector<Separator>& trial, const Separator_arrangement& arrangement) const
  {
    Cut_graph cut_graph(m_surface, arrangement);
    cut_graph.cut(arrangement);
    Disjoint_sets pieces(cut_graph.pieces().size());
    std::vector<Separator> result;
    for (std::size_t i = trial.size(); i-- > 0;) {
      const Cut_graph::Sides& sides = cut_graph.sides(Index(m_packing.packed().size() + i));
      if (!pieces.join(sides.first, sides.second)) {
        result.push_back(trial[i]);
      }
    }
    return {result.rbegin(), result.rend()};
  }

  /// Packs `separators`, which are disjoint from the packed ones and from each other. \return their number
  std::size_t pack(const std::vector<Separator>& separators)
  {
    for (const Separator& separator : separators) {
      m_separators.push_back(separator);
      [[maybe_unused]] const bool is_packed = m_packing.insert_last();
      CGAL_assertion(is_packed);
    }
    if (!separators.empty()) {
      m_packing.cut_again();
    }
    return separators.size();
  }

  Candidate measure(const Vertex_loop& loop) const
  {
    std::vector<Vector_3> points;
    points.reserve(loop.size());
    for (Index vertex : loop) {
      points.push_back(m_surface.point(vertex));
    }
    const Polygon_measures measures = measure_polygon(points);
    const std::size_t step = points.size() / max_number_of_samples + 1;
    std::size_t number = 0;
    std::size_t number_inside = 0;
    for (std::size_t i = 0; i < points.size(); i += step) {
      ++number;
      number_inside += m_solid.is_inside((points[i] + measures.center) / 2) ? 1 : 0;
    }
    return {loop, measures.length, double(number_inside) >= min_inside_part * double(number)};
  }

  /// Appends `loop`, pushed off the vertices, to `trial` if it is disjoint from the separators in `arrangement`: it
  /// crosses edges half way to the nearest one of these.
  void insert(const Vertex_loop& loop, std::vector<Separator>& trial, Separator_arrangement& arrangement)
  {
    Separator separator;
    if (!push_off(m_surface, loop, separator.crossings)) {
      return;
    }
    for (Edge_crossing& crossing : separator.crossings) {
      crossing.position = std::min(crossing.position, m_room[crossing.halfedge] / 2);
    }
    if (arrangement.insert(Index(m_separators.size() + trial.size()), separator.crossings)) {
      take_room(separator.crossings);
      std::vector<Vector_3> points;
      crossing_points(m_surface, separator.crossings, points);
      set_measures(separator, points);
      separator.source = loop.front();
      trial.push_back(separator);
    }
  }

  void take_room(const std::vector<Edge_crossing>& crossings)
  {
    for (const auto& [halfedge, position] : crossings) {
      const Index twin = m_surface.twin(halfedge);
      m_room[halfedge] = std::min(m_room[halfedge], position);
      m_room[twin] = std::min(m_room[twin], 1 - position);
    }
  }

  const Triangulated_solid& m_solid;
  const Triangulated_surface& m_surface;
  std::vector<Separator>& m_separators;
  Separator_packing& m_packing;
  std::vector<double> m_room; ///< of each halfedge, the position of the first separator that crosses it
};

/// Packs `separators` and cuts the surface along the packed ones. Appends separators around handles that no source has
/// found.
inline std::unique_ptr<Separator_packing> pack_local_separators(const Triangulated_solid& solid, const Detail& detail,
                                                                std::vector<Separator>& separators,
                                                                Skeletonization_report& report)
{
  auto packing = std::make_unique<Separator_packing>(solid.triangulation(), separators, separator_costs(separators),
                                                     detail.min_branch_area_ratio());
  report.number_of_handle_cuts = Handle_cutting(solid, separators, *packing)();
  for (std::size_t i = separators.size() - report.number_of_handle_cuts; i < separators.size(); ++i) {
    mark_open(solid, separators[i]);
  }
  return packing;
}

} // namespace CSCD::internal

#endif // CSCD_PACKING_CUT_HANDLES_H
