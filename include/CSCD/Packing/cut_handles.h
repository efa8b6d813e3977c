// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// No separator around a hollow, one at each narrow hole, and one around each handle that no packed separator cuts: the
// packing stage of the default engine.

#ifndef CSCD_PACKING_CUT_HANDLES_H
#define CSCD_PACKING_CUT_HANDLES_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Loops_across.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Finds loops in the pieces of a cut surface that do not separate them: bases of their homology, with a disc put over
/// each border. From a tree of shortest paths in a piece and a cotree of its faces that leaves the edges of the
/// shortest loops to the last (Erickson and Whittlesey, "Greedy optimal homotopy and homology generators", 2005), each
/// edge that is in neither closes one loop. The cut faces on one side of a separator, with the disc, are one face.
/// Where two of these touch, they become one, and some loops may separate. O(n log n) for n vertices of the surface.
class Handle_loops
{
public:
  /// Prepares to find loops on `surface` cut along the separators in `arrangement`. `surface` is referred to.
  Handle_loops(const Triangulated_surface& surface, const Separator_arrangement& arrangement)
      : m_surface(surface), m_border(surface.number_of_halfedges(), no_index),
        m_regions(surface.number_of_faces() + 2 * arrangement.points().size()), m_front(surface.number_of_vertices()),
        m_parent(surface.number_of_vertices())
  {
    const auto border = [&](Index point, bool is_left) {
      return surface.number_of_faces() + 2 * point + Index(is_left);
    };
    for (const Separator_arrangement::Chord& chord : arrangement.chords()) {
      m_regions.join(border(chord.begin, false), border(chord.end, false));
      m_regions.join(border(chord.begin, true), border(chord.end, true));
    }
    // Two chords that bound one part of a face have ends next to each other on an edge.
    Index last = no_index; // the edge of the last point
    for (const Index point : arrangement.points_along_edges()) {
      const Index edge = arrangement.points()[point].edge;
      const bool is_reversed = arrangement.leaves_reversed(point);
      if (edge != last) {
        m_border[edge] = border(point, is_reversed);
      } else {
        m_regions.join(m_border[surface.twin(edge)], border(point, is_reversed));
      }
      m_border[surface.twin(edge)] = border(point, !is_reversed);
      last = edge;
    }
  }

  /// The loops of the piece with the vertex `root`, twice its genus of them, each simple, through `root` or with its
  /// stem from there left out; the shortest first. They are fewer where all edges between two parts of the piece
  /// are crossed.
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
  bool is_crossed(Index halfedge) const { return m_border[halfedge] != no_index; }

  void grow_tree(Index root)
  {
    m_front.reach(root, 0);
    m_parent[root] = no_index;
    m_front.spread([&](Index vertex, float distance) {
      for (Index halfedge : m_surface.outgoing(vertex)) {
        const Index neighbor = m_surface.target(halfedge);
        if (!is_crossed(halfedge) && m_front.reach(neighbor, distance + float(m_surface.length(halfedge)))) {
          m_parent[neighbor] = vertex;
        }
      }
    });
  }

  std::vector<Vertex_loop> close_loops() const
  {
    Disjoint_sets regions = m_regions;
    std::vector<Vertex_loop> loops;
    // The longest loops first: their edges go to the cotree, and the edges of the shortest remain.
    for (const auto& [loop_length, halfedge] : cotree_edges()) {
      if (!regions.join(region(halfedge), region(m_surface.twin(halfedge)))) {
        loops.push_back(close_loop(halfedge));
      }
    }
    std::reverse(loops.begin(), loops.end());
    return loops;
  }

  /// The region on the left of `halfedge`: its face or, if that is cut, the border that the next edge leads to.
  Index region(Index halfedge) const
  {
    const Index next = Triangulated_surface::next(halfedge);
    return is_crossed(next) ? m_border[next] : Triangulated_surface::face(halfedge);
  }

  /// The edges that the tree reaches and does not take, by decreasing length of the loops that they close.
  std::vector<std::pair<float, Index>> cotree_edges() const
  {
    std::vector<std::pair<float, Index>> edges;
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      const Index a = m_surface.origin(h);
      const Index b = m_surface.target(h);
      if (m_surface.edge(h) == h && !is_crossed(h) && m_front.is_reached(a) && m_front.is_reached(b) &&
          m_parent[a] != b && m_parent[b] != a) {
        edges.emplace_back(m_front.distance(a) + m_front.distance(b) + float(m_surface.length(h)), h);
      }
    }
    std::sort(edges.rbegin(), edges.rend());
    return edges;
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
  std::vector<Index> m_border; ///< of every crossed halfedge, the border that its origin is nearest to
  Disjoint_sets m_regions;     ///< of faces, and of both sides of separators at each point
  Dijkstra_search m_front;
  std::vector<Index> m_parent;
};

/// Adds one separator for every handle that the packed ones leave uncut, so that the first Betti number of the cut
/// graph is the genus of the surface. Of the loops that do not separate a piece, it takes one, the shorter the better.
class Handle_cutting
{
public:
  /// `separators` are those of `packing`; the new ones are appended to them.
  Handle_cutting(const Triangulated_surface& surface, std::vector<Separator>& separators, Separator_packing& packing)
      : m_surface(surface), m_separators(separators), m_packing(packing)
  {
  }

  /// Cuts all handles that can be cut; O(n log n) for each round, and a round cuts many.
  void operator()()
  {
    while (has_handles() && cut()) {
    }
  }

private:
  bool has_handles() const
  {
    const std::vector<Cut_graph::Piece>& pieces = m_packing.cut_graph().pieces();
    return std::any_of(pieces.begin(), pieces.end(), [](const Cut_graph::Piece& piece) { return piece.genus() > 0; });
  }

  /// Cuts along all loops that are disjoint and each lower the genus by one. \return whether there are some
  bool cut()
  {
    m_room.assign(m_surface.number_of_halfedges(), 1.);
    for (const Index packed : m_packing.packed()) {
      take_room(m_separators[packed].crossings);
    }
    Separator_arrangement arrangement = m_packing.arrangement();
    std::vector<Separator> trial;
    for (const Vertex_loop& loop : Handle_loops(m_surface, m_packing.arrangement()).of_all_pieces()) {
      insert(loop, trial, arrangement);
    }
    return pack(trial, Cut_graph(m_surface, arrangement));
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
      std::vector<Vector3> points;
      crossing_points(m_surface, separator.crossings, points);
      set_measures(separator, points);
      separator.source = loop.front();
      trial.push_back(std::move(separator));
    }
  }

  /// Packs the separators of `trial`, the last in `cut_graph`, that lower the genus: from the worst to the best, one
  /// with different pieces on its sides is left out, and the pieces become one. \return whether one is packed
  bool pack(const std::vector<Separator>& trial, const Cut_graph& cut_graph)
  {
    Disjoint_sets pieces(cut_graph.pieces().size());
    std::vector<Index> needed;
    for (Index i = Index(trial.size()); i-- > 0;) {
      const Cut_graph::Sides& sides = cut_graph.sides(Index(m_packing.packed().size()) + i);
      if (!pieces.join(sides.right, sides.left)) {
        needed.push_back(i);
      }
    }
    for (auto i = needed.rbegin(); i != needed.rend(); ++i) {
      m_separators.push_back(trial[*i]);
      m_packing.insert_last();
    }
    m_packing.cut_again();
    return !needed.empty();
  }

  void take_room(const std::vector<Edge_crossing>& crossings)
  {
    for (const auto& [halfedge, position] : crossings) {
      const Index twin = m_surface.twin(halfedge);
      m_room[halfedge] = std::min(m_room[halfedge], position);
      m_room[twin] = std::min(m_room[twin], 1 - position);
    }
  }

  const Triangulated_surface& m_surface;
  std::vector<Separator>& m_separators;
  Separator_packing& m_packing;
  std::vector<double> m_room; ///< of each halfedge, the position of the first separator that crosses it
};

/// The packed separators except, of the first `number` in their list, those at pieces with handles.
inline std::vector<Index> packed_away_from_handles(const Separator_packing& packing, std::size_t number)
{
  const Cut_graph& cut_graph = packing.cut_graph();
  const auto has_handle = [&cut_graph](Index piece) { return cut_graph.pieces()[piece].genus() > 0; };
  std::vector<Index> result;
  for (Index i = 0; i < packing.packed().size(); ++i) {
    const auto [right, left] = cut_graph.sides(i);
    if (packing.packed()[i] >= number || (!has_handle(right) && !has_handle(left))) {
      result.push_back(packing.packed()[i]);
    }
  }
  return result;
}

/// Packs separators around handles that no packed one cuts, and appends them to `separators`; counts them in `report`.
/// Where a coarse surface leaves no room for them, the packed ones around are left out.
inline void cut_handles(const Triangulated_solid& solid, std::vector<Separator>& separators,
                        std::unique_ptr<Separator_packing>& packing, Skeletonization_report& report)
{
  const std::size_t number = separators.size();
  for (;;) {
    Handle_cutting(solid.triangulation(), separators, *packing)();
    const std::vector<Index> kept = packed_away_from_handles(*packing, number);
    if (kept.size() == packing->packed().size()) {
      break;
    }
    packing = std::make_unique<Separator_packing>(solid.triangulation(), separators, kept);
  }
  report.number_of_handle_cuts = separators.size() - number;
  for (std::size_t i = number; i < separators.size(); ++i) {
    mark_open(solid, separators[i]);
  }
}

/// For each separator of `cut_graph`, whether it is on a limb: one side of it has no handle. The pieces at the ends are
/// cut off one by one. Linear.
inline std::vector<char> separators_of_limbs(const Cut_graph& cut_graph, std::size_t number_of_separators)
{
  const std::vector<Cut_graph::Piece>& pieces = cut_graph.pieces();
  std::vector<char> result(number_of_separators, 0);
  std::vector<std::size_t> degree;
  std::vector<Index> ends;
  for (Index piece = 0; piece < pieces.size(); ++piece) {
    degree.push_back(pieces[piece].separators.size());
    if (degree.back() == 1) {
      ends.push_back(piece);
    }
  }
  while (!ends.empty()) {
    const Index piece = ends.back();
    ends.pop_back();
    for (const Index i : pieces[piece].separators) {
      const Index other = cut_graph.sides(i).other(piece);
      if (result[i] == 0 && --degree[other] == 1) {
        ends.push_back(other);
      }
      result[i] = 1;
    }
  }
  return result;
}

/// The packed separators, at each narrow hole one at most: a branch through more of them would hardly lead around the
/// hole, as its nodes, in the middle of the body, are far apart compared with the hole.
inline std::vector<Index> packed_once_at_narrow_holes(const Triangulated_solid& solid,
                                                      const std::vector<Separator>& separators,
                                                      const Separator_packing& packing)
{
  // The length of the shortest loop around a narrow hole, relative to that of the shortest separator which it crosses.
  // With 0.2 to 0.9, most cycles lead around the holes of drilled plates and blocks; with 0.6, a short pipe loses its
  // shape.
  constexpr float narrow_share = 0.2F;
  // Likewise where the center of the separator is outside, as in the hollow of a pipe whose wall it follows. Most
  // cycles lead around the hollow of pipes from 0.8 on. Without a bound, a ring turns into a star.
  constexpr float hollow_share = 0.8F;

  const std::vector<Index>& packed = packing.packed();
  std::vector<float> max_length; // of loops that cross the separator
  for (const Index separator : packed) {
    const float share = solid.is_inside(separators[separator].center) ? narrow_share : hollow_share;
    max_length.push_back(share * float(separators[separator].length));
  }
  Loops_across loops(solid.triangulation(), separators, packed);
  std::vector<Index> number_of_loops(packed.size(), 0); // loops around narrow holes that cross a separator
  const std::vector<char> is_on_limb = separators_of_limbs(packing.cut_graph(), packed.size());
  for (Index i = 0; i < packed.size(); ++i) {
    if (is_on_limb[i] != 0) {
      continue; // no loop crosses it once
    }
    const Loops_across::Loop loop = loops.find(i, true, max_length[i]);
    const bool is_narrow = !loop.vertices.empty() && std::all_of(loop.crossed.begin(), loop.crossed.end(),
                                                                 [&](Index j) { return loop.length < max_length[j]; });
    for (const Index crossed : loop.crossed) {
      number_of_loops[crossed] += is_narrow ? 1 : 0;
    }
  }
  // Separators between two holes go first, then expensive ones. One with the same piece on both sides is needed.
  std::vector<std::tuple<Index, float, Index>> order;
  for (Index i = 0; i < packed.size(); ++i) {
    order.emplace_back(number_of_loops[i], float(separator_cost(separators[packed[i]])), i);
  }
  std::sort(order.rbegin(), order.rend());
  std::vector<char> is_left_out(packed.size(), 0);
  Disjoint_sets pieces(packing.cut_graph().pieces().size());
  for (const auto& [number, cost, i] : order) {
    const Cut_graph::Sides& sides = packing.cut_graph().sides(i);
    is_left_out[i] = number > 0 && !separators[packed[i]].is_open && pieces.join(sides.left, sides.right) ? 1 : 0;
  }
  std::vector<Index> result;
  for (Index i = 0; i < packed.size(); ++i) {
    if (is_left_out[i] == 0) {
      result.push_back(packed[i]);
    }
  }
  return result;
}

/// For each of `separators`, whether it is around something hollow, such as a pipe with a wall, as the packed ones
/// show: a cycle through it would be contractible in the body.
inline std::vector<char> separators_around_hollows(const Triangulated_solid& solid,
                                                   const std::vector<Separator>& separators,
                                                   const Separator_packing& packing)
{
  const Triangulated_surface& surface = solid.triangulation();
  const std::vector<Index>& packed = packing.packed();
  const Cut_graph& cut_graph = packing.cut_graph();
  Disjoint_sets components(cut_graph.pieces().size());
  for (Index i = 0; i < packed.size(); ++i) {
    components.join(cut_graph.sides(i).left, cut_graph.sides(i).right);
  }
  const auto component = [&](Index j) { return components.find(cut_graph.piece_of_vertex(separators[j].source)); };
  std::vector<char> result(separators.size(), 0);
  const std::vector<char> is_on_limb = separators_of_limbs(cut_graph, packed.size());
  std::vector<char> is_done(packed.size(), 0);
  const Loops_through_pieces find_loop(surface, separators, packed, cut_graph);
  for (Index i = 0; i < packed.size(); ++i) {
    if (is_on_limb[i] != 0) {
      result[packed[i]] = is_around_hollow(solid, separators[packed[i]], 0) ? 1 : 0;
      continue;
    }
    if (is_done[i] != 0) {
      continue;
    }
    const Loops_through_pieces::Loop loop = find_loop(i);
    bool is_linked = false;
    for (const Index crossed : loop.crossed) {
      is_done[crossed] = 1;
      const Linking linking(surface, separators[packed[crossed]].crossings, loop.curve);
      is_linked = is_linked || (linking.is_consistent() && linking.of_separator != 0);
    }
    if (is_linked) {
      const std::vector<Vector3> linked = curve_off_surface(surface, loop.curve, Linking::offset);
      for (Index j = 0; j < separators.size(); ++j) {
        const std::vector<Vector3> other = curve_off_surface(surface, separators[j].crossings, -Linking::offset);
        const bool is_hollow = component(j) == component(packed[i]) && linking_number(other, linked) != 0;
        result[j] = result[j] != 0 || is_hollow ? 1 : 0;
      }
    }
  }
  return result;
}

/// Packs `separators` after all around something hollow have been removed from them; these are counted in `report`.
inline std::unique_ptr<Separator_packing> pack_without_hollows(const Triangulated_solid& solid, const Detail& detail,
                                                               std::vector<Separator>& separators,
                                                               Skeletonization_report& report)
{
  while (true) {
    auto packing = std::make_unique<Separator_packing>(solid.triangulation(), separators, separator_costs(separators),
                                                       detail.min_branch_area_ratio());
    if (solid.genus() == 0) {
      return packing;
    }
    const std::vector<char> is_hollow = separators_around_hollows(solid, separators, *packing);
    std::vector<Separator> others;
    for (std::size_t i = 0; i < separators.size(); ++i) {
      if (is_hollow[i] == 0) {
        others.push_back(std::move(separators[i]));
      }
    }
    report.number_of_tunnels += separators.size() - others.size();
    const bool is_done = others.size() == separators.size();
    separators = std::move(others);
    if (is_done) {
      return packing;
    }
  }
}

/// Packs `separators` and cuts the surface along the packed ones. Appends separators around handles that no source has
/// found.
inline std::unique_ptr<Separator_packing> pack_local_separators(const Triangulated_solid& solid, const Detail& detail,
                                                                std::vector<Separator>& separators,
                                                                Skeletonization_report& report)
{
  auto packing = pack_without_hollows(solid, detail, separators, report);
  if (solid.genus() > 0) {
    const std::vector<Index> kept = packed_once_at_narrow_holes(solid, separators, *packing);
    if (kept.size() < packing->packed().size()) {
      packing = std::make_unique<Separator_packing>(solid.triangulation(), separators, kept);
    }
  }
  cut_handles(solid, separators, packing, report);
  return packing;
}

} // namespace CSCD::internal

#endif // CSCD_PACKING_CUT_HANDLES_H
