// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sees to it that every handle is cut.

#ifndef CSCD_SELECTION_CUT_HANDLES_H
#define CSCD_SELECTION_CUT_HANDLES_H

#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Selection/Handle_loops.h>
#include <CSCD/Selection/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Straightening.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Separator/curve_measures.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Adds a separator around every handle that the packed ones leave uncut, so that the first Betti number of the cut
/// graph is the genus of the surface. Of the loops that do not separate a piece, it takes one that spans the body
/// rather than a hole, the shorter the better. \tparam Traits a model of `SolidSkeletonizationTraits`
template <class Traits>
class Handle_cutting
{
public:
  /// `separators` are those of `packing`; the new ones are appended to them.
  Handle_cutting(const Traits& traits, std::vector<Separator>& separators, Separator_packing& packing)
      : m_traits(traits), m_surface(traits.levels().finest().surface), m_separators(separators), m_packing(packing),
        m_straightening(m_surface)
  {
  }

  /// Cuts all handles that can be cut. \return the number of separators that were added
  std::size_t operator()()
  {
    std::size_t count = 0;
    for (Index piece = first_piece_with_handle(); piece != no_index; piece = first_piece_with_handle()) {
      const std::size_t added = cut_piece(piece);
      if (added == 0) {
        break;
      }
      count += added;
    }
    return count;
  }

private:
  /// Sweeps of straightening: the loops run along edges.
  static constexpr int number_of_straightening_passes = 15;
  /// Bound for the vertices visited in looking for shorter loops around the handles of one piece: a few seconds at
  /// most.
  static constexpr std::size_t most_visits = 10000000;
  /// Samples of the disc that a loop spans: each point of the loop and the middle between it and the center.
  static constexpr double least_inside_part = 0.5;

  struct Candidate
  {
    Vertex_loop loop;
    double length = 0;
    bool is_inside = false;
  };

  Index first_piece_with_handle() const
  {
    const std::vector<Cut_graph::Piece>& pieces = m_packing.cut_graph().pieces();
    const auto piece =
        std::find_if(pieces.begin(), pieces.end(), [](const Cut_graph::Piece& p) { return p.genus() > 0; });
    return piece == pieces.end() ? no_index : Index(piece - pieces.begin());
  }

  /// Packs all loops of the piece that span the body and are disjoint; if there are none, one that does not span it.
  std::size_t cut_piece(Index piece)
  {
    std::vector<Candidate> candidates = find_candidates(piece);
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.is_inside != b.is_inside ? a.is_inside : a.length < b.length;
    });
    std::size_t count = 0;
    for (const Candidate& candidate : candidates) {
      if (!candidate.is_inside && count > 0) {
        break;
      }
      count += insert(candidate.loop) ? 1 : 0;
    }
    if (count > 0) {
      m_packing.cut_again();
    }
    return count;
  }

  std::vector<Candidate> find_candidates(Index piece) const
  {
    Handle_loops handle_loops(m_traits.levels().finest(), m_packing.arrangement());
    Index root = 0;
    while (m_packing.cut_graph().piece_of_vertex(root) != piece) {
      ++root;
    }
    // Loops from the first root pass near the handles; rooted there, they become the shortest around them.
    const std::vector<Vertex_loop> rough_loops = handle_loops(root);
    const std::size_t most_roots = most_visits / m_surface.number_of_vertices();
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < rough_loops.size(); ++i) {
      candidates.push_back(measure(rough_loops[i]));
      if (i < most_roots) {
        for (const Vertex_loop& loop : handle_loops(rough_loops[i].front())) {
          candidates.push_back(measure(loop));
        }
      }
    }
    return candidates;
  }

  Candidate measure(const Vertex_loop& loop) const
  {
    std::vector<Vector_3> points;
    for (Index vertex : loop) {
      points.push_back(m_surface.point(vertex));
    }
    const Polygon_measures measures = measure_polygon(points);
    const auto inside = std::count_if(points.begin(), points.end(), [&](const Vector_3& point) {
      return m_traits.is_inside((point + measures.center) / 2);
    });
    return {loop, measures.length, double(inside) >= least_inside_part * double(points.size())};
  }

  /// Packs `loop` if it can be made disjoint from the packed separators.
  bool insert(const Vertex_loop& loop)
  {
    Separator separator;
    if (!push_off(m_surface, loop, separator.crossings)) {
      return false;
    }
    const std::vector<Edge_crossing> pushed = separator.crossings;
    m_straightening(separator.crossings, number_of_straightening_passes);
    separator.source = loop.front();
    for (int attempt = 0; attempt < 2; ++attempt) {
      std::vector<Vector_3> points;
      crossing_points(m_surface, separator.crossings, points);
      set_measures(separator, points);
      m_separators.push_back(separator);
      if (separator.crossings.size() >= 3 && m_packing.insert_last()) {
        return true;
      }
      m_separators.pop_back();
      // Straightened, it has met another separator: as close to the edges as they are, it does not.
      separator.crossings = pushed;
    }
    return false;
  }

  const Traits& m_traits;
  const Triangulated_surface& m_surface;
  std::vector<Separator>& m_separators;
  Separator_packing& m_packing;
  Straightening m_straightening;
};

/// Cuts the handles that `packing` leaves uncut; see `Handle_cutting`. \return their number
template <class Traits>
std::size_t cut_handles(const Traits& traits, std::vector<Separator>& separators, Separator_packing& packing)
{
  return Handle_cutting<Traits>(traits, separators, packing)();
}

} // namespace CSCD::internal

#endif // CSCD_SELECTION_CUT_HANDLES_H
