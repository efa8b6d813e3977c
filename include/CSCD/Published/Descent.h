// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths along edges down a distance field to its source.

#ifndef CSCD_PUBLISHED_DESCENT_H
#define CSCD_PUBLISHED_DESCENT_H

#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// A step along an edge. The edge is named by a halfedge, since there may be several between two vertices.
struct Edge_step
{
  Index halfedge = no_index;
  /// Whether the step goes from the target of the halfedge to its origin: on a border there is no other halfedge.
  bool is_reversed = false;
};

/// Consecutive steps, each beginning where the one before ends.
using Edge_steps = std::vector<Edge_step>;

template <class Triangulation>
Index begin_of(const Triangulation& triangulation, const Edge_step& step)
{
  return step.is_reversed ? triangulation.target(step.halfedge) : triangulation.origin(step.halfedge);
}

template <class Triangulation>
Index end_of(const Triangulation& triangulation, const Edge_step& step)
{
  return step.is_reversed ? triangulation.origin(step.halfedge) : triangulation.target(step.halfedge);
}

/// The same step the other way: by the twin of its halfedge, if there is one.
template <class Triangulation>
Edge_step reversed(const Triangulation& triangulation, const Edge_step& step)
{
  const Index twin = triangulation.twin(step.halfedge);
  return twin != no_index ? Edge_step{twin, step.is_reversed} : Edge_step{step.halfedge, !step.is_reversed};
}

/// Traces paths along edges to the source, each step to the nearest neighbor (supplement, Alg. 4). Unlike there, a step
/// must lead down. Where none does, the path continues along a shortest path to a vertex that is nearer than all
/// before: so it has no cycle, and ends at the source whatever the field is like. One object serves one thread, and
/// keeps working memory of the size of the surface.
/// \tparam Frames know the neighbors of a vertex: `Tangent_frames` or `Point_frames`
template <class Frames>
class Descent
{
public:
  /// \param frames is referred to and must outlive this object
  explicit Descent(const Frames& frames)
      : m_frames(frames), m_front(frames.triangulation().number_of_vertices()),
        m_step_to(frames.triangulation().number_of_vertices())
  {
  }

  /// Lets the paths from now on cost about as much as `number_of_steps` steps in all.
  void set_budget(std::size_t number_of_steps) { m_budget = number_of_steps; }
  /// Whether the budget is spent; paths then end at once.
  bool is_exhausted() const { return m_budget == 0; }

  /// Appends to `path` the steps from `vertex` to `source`; no vertex is passed twice. O(k) for k steps and their
  /// edges; O(m log m) for the m vertices around a minimum that is no source.
  /// \return false, with steps to somewhere, if `source` is not connected with `vertex` or the budget is spent
  template <class Measures>
  bool operator()(const Measures& measures, Index vertex, Index source, Edge_steps& path)
  {
    const std::size_t begin = path.size();
    while (vertex != source) {
      spend(1);
      if (is_exhausted()) {
        return false;
      }
      Edge_step best;
      double min_distance = measures.distance(vertex);
      m_frames.for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
        if (neighbor == source || measures.distance(neighbor) < min_distance) {
          min_distance = neighbor == source ? -std::numeric_limits<double>::infinity() : measures.distance(neighbor);
          best = step_from(vertex, neighbor, halfedge);
        }
      });
      if (best.halfedge != no_index) {
        path.push_back(best);
        vertex = end_of(m_frames.triangulation(), best);
      } else {
        ++m_number_of_minima;
        vertex = leave_minimum(measures, vertex, source, begin, path);
        if (vertex == no_index) {
          return false;
        }
      }
    }
    return true;
  }

  /// How often a path reached a vertex without a nearer neighbor, over all calls.
  std::size_t number_of_minima() const { return m_number_of_minima; }

private:
  /// What a vertex costs that a front passes, in steps of a path: it goes through a heap, and all its neighbors do.
  static constexpr std::size_t steps_per_spread_vertex = 16;

  void spend(std::size_t number_of_steps) { m_budget -= std::min(m_budget, number_of_steps); }

  Edge_step step_from(Index vertex, Index neighbor, Index halfedge) const
  {
    const auto& triangulation = m_frames.triangulation();
    return {halfedge, !(triangulation.origin(halfedge) == vertex && triangulation.target(halfedge) == neighbor)};
  }

  /// Spreads from the minimum `vertex` along edges until the source or a nearer vertex comes, and goes there.
  /// \return that vertex, or `no_index` if there is none
  template <class Measures>
  Index leave_minimum(const Measures& measures, Index vertex, Index source, std::size_t begin, Edge_steps& path)
  {
    const double record = measures.distance(vertex);
    m_front.clear();
    m_front.reach(vertex, 0);
    Index found = no_index;
    m_front.spread([&](Index at, float way) {
      spend(steps_per_spread_vertex);
      if (found != no_index || is_exhausted()) {
        return;
      }
      if (at == source || measures.distance(at) < record) {
        found = at; // what else was reached is only passed
        return;
      }
      m_frames.for_each_neighbor(at, [&](Index neighbor, Index halfedge) {
        if (m_front.reach(neighbor, way + float(m_frames.length(halfedge)))) {
          m_step_to[neighbor] = step_from(at, neighbor, halfedge);
        }
      });
    });
    if (found != no_index) {
      append_detour(vertex, found, begin, path);
    }
    return found;
  }

  /// Appends the shortest path from `from` to `to`; where it meets the path since `begin`, what lies between is left
  /// out.
  void append_detour(Index from, Index to, std::size_t begin, Edge_steps& path)
  {
    const auto& triangulation = m_frames.triangulation();
    m_detour.clear();
    for (Index at = to; at != from; at = begin_of(triangulation, m_step_to[at])) {
      m_detour.push_back(m_step_to[at]);
    }
    std::reverse(m_detour.begin(), m_detour.end());
    for (const Edge_step& step : m_detour) {
      const Index end = end_of(triangulation, step);
      spend(path.size() - begin);
      const auto meets = [&](const Edge_step& earlier) { return begin_of(triangulation, earlier) == end; };
      const auto first = path.begin() + std::ptrdiff_t(begin);
      const auto meeting = std::find_if(first, path.end(), meets);
      if (meeting != path.end()) {
        path.erase(meeting, path.end());
      } else {
        path.push_back(step);
      }
    }
  }

  const Frames& m_frames;
  Dijkstra_search m_front;
  std::vector<Edge_step> m_step_to; ///< the step by which the front came to a vertex
  Edge_steps m_detour;
  std::size_t m_number_of_minima = 0;
  std::size_t m_budget = std::numeric_limits<std::size_t>::max(); ///< in steps
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_DESCENT_H
