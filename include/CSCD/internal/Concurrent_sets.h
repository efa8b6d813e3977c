// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint sets that several threads may join.

#ifndef CSCD_INTERNAL_CONCURRENT_SETS_H
#define CSCD_INTERNAL_CONCURRENT_SETS_H

#include <CSCD/Vector_3.h>

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Disjoint sets of indices, each represented by the smallest one: so it does not matter in which order they are
/// joined. All members may be called by several threads at once. Near linear where neighbors have near numbers.
class Concurrent_sets
{
public:
  /// Makes a set of each index from 0 to `size` - 1.
  explicit Concurrent_sets(std::size_t size) : m_parent(size)
  {
    for (Index index = 0; index < size; ++index) {
      m_parent[index].store(index, std::memory_order_relaxed);
    }
  }

  Index size() const { return Index(m_parent.size()); }

  /// The index that represents the set of `index`, the smallest one once all sets are joined. Halves the way to it.
  Index find(Index index)
  {
    for (;;) {
      Index parent = m_parent[index].load(std::memory_order_relaxed);
      const Index next = m_parent[parent].load(std::memory_order_relaxed);
      if (parent == next) {
        return parent;
      }
      m_parent[index].compare_exchange_weak(parent, next, std::memory_order_relaxed);
      index = next;
    }
  }

  /// Unites the sets of `a` and `b`.
  void join(Index a, Index b)
  {
    for (;;) {
      a = find(a);
      b = find(b);
      if (a == b) {
        return;
      }
      if (a < b) {
        std::swap(a, b);
      }
      // Unless another thread has joined it meanwhile.
      Index expected = a;
      if (m_parent[a].compare_exchange_strong(expected, b, std::memory_order_relaxed)) {
        return;
      }
    }
  }

private:
  std::vector<std::atomic<Index>> m_parent; // never greater than the index itself
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_CONCURRENT_SETS_H
