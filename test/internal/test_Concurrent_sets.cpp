// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets that several threads join, against those that one thread joins.

#include "support/Allow_threads.h"
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Concurrent_sets.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/for_each_range.h>

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::Concurrent_sets;
using CSCD::internal::Disjoint_sets;

TEST(Concurrent_sets, are_single_at_first)
{
  Concurrent_sets sets(3);
  EXPECT_EQ(sets.size(), 3u);
  for (Index i = 0; i < 3; ++i) {
    EXPECT_EQ(sets.find(i), i);
  }
}

TEST(Concurrent_sets, are_represented_by_their_smallest_index)
{
  Concurrent_sets sets(6);
  sets.join(5, 3);
  sets.join(4, 5);
  sets.join(4, 3); // one set already
  sets.join(1, 0);
  for (const auto& [index, representative] : {std::pair(0u, 0u), {1u, 0u}, {2u, 2u}, {3u, 3u}, {4u, 3u}, {5u, 3u}}) {
    EXPECT_EQ(sets.find(index), representative) << index;
  }
}

TEST(Concurrent_sets, do_not_depend_on_the_number_of_threads)
{
  const CSCD::test::Allow_threads allow(4);
  constexpr Index size = 20000;
  constexpr Index number_of_pairs = 15000; // some large sets, and many small ones
  std::mt19937 generator(1);
  std::uniform_int_distribution<Index> any(0, size - 1);
  std::vector<std::pair<Index, Index>> pairs;
  for (Index i = 0; i < number_of_pairs; ++i) {
    pairs.emplace_back(any(generator), any(generator));
  }
  Disjoint_sets expected(size);
  for (const auto& [a, b] : pairs) {
    expected.join(a, b);
  }
  for (const unsigned number_of_threads : {1u, 2u, 4u}) {
    Concurrent_sets sets(size);
    constexpr Index number_of_parts = 50;
    CSCD::internal::for_each_part(number_of_parts, number_of_threads, [&](Index part) {
      for (Index i = part; i < number_of_pairs; i += number_of_parts) {
        sets.join(pairs[i].first, pairs[i].second);
      }
    });
    std::vector<Index> smallest(size, CSCD::no_index);
    for (Index i = 0; i < size; ++i) {
      Index& of_set = smallest[expected.find(i)];
      of_set = of_set == CSCD::no_index ? i : of_set;
      ASSERT_EQ(sets.find(i), of_set) << i;
    }
  }
}

} // namespace
