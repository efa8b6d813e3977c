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
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Finds loops in the pieces of a cut surface that do not separate them: bases of their homology, with a disc put over
/// each border. A loop goes from part to part of the faces, which separators divide, across parts of edges; so it finds
/// the way between any separators. From a tree of shortest ways and a tree over the vertices and the borders that
/// leaves the edge parts across the shortest loops to the last (Erickson and Whittlesey, "Greedy optimal homotopy and
/// homology generators", 2005), each edge part that is in neither closes one loop.
class Handle_loops
{
public:
  /// A simple loop.
  struct Loop
  {
    Index begin; ///< the part of a face where it begins, far from the root
    std::vector<Edge_crossing> crossings;
  };

  /// Prepares to find loops along the edges of `surface`, with vertices and faces in place of parts of faces and of
  /// vertices: the halfedges of the crossings are those along the loop. Linear. `surface` is referred to.
  explicit Handle_loops(const Triangulated_surface& surface)
      : m_surface(surface), m_number_of_discs(surface.number_of_faces())
  {
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (surface.edge(h) == h) {
        const Index twin = surface.twin(h);
        m_parts.push_back(
            {{h, 0}, {Triangulated_surface::face(h), Triangulated_surface::face(twin)}, float(surface.length(h))});
        m_node.insert(m_node.end(), {surface.origin(h), surface.target(h)});
      }
    }
    sort_steps(surface.number_of_vertices());
  }

  /// Prepares to find loops on `surface` cut along the separators in `arrangement`: O(n + m log m) for n edges and m
  /// crossings. `surface` is referred to.
  Handle_loops(const Triangulated_surface& surface, const Separator_arrangement& arrangement)
      : m_surface(surface), m_number_of_discs(surface.number_of_vertices() + 2 * arrangement.points().size())
  {
    const std::vector<Separator_arrangement::Edge_point>& points = arrangement.points();
    const std::vector<Index> order = arrangement.points_along_edges();
    std::vector<Index> part_before(points.size());                // along the edge of each point
    std::vector<Index> first_side(surface.number_of_halfedges()); // of each halfedge: twice its first part, or plus one
    auto next = order.begin();
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (surface.edge(h) != h) {
        continue;
      }
      first_side[h] = Index(2 * m_parts.size());
      Index disc = surface.origin(h);
      double begin = 0;
      for (; next != order.end() && points[*next].edge == h; ++next) {
        const Index border = surface.number_of_vertices() + 2 * (*next - points[*next].rank);
        const bool is_reversed = arrangement.leaves_reversed(*next);
        part_before[*next] = Index(m_parts.size());
        add_part({h, (begin + points[*next].position) / 2}, {disc, border + Index(is_reversed)});
        disc = border + Index(!is_reversed);
        begin = points[*next].position;
      }
      first_side[surface.twin(h)] = Index(2 * m_parts.size() + 1);
      add_part({h, (begin + 1) / 2}, {disc, surface.target(h)});
    }
    // The sides of edge parts are joined to parts of faces, around corners and along separators.
    Disjoint_sets sides(2 * m_parts.size());
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      sides.join(first_side[surface.twin(h)] ^ 1U, first_side[Triangulated_surface::next(h)]);
    }
    for (const Separator_arrangement::Chord& chord : arrangement.chords()) {
      for (const bool is_left : {false, true}) {
        const auto side = [&](Index point) {
          const Index part = part_before[point] + Index(arrangement.leaves_reversed(point) != is_left);
          return 2 * part + Index(Triangulated_surface::face(points[point].edge) != chord.face);
        };
        sides.join(side(chord.begin), side(chord.end));
      }
    }
    Index number_of_nodes = 0;
    m_node = sides.numbers(number_of_nodes);
    sort_steps(number_of_nodes);
  }

  /// The loops of the piece of `root`, a part of a face: twice its genus of them, through `root` or with their stem
  /// from there left out; the shortest first. O(n log n).
  std::vector<Loop> operator()(Index root)
  {
    m_front.clear();
    grow_tree(root);
    return close_loops();
  }

  /// The loops of all pieces, likewise, from a root in each of them.
  std::vector<Loop> of_all_pieces()
  {
    m_front.clear();
    for (Index node = 0; node < m_entered.size(); ++node) {
      if (!m_front.is_reached(node)) {
        grow_tree(node);
      }
    }
    return close_loops();
  }

private:
  /// A part of an edge of the surface, between two separators or ends.
  struct Edge_part
  {
    Edge_crossing crossing;     ///< in the middle
    std::array<Index, 2> discs; ///< the vertices or, after these by number, the borders where it begins and ends
    float length;               ///< of the way across it, from the center of one face to that of the other
  };

  void add_part(const Edge_crossing& crossing, const std::array<Index, 2>& discs)
  {
    const Vector3 middle = crossing_point(m_surface, crossing);
    double length = 0;
    for (const Index h : {crossing.halfedge, m_surface.twin(crossing.halfedge)}) {
      const Vector3 sum = m_surface.point(m_surface.origin(h)) + m_surface.point(m_surface.target(h)) +
                          m_surface.point(m_surface.opposite_vertex(h));
      length += (sum / 3 - middle).norm();
    }
    m_parts.push_back({crossing, discs, float(length)});
  }

  void sort_steps(Index number_of_nodes)
  {
    m_steps = Compressed_rows<Index>(number_of_nodes, [this](const auto& add) {
      for (Index step = 0; step < m_node.size(); ++step) {
        add(m_node[step], step);
      }
    });
    m_front = Dijkstra_search(number_of_nodes);
    m_entered.resize(number_of_nodes);
  }

  void grow_tree(Index root)
  {
    m_front.reach(root, 0);
    m_entered[root] = no_index;
    m_front.spread([&](Index node, float distance) {
      for (const Index step : m_steps[node]) {
        if (m_front.reach(m_node[step ^ 1U], distance + m_parts[step / 2].length)) {
          m_entered[m_node[step ^ 1U]] = step;
        }
      }
    });
  }

  std::vector<Loop> close_loops() const
  {
    std::vector<std::pair<float, Index>> steps; // in no tree so far, with the lengths of the loops that they close
    for (Index step = 0; step < m_node.size(); step += 2) {
      const Index a = m_node[step];
      const Index b = m_node[step + 1];
      if (m_front.is_reached(a) && m_front.is_reached(b) && m_entered[b] != step && m_entered[a] != step + 1) {
        steps.emplace_back(m_front.distance(a) + m_front.distance(b) + m_parts[step / 2].length, step);
      }
    }
    // The longest loops first: their edge parts go to the other tree, and those of the shortest remain.
    std::sort(steps.rbegin(), steps.rend());
    Disjoint_sets discs(m_number_of_discs);
    std::vector<Loop> loops;
    for (const auto& [loop_length, step] : steps) {
      const auto [begin, end] = m_parts[step / 2].discs;
      if (!discs.join(begin, end)) {
        loops.push_back(close_loop(step));
      }
    }
    std::reverse(loops.begin(), loops.end());
    return loops;
  }

  /// From where `step` begins to where the tree ways to its begin and its end part, to the end, and straight back.
  Loop close_loop(Index step) const
  {
    std::vector<Index> first = way_to(m_node[step]);
    std::vector<Index> second = way_to(m_node[step + 1]);
    while (!first.empty() && !second.empty() && first.back() == second.back()) {
      first.pop_back();
      second.pop_back();
    }
    Loop loop{m_node[step], {}};
    for (const Index forth : first) {
      loop.crossings.push_back(crossing(forth ^ 1U));
    }
    std::for_each(second.rbegin(), second.rend(), [&](Index forth) { loop.crossings.push_back(crossing(forth)); });
    loop.crossings.push_back(crossing(step ^ 1U));
    return loop;
  }

  /// The steps from the root to `node`, the last one first.
  std::vector<Index> way_to(Index node) const
  {
    std::vector<Index> way;
    for (Index step = m_entered[node]; step != no_index; step = m_entered[m_node[step]]) {
      way.push_back(step);
    }
    return way;
  }

  Edge_crossing crossing(Index step) const
  {
    const auto [h, position] = m_parts[step / 2].crossing;
    return step % 2 == 0 ? Edge_crossing{h, position} : Edge_crossing{m_surface.twin(h), 1 - position};
  }

  const Triangulated_surface& m_surface;
  std::size_t m_number_of_discs;
  std::vector<Edge_part> m_parts;
  // A step is twice an edge part, across it from the face of its halfedge, or, plus one, from the other face.
  std::vector<Index> m_node;      ///< the part of a face where each step begins
  Compressed_rows<Index> m_steps; ///< that begin in each part of a face
  Dijkstra_search m_front;        ///< over parts of faces
  std::vector<Index> m_entered;   ///< the step to each part of a face in a tree, `no_index` to a root
};

/// Cuts along all loops that are disjoint, and packs those that lower the genus by one each, as separators that are
/// appended: from the worst to the best, a loop with different pieces on its sides is left out, and the pieces become
/// one. O(n log n). \return whether one is packed
inline bool cut_some_handles(const Triangulated_solid& solid, std::vector<Separator>& separators,
                             Separator_packing& packing)
{
  const Triangulated_surface& surface = solid.triangulation();
  packing.spread_crossings();
  Separator_arrangement arrangement = packing.arrangement();
  std::vector<Separator> trial;
  for (Handle_loops::Loop& loop : Handle_loops(surface, arrangement).of_all_pieces()) {
    if (arrangement.insert(Index(separators.size() + trial.size()), loop.crossings)) {
      Separator& separator = trial.emplace_back();
      separator.crossings = std::move(loop.crossings);
      std::vector<Vector3> points;
      crossing_points(surface, separator.crossings, points);
      set_measures(separator, points);
      separator.source = surface.origin(separator.crossings.front().halfedge);
      mark_open(solid, separator);
    }
  }
  const Cut_graph cut_graph(surface, arrangement);
  Disjoint_sets pieces(cut_graph.pieces().size());
  std::vector<Index> needed;
  for (Index i = Index(trial.size()); i-- > 0;) {
    const Cut_graph::Sides& sides = cut_graph.sides(Index(packing.packed().size()) + i);
    if (!pieces.join(sides.right, sides.left)) {
      needed.push_back(i);
    }
  }
  for (auto i = needed.rbegin(); i != needed.rend(); ++i) {
    separators.push_back(std::move(trial[*i]));
    packing.insert(Index(separators.size() - 1));
  }
  packing.cut_again();
  return !needed.empty();
}

/// Packs separators around handles that no packed one cuts, so that the first Betti number of the cut graph is the
/// genus of the surface, and appends them to `separators`, which are those of `packing`; counts them in `report`. A
/// round cuts many handles.
inline void cut_handles(const Triangulated_solid& solid, std::vector<Separator>& separators, Separator_packing& packing,
                        Skeletonization_report& report)
{
  const auto has_handle = [](const Cut_graph::Piece& piece) { return piece.genus() > 0; };
  const auto has_handles = [&] {
    const std::vector<Cut_graph::Piece>& pieces = packing.cut_graph().pieces();
    return std::any_of(pieces.begin(), pieces.end(), has_handle);
  };
  const std::size_t number = separators.size();
  while (has_handles() && cut_some_handles(solid, separators, packing)) {
  }
  report.number_of_handle_cuts = separators.size() - number;
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
    const Solid_queries& body = solid.queries(solid.component(separators[separator].source));
    const float share = body.is_inside(separators[separator].center) ? narrow_share : hollow_share;
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
  Loops_across loops(surface, separators, packed);
  for (Index i = 0; i < packed.size(); ++i) {
    if (is_on_limb[i] != 0) {
      result[packed[i]] = is_around_hollow(solid, separators[packed[i]], 0) ? 1 : 0;
      continue;
    }
    if (is_done[i] != 0) {
      continue;
    }
    const Loops_across::Loop loop = loops.find(i, true, std::numeric_limits<float>::infinity());
    if (loop.vertices.empty()) {
      continue;
    }
    const std::vector<Edge_crossing> curve = loops.curve(loop);
    bool is_linked = false;
    for (const Index crossed : loop.crossed) {
      // Linking compares curves that cross once.
      if (std::count(loop.crossed.begin(), loop.crossed.end(), crossed) == 1) {
        is_done[crossed] = 1;
        const Linking linking(surface, separators[packed[crossed]].crossings, curve);
        is_linked = is_linked || (linking.is_consistent() && linking.of_separator != 0);
      }
    }
    if (is_linked) {
      const std::vector<Vector3> linked = curve_off_surface(surface, curve, Linking::offset);
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
    auto packing =
        std::make_unique<Separator_packing>(solid.triangulation(), separators, detail.min_branch_area_ratio());
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
  cut_handles(solid, separators, *packing, report);
  return packing;
}

} // namespace CSCD::internal

#endif // CSCD_PACKING_CUT_HANDLES_H
