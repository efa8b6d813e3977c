// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop over indices, sequential and parallel.

#include "support/Allow_threads.h"
#include <CSCD/Vector_3.h>
#include <CSCD/internal/parallel.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::For_each_index;

/// Knows whether two threads use it at once.
struct Worker
{
  std::atomic<bool>* is_busy;
};

#ifdef CGAL_LINKED_WITH_TBB
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

TEST(For_each_index, calls_once_for_each_index_with_a_worker_of_its_own)
{
  const CSCD::test::Allow_threads allow(3);
  for (const unsigned number_of_threads : {1u, 2u, 3u}) {
    std::vector<std::atomic<bool>> is_busy(64);
    std::atomic<std::size_t> number_of_workers{0};
    std::atomic<bool> is_shared{false};
    For_each_index<Worker> for_each([&] { return Worker{&is_busy.at(number_of_workers++)}; }, number_of_threads);
    EXPECT_EQ(for_each.number_of_threads(), has_threads ? number_of_threads : 1u);
    for (const Index size : {Index(0), Index(1), Index(16), Index(500)}) {
      std::vector<std::atomic<int>> calls(size);
      for_each(size, [&](Index i, Worker& worker) {
        is_shared = is_shared || worker.is_busy->exchange(true);
        ++calls[i];
        *worker.is_busy = false;
      });
      for (const std::atomic<int>& count : calls) {
        EXPECT_EQ(count, 1);
      }
    }
    EXPECT_FALSE(is_shared);
  }
}

TEST(For_each_index, goes_in_order_by_one_thread)
{
  For_each_index<std::vector<Index>> for_each([] { return std::vector<Index>(); }, 1);
  std::vector<Index> last;
  for_each(5, [&](Index i, std::vector<Index>& indices) {
    indices.push_back(i);
    last = indices;
  });
  EXPECT_EQ(last, (std::vector<Index>{0, 1, 2, 3, 4}));
}

TEST(For_each_index, passes_on_what_is_thrown)
{
  const CSCD::test::Allow_threads allow(2);
  for (const unsigned number_of_threads : {1u, 2u}) {
    For_each_index<int> for_each([] { return 0; }, number_of_threads);
    EXPECT_THROW(for_each(100, [](Index i, int&) { return i == 50 ? throw std::runtime_error("stop") : void(); }),
                 std::runtime_error);
    std::atomic<int> calls{0};
    for_each(10, [&](Index, int&) { ++calls; });
    EXPECT_EQ(calls, 10);
  }
}

TEST(For_each_index, chooses_the_number_of_threads_itself)
{
  const For_each_index<int> for_each([] { return 0; }, 0);
  EXPECT_GE(for_each.number_of_threads(), 1u);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(For_each_index, keeps_to_the_limit_of_the_application)
{
  const CSCD::test::Allow_threads allow(3);
  EXPECT_EQ((For_each_index<int>([] { return 0; }, 0).number_of_threads()), 3u);
  EXPECT_EQ((For_each_index<int>([] { return 0; }, 100).number_of_threads()), 3u);
}

TEST(For_each_index, works_on_several_threads_at_once)
{
  const CSCD::test::Allow_threads allow(2);
  For_each_index<int> for_each([] { return 0; }, 2);
  // Each call waits for the other one to begin, which a single thread would never come to.
  std::atomic<int> calls{0};
  for_each(2, [&](Index, int&) {
    ++calls;
    while (calls < 2) {
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(calls, 2);
}
#endif

} // namespace
