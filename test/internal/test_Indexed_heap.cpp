// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The heap against the standard queue, on random operations.

#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::Indexed_heap;

/// The standard queue; entries that a decrease has made obsolete are skipped when they come out.
class Reference_queue
{
public:
  void put(Index vertex, float key)
  {
    m_key[vertex] = key;
    m_queue.emplace(key, vertex);
  }
  bool empty() const { return m_key.empty(); }
  bool contains(Index vertex) const { return m_key.count(vertex) > 0; }
  float key(Index vertex) const { return m_key.at(vertex); }
  float min_key()
  {
    while (!contains(m_queue.top().second) || key(m_queue.top().second) != m_queue.top().first) {
      m_queue.pop();
    }
    return m_queue.top().first;
  }
  void erase(Index vertex) { m_key.erase(vertex); }

private:
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_queue;
  std::map<Index, float> m_key;
};

void expect_pops_least(Indexed_heap& heap, Reference_queue& reference)
{
  ASSERT_FALSE(heap.empty());
  const Indexed_heap::Entry entry = heap.pop();
  ASSERT_TRUE(reference.contains(entry.vertex));
  EXPECT_EQ(entry.key, reference.key(entry.vertex));
  EXPECT_EQ(entry.key, reference.min_key());
  reference.erase(entry.vertex);
}

TEST(Indexed_heap, agrees_with_the_standard_queue)
{
  constexpr Index number_of_vertices = 300;
  std::mt19937 random(1);
  // Few different keys: many ties.
  for (const unsigned number_of_keys : {3u, 50u, 1000000u}) {
    Indexed_heap heap(number_of_vertices);
    Reference_queue reference;
    for (int step = 0; step < 20000; ++step) {
      const auto vertex = Index(random() % number_of_vertices);
      const auto key = float(random() % number_of_keys);
      if (random() % 4 == 0 && !reference.empty()) {
        expect_pops_least(heap, reference);
      } else if (!reference.contains(vertex)) {
        heap.push(vertex, key);
        reference.put(vertex, key);
      } else if (key < reference.key(vertex)) {
        heap.decrease(vertex, key);
        reference.put(vertex, key);
      }
    }
    while (!reference.empty()) {
      expect_pops_least(heap, reference);
    }
    EXPECT_TRUE(heap.empty());
  }
}

TEST(Indexed_heap, can_be_used_again_after_it_was_left_half_full)
{
  Indexed_heap heap(10);
  for (Index vertex = 0; vertex < 10; ++vertex) {
    heap.push(vertex, float(10 - vertex));
  }
  EXPECT_EQ(heap.pop().vertex, 9u);
  heap.clear();
  EXPECT_TRUE(heap.empty());
  heap.push(3, 2);
  heap.push(9, 1);
  heap.decrease(3, 0.5);
  EXPECT_EQ(heap.pop().vertex, 3u);
  EXPECT_EQ(heap.pop().vertex, 9u);
  EXPECT_TRUE(heap.empty());
}

} // namespace
