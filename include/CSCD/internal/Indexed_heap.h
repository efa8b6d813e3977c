// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The priority queue of fronts and distance bands.

#ifndef CSCD_INTERNAL_INDEXED_HEAP_H
#define CSCD_INTERNAL_INDEXED_HEAP_H

#include <CSCD/Vector_3.h>

#include <boost/core/noinit_adaptor.hpp>

#include <algorithm>
#include <cstddef>
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

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_INDEXED_HEAP_H
