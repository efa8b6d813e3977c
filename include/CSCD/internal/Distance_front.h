// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dijkstra's algorithm, without a graph.

#ifndef CSCD_INTERNAL_DISTANCE_FRONT_H
#define CSCD_INTERNAL_DISTANCE_FRONT_H

#include <CSCD/internal/Epoch_marks.h>
#include <CSCD/internal/Indexed_heap.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The least distances at which vertices have been reached, and those from which one has yet to go on. What is next to
/// a vertex, and how far, is known to the caller: so it can stop at any distance and at any border, and keep what else
/// belongs to the shortest paths. Boost's algorithm initializes every vertex of its graph; this one is emptied in
/// constant time, so that local work costs nothing of the size of the surface.
class Distance_front
{
public:
  explicit Distance_front(std::size_t number_of_vertices = 0)
      : m_heap(number_of_vertices), m_reached(number_of_vertices), m_distance(number_of_vertices)
  {
  }

  /// Forgets all distances, in constant time.
  void clear()
  {
    m_heap.clear();
    m_reached.clear();
  }

  /// Takes note that `vertex` can be reached at `distance`, not less than that of the vertex that was passed last.
  /// \return whether no way as short was known
  bool reach(Index vertex, float distance)
  {
    if (m_reached.mark(vertex)) {
      m_distance[vertex] = distance;
      m_heap.push(vertex, distance);
      return true;
    }
    if (distance < m_distance[vertex]) {
      m_distance[vertex] = distance;
      m_heap.decrease(vertex, distance);
      return true;
    }
    return false;
  }

  /// Calls `pass(vertex, distance)` for all vertices that have been reached, those that it reaches included, in order
  /// of their distance, which is then final. O(n log n) for n calls.
  template <class Function>
  void spread(const Function& pass)
  {
    while (!m_heap.empty()) {
      const Indexed_heap::Entry entry = m_heap.pop();
      pass(entry.vertex, entry.key);
    }
  }

  bool is_reached(Index vertex) const { return m_reached.is_marked(vertex); }
  /// The least distance at which `vertex` was reached.
  /// \pre `is_reached(vertex)`
  float distance(Index vertex) const { return m_distance[vertex]; }

private:
  Indexed_heap m_heap;
  Epoch_marks m_reached;
  std::vector<float> m_distance;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_DISTANCE_FRONT_H
