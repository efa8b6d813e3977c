// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop over indices, sequential and parallel.

#include "support/Allow_threads.h"
#include <CSCD/Vector_3.h>
#include <CSCD/internal/for_each_index.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::For_each_index;

/// Knows whether two threads use it at once.
struct Worker
{
  std::atomic<bool>* is_busy;
};

template <class ConcurrencyTag>
class For_each_index_test : public testing::Test
{
};

#ifdef CGAL_LINKED_WITH_TBB
using Tags = testing::Types<CGAL::Sequential_tag, CGAL::Parallel_tag>;
#else
using Tags = testing::Types<CGAL::Sequential_tag>;
#endif

/// What a test is called after its tag.
struct Tag_name
{
  template <class Tag>
  static std::string GetName(int) // NOLINT(readability-identifier-naming): what GoogleTest calls
  {
    return std::is_same_v<Tag, CGAL::Sequential_tag> ? "sequential" : "parallel";
  }
};
TYPED_TEST_SUITE(For_each_index_test, Tags, Tag_name);

TYPED_TEST(For_each_index_test, calls_once_for_each_index_with_a_worker_of_its_own)
{
  const CSCD::test::Allow_threads allow(3);
  for (const unsigned number_of_threads : {1u, 2u, 3u}) {
    std::vector<std::atomic<bool>> is_busy(64);
    std::atomic<std::size_t> number_of_workers{0};
    std::atomic<bool> is_shared{false};
    For_each_index<TypeParam, Worker> for_each([&] { return Worker{&is_busy.at(number_of_workers++)}; },
                                               number_of_threads);
    const bool is_parallel = !std::is_same_v<TypeParam, CGAL::Sequential_tag>;
    EXPECT_EQ(for_each.number_of_threads(), is_parallel ? number_of_threads : 1u);
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

TYPED_TEST(For_each_index_test, passes_on_what_is_thrown)
{
  const CSCD::test::Allow_threads allow(2);
  For_each_index<TypeParam, int> for_each([] { return 0; }, 2);
  EXPECT_THROW(for_each(100, [](Index i, int&) { return i == 50 ? throw std::runtime_error("stop") : void(); }),
               std::runtime_error);
  std::atomic<int> calls{0};
  for_each(10, [&](Index, int&) { ++calls; });
  EXPECT_EQ(calls, 10);
}

TYPED_TEST(For_each_index_test, chooses_the_number_of_threads_itself)
{
  const For_each_index<TypeParam, int> for_each([] { return 0; }, 0);
  EXPECT_GE(for_each.number_of_threads(), 1u);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(For_each_index, keeps_to_the_limit_of_the_application)
{
  const CSCD::test::Allow_threads allow(3);
  EXPECT_EQ((For_each_index<CGAL::Parallel_tag, int>([] { return 0; }, 0).number_of_threads()), 3u);
  EXPECT_EQ((For_each_index<CGAL::Parallel_tag, int>([] { return 0; }, 100).number_of_threads()), 3u);
}

TEST(For_each_index, works_on_several_threads_at_once)
{
  const CSCD::test::Allow_threads allow(2);
  For_each_index<CGAL::Parallel_tag, int> for_each([] { return 0; }, 2);
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
