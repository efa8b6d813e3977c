// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ways along the edges of a point complex: loops through given places, and what can be reached without crossed edges.

#ifndef CSCD_TEST_SURFACE_EDGE_WAYS_H
#define CSCD_TEST_SURFACE_EDGE_WAYS_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace CSCD::test {

/// The vertex with edges that is nearest to `point`.
inline CSCD::Index nearest_vertex(const CSCD::Point_complex& complex, const CSCD::Vector_3& point)
{
  CSCD::Index nearest = CSCD::no_index;
  for (CSCD::Index v = 0; v < complex.number_of_vertices(); ++v) {
    if (!complex.outgoing(v).empty() &&
        (nearest == CSCD::no_index ||
         (complex.point(v) - point).squaredNorm() < (complex.point(nearest) - point).squaredNorm())) {
      nearest = v;
    }
  }
  return nearest;
}

/// Appends the vertices of the shortest way from `from` to `to`, without the latter, to `loop`.
inline void append_way(const CSCD::Point_complex& complex, CSCD::Index from, CSCD::Index to, CSCD::Vertex_loop& loop)
{
  using CSCD::Index;
  CSCD::internal::Dijkstra_search front(complex.number_of_vertices());
  std::vector<Index> next(complex.number_of_vertices(), CSCD::no_index);
  front.reach(to, 0);
  front.spread([&](Index vertex, float distance) {
    for (const Index h : complex.outgoing(vertex)) {
      if (front.reach(complex.target(h), distance + float(complex.length(h)))) {
        next[complex.target(h)] = vertex;
      }
    }
  });
  for (Index vertex = from; vertex != to && vertex != CSCD::no_index; vertex = next[vertex]) {
    loop.push_back(vertex);
  }
}

/// The loop along edges through the vertices nearest to `places`.
inline CSCD::Vertex_loop loop_through(const CSCD::Point_complex& complex, const std::vector<CSCD::Vector_3>& places)
{
  CSCD::Vertex_loop loop;
  for (std::size_t i = 0; i < places.size(); ++i) {
    append_way(complex, nearest_vertex(complex, places[i]), nearest_vertex(complex, places[(i + 1) % places.size()]),
               loop);
  }
  return loop;
}

/// Allows all vertices.
inline bool anywhere(CSCD::Index)
{
  return true;
}

/// The vertices that can be reached from `seeds` over edges not crossed, where `is_allowed(vertex)`.
template <class Predicate>
std::set<CSCD::Index> flooded(const CSCD::Point_complex& complex, const std::vector<CSCD::Edge_crossing>& crossings,
                              const std::set<CSCD::Index>& seeds, const Predicate& is_allowed)
{
  using CSCD::Index;
  std::set<Index> crossed;
  for (const auto& crossing : crossings) {
    crossed.insert(complex.edge(crossing.halfedge));
  }
  std::set<Index> result = seeds;
  std::vector<Index> stack(seeds.begin(), seeds.end());
  while (!stack.empty()) {
    const Index vertex = stack.back();
    stack.pop_back();
    for (const Index h : complex.outgoing(vertex)) {
      const Index target = complex.target(h);
      if (crossed.count(complex.edge(h)) == 0 && is_allowed(target) && result.insert(target).second) {
        stack.push_back(target);
      }
    }
  }
  return result;
}

/// Whether no way over edges that are not crossed leads from the left ends of crossed edges to the right ends, among
/// the vertices where `is_allowed(vertex)`.
template <class Predicate>
bool separates(const CSCD::Point_complex& complex, const std::vector<CSCD::Edge_crossing>& crossings,
               const Predicate& is_allowed)
{
  std::set<CSCD::Index> left;
  for (const auto& crossing : crossings) {
    left.insert(complex.target(crossing.halfedge));
  }
  const std::set<CSCD::Index> reached = flooded(complex, crossings, left, is_allowed);
  return std::none_of(crossings.begin(), crossings.end(), [&](const CSCD::Edge_crossing& crossing) {
    return reached.count(complex.origin(crossing.halfedge)) != 0;
  });
}

} // namespace CSCD::test

#endif // CSCD_TEST_SURFACE_EDGE_WAYS_H
