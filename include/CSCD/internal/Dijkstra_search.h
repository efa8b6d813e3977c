// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dijkstra's algorithm, and the heap with changing keys that it needs.

#ifndef CSCD_INTERNAL_DIJKSTRA_SEARCH_H
#define CSCD_INTERNAL_DIJKSTRA_SEARCH_H

#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/core/noinit_adaptor.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CSCD::internal {

/// A 4-ary min-heap of vertices with float keys and decrease-key.
/// Boost's `d_ary_heap_indirect` leaves the keys outside, so that each comparison follows two indices, and can be
/// emptied only element by element, whereas a front stops early and leaves most of its heap behind.
class Indexed_heap
{
public:
  struct Entry
  {
    float key;
    Index vertex;
  };

  /// Makes room for vertices 0 to `number_of_vertices` - 1.
  explicit Indexed_heap(std::size_t number_of_vertices = 0) : m_position(number_of_vertices) {}

  bool empty() const { return m_entries.empty(); }
  /// Empties the heap in constant time.
  void clear() { m_entries.clear(); }

  /// Inserts `vertex`, which must not be in the heap.
  void push(Index vertex, float key)
  {
    m_entries.emplace_back();
    move_up(m_entries.size() - 1, {key, vertex});
  }

  /// Lowers the key of `vertex`, which must be in the heap.
  void decrease(Index vertex, float key) { move_up(m_position[vertex], {key, vertex}); }

  /// Removes and returns the entry of minimal key.
  Entry pop()
  {
    const Entry least = m_entries.front();
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if (!m_entries.empty()) {
      move_down_from_top(last);
    }
    return least;
  }

private:
  static constexpr std::size_t arity = 4;

  void place(std::size_t at, const Entry& entry)
  {
    m_entries[at] = entry;
    m_position[entry.vertex] = Index(at);
  }

  void move_up(std::size_t at, const Entry& entry)
  {
    while (at > 0) {
      const std::size_t parent = (at - 1) / arity;
      if (m_entries[parent].key <= entry.key) {
        break;
      }
      place(at, m_entries[parent]);
      at = parent;
    }
    place(at, entry);
  }

  void move_down_from_top(const Entry& entry)
  {
    std::size_t at = 0;
    for (std::size_t first = 1; first < m_entries.size(); first = arity * at + 1) {
      const std::size_t end = std::min(first + arity, m_entries.size());
      std::size_t least = first;
      for (std::size_t child = first + 1; child < end; ++child) {
        if (m_entries[child].key < m_entries[least].key) {
          least = child;
        }
      }
      if (m_entries[least].key >= entry.key) {
        break;
      }
      place(at, m_entries[least]);
      at = least;
    }
    place(at, entry);
  }

  std::vector<Entry> m_entries;
  std::vector<Index, boost::noinit_adaptor<std::allocator<Index>>> m_position; // of vertices that are in the heap
};

/// The minimal distances of reached vertices, and a heap of the vertices that the search has yet to go on from. The
/// caller knows the neighbors of a vertex and their distances: so it can stop at any distance and at any border, and
/// keep further data of the shortest paths. Boost's algorithm initializes every vertex of its graph; this one is
/// emptied in constant time, so that local work costs nothing of the size of the surface.
class Dijkstra_search
{
public:
  explicit Dijkstra_search(std::size_t number_of_vertices = 0)
      : m_heap(number_of_vertices), m_reached(number_of_vertices), m_distance(number_of_vertices)
  {
  }

  /// Forgets all distances, in constant time.
  void clear()
  {
    m_heap.clear();
    m_reached.clear();
  }

  /// Takes note that `vertex` can be reached at `distance`, not less than the distance of the vertex that was passed
  /// last.
  /// \return whether no path as short was known
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

  /// Calls `pass(vertex, distance)` for all reached vertices, including the ones that it reaches itself, in order of
  /// their distance, which is then final. O(n log n) for n calls.
  template <class Function>
  void spread(const Function& pass)
  {
    while (!m_heap.empty()) {
      const Indexed_heap::Entry entry = m_heap.pop();
      pass(entry.vertex, entry.key);
    }
  }

  bool is_reached(Index vertex) const { return m_reached.is_marked(vertex); }
  /// The minimal distance of the reached `vertex`.
  /// \pre `is_reached(vertex)`
  float distance(Index vertex) const { return m_distance[vertex]; }

private:
  Indexed_heap m_heap;
  Epoch_marks m_reached;
  std::vector<float, boost::noinit_adaptor<std::allocator<float>>> m_distance; // of reached vertices
};

/// A front that starts from labeled vertices; each vertex gets the label of the neighbor that reaches it first, so that
/// it is connected with a start of its label.
class Multi_source_dijkstra_search
{
public:
  explicit Multi_source_dijkstra_search(std::size_t number_of_vertices)
      : m_front(number_of_vertices), m_label(number_of_vertices, no_index)
  {
  }

  /// Lets the front start, or go on, from `vertex` with `label` at `distance`, not less than where it is by now.
  /// \return whether no path as short was known
  bool reach(Index vertex, float distance, Index label)
  {
    const bool is_nearer = m_front.reach(vertex, distance);
    if (is_nearer) {
      m_label[vertex] = label;
    }
    return is_nearer;
  }

  /// Goes on until no vertex is left that can be reached; `for_each_neighbor(vertex, visit)` calls
  /// `visit(neighbor, length)`, which returns the result of `reach()`, for the edges of a vertex. O(n log n).
  template <class ForEachNeighbor>
  void spread(const ForEachNeighbor& for_each_neighbor)
  {
    m_front.spread([&](Index vertex, float distance) {
      for_each_neighbor(
          vertex, [&](Index neighbor, float length) { return reach(neighbor, distance + length, m_label[vertex]); });
    });
  }

  /// The label of `vertex`; `no_index` if it has not been reached.
  Index label(Index vertex) const { return m_label[vertex]; }
  /// The distance from the nearest start; infinite if none reaches it.
  float distance(Index vertex) const
  {
    return m_front.is_reached(vertex) ? m_front.distance(vertex) : std::numeric_limits<float>::infinity();
  }

private:
  Dijkstra_search m_front;
  std::vector<Index> m_label;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_DIJKSTRA_SEARCH_H
