// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds separators until every handle is cut.

#ifndef CSCD_PACKING_CUT_HANDLES_H
#define CSCD_PACKING_CUT_HANDLES_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Handle_loops.h>
#include <CSCD/Packing/Separator_arrangement.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Straightening.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Adds one separator for every handle that the packed ones leave uncut, so that the first Betti number of the cut
/// graph is the genus of the surface. Of the loops that do not separate a piece, it takes one that spans the body
/// rather than a hole, the shorter the better.
class Handle_cutting
{
public:
  /// `separators` are those of `packing`; the new ones are appended to them.
  Handle_cutting(const Triangulated_solid& solid, std::vector<Separator>& separators, Separator_packing& packing)
      : m_solid(solid), m_surface(solid.levels().finest().surface), m_separators(separators), m_packing(packing),
        m_straightening(m_surface)
  {
  }

  /// Cuts all handles that can be cut. \return the number of separators that were added
  std::size_t operator()()
  {
    std::size_t count = 0;
    // A piece that is cut stays one, with its number, and has as many handles less as separators were added.
    for (Index piece = 0; piece < m_packing.cut_graph().pieces().size(); ++piece) {
      while (m_packing.cut_graph().pieces()[piece].genus() > 0) {
        const std::size_t added = cut_piece(piece);
        if (added == 0) {
          break;
        }
        count += added;
      }
    }
    return count;
  }

private:
  /// Sweeps of straightening: the loops run along edges.
  static constexpr int number_of_straightening_passes = 15;
  /// Bound for the vertices visited in looking for shorter loops around the handles of one piece: a few seconds at
  /// most.
  static constexpr std::size_t max_visits = 10000000;
  /// A loop spans the body if so many of the samples of its disc are inside: the middles between points of the loop and
  /// its center ...
  static constexpr double min_inside_part = 0.5;
  /// ... of which so many tell.
  static constexpr std::size_t max_number_of_samples = 32;
  /// Of sums of lengths in single precision, relative to them.
  static constexpr double rounding = 1e-4;

  struct Candidate
  {
    Vertex_loop loop;
    double length = 0;
    bool is_inside = false;
  };

  /// Cuts the piece along as many loops as lower its genus, each by one: all that span the body and are disjoint, less
  /// those that are not needed; if there are none, one that does not span it.
  std::size_t cut_piece(Index piece)
  {
    std::vector<Candidate> candidates = find_candidates(piece);
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.is_inside != b.is_inside ? a.is_inside : a.length < b.length;
    });
    std::vector<Separator> trial;
    Separator_arrangement arrangement = m_packing.arrangement();
    for (const Candidate& candidate : candidates) {
      if (!candidate.is_inside && !trial.empty()) {
        break;
      }
      insert(candidate.loop, trial, arrangement);
    }
    return pack(needed(trial, arrangement));
  }

  /// Those of the disjoint separators `trial`, the last in `arrangement`, that lower the genus: from the worst to the
  /// best, one with different pieces on its sides is left out, and the pieces become one.
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

  std::vector<Candidate> find_candidates(Index piece) const
  {
    Handle_loops handle_loops(m_solid.levels().finest(), m_packing.arrangement());
    // Loops from the first root pass near the handles; rooted there, they become the shortest around them.
    const std::size_t max_roots = max_visits / m_surface.number_of_vertices();
    const std::vector<Vertex_loop> rough_loops = find_rough_loops(piece, max_roots, handle_loops);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < rough_loops.size(); ++i) {
      candidates.push_back(measure(rough_loops[i]));
      if (i < max_roots) {
        // Longer ones are around handles far away, where other roots find shorter ones.
        const auto max_length = float((1 + rounding) * candidates.back().length);
        for (const Vertex_loop& loop : handle_loops(rough_loops[i].front(), max_length)) {
          candidates.push_back(measure(loop));
        }
      }
    }
    return candidates;
  }

  /// The loops from the first vertex of the piece from which there are any: where separators are as dense as vertices,
  /// no path leads from some of them to the handles.
  std::vector<Vertex_loop> find_rough_loops(Index piece, std::size_t max_roots, Handle_loops& handle_loops) const
  {
    std::vector<Vertex_loop> loops;
    std::vector<char> is_passed(m_surface.number_of_vertices(), 0);
    std::size_t number_of_roots = 0;
    for (Index root = 0; root < m_surface.number_of_vertices() && loops.empty(); ++root) {
      if (is_passed[root] != 0 || m_packing.cut_graph().piece_of_vertex(root) != piece) {
        continue;
      }
      loops = handle_loops(root);
      if (++number_of_roots > max_roots) {
        break;
      }
      for (Index vertex = root; vertex < m_surface.number_of_vertices(); ++vertex) {
        if (handle_loops.has_reached(vertex)) {
          is_passed[vertex] = 1;
        }
      }
    }
    return loops;
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

  /// Appends `loop`, pushed off the vertices and straightened, to `trial` if it is disjoint from what `arrangement`
  /// holds.
  void insert(const Vertex_loop& loop, std::vector<Separator>& trial, Separator_arrangement& arrangement)
  {
    Separator separator;
    if (!push_off(m_surface, loop, separator.crossings)) {
      return;
    }
    const std::vector<Edge_crossing> pushed = separator.crossings;
    m_straightening(separator.crossings, number_of_straightening_passes);
    separator.source = loop.front();
    // Straightened, it may meet another separator: as close to the edges as they are, it does not.
    for (const std::vector<Edge_crossing>& crossings : {separator.crossings, pushed}) {
      separator.crossings = crossings;
      if (crossings.size() >= 3 && arrangement.insert(Index(m_separators.size() + trial.size()), crossings)) {
        std::vector<Vector_3> points;
        crossing_points(m_surface, crossings, points);
        set_measures(separator, points);
        trial.push_back(separator);
        return;
      }
    }
  }

  const Triangulated_solid& m_solid;
  const Triangulated_surface& m_surface;
  std::vector<Separator>& m_separators;
  Separator_packing& m_packing;
  Straightening m_straightening;
};

/// Cuts the handles that `packing` leaves uncut; see `Handle_cutting`. \return their number
inline std::size_t cut_handles(const Triangulated_solid& solid, std::vector<Separator>& separators,
                               Separator_packing& packing)
{
  return Handle_cutting(solid, separators, packing)();
}

} // namespace CSCD::internal

#endif // CSCD_PACKING_CUT_HANDLES_H
