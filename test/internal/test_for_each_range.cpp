// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop over ranges of indices, and two calls at once.

#include "support/Allow_threads.h"
#include <CSCD/Vector_3.h>
#include <CSCD/internal/parallel.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::call_both;
using CSCD::internal::for_each_part;
using CSCD::internal::for_each_range;
using CSCD::internal::range_size;

TEST(For_each_range, passes_each_index_once_in_ranges_that_do_not_depend_on_the_number_of_threads)
{
  const CSCD::test::Allow_threads allow(3);
  for (const unsigned number_of_threads : {1u, 2u, 3u}) {
    for (const Index size : {Index(0), Index(1), range_size - 1, range_size, range_size + 1, 5 * range_size + 7}) {
      std::vector<int> calls(size, 0);
      std::vector<Index> ends(size / range_size + 1, 0);
      for_each_range(size, number_of_threads, [&](Index begin, Index end) {
        EXPECT_EQ(begin % range_size, 0u);
        ends[begin / range_size] = end;
        for (Index i = begin; i < end; ++i) {
          ++calls[i];
        }
      });
      EXPECT_EQ(calls, std::vector<int>(size, 1));
      for (Index begin = 0; begin < size; begin += range_size) {
        EXPECT_EQ(ends[begin / range_size], size - begin < range_size ? size : begin + range_size);
      }
    }
  }
}

TEST(For_each_range, goes_in_order_by_one_thread_and_passes_on_what_is_thrown)
{
  std::vector<Index> begins;
  for_each_range(3 * range_size, 1, [&](Index begin, Index) { begins.push_back(begin); });
  EXPECT_EQ(begins, (std::vector<Index>{0, range_size, 2 * range_size}));
  EXPECT_THROW(for_each_range(1, 1, [](Index, Index) { throw std::runtime_error("stop"); }), std::runtime_error);
}

TEST(For_each_part, calls_once_for_each_number)
{
  const CSCD::test::Allow_threads allow(2);
  for (const unsigned number_of_threads : {1u, 2u}) {
    for (const Index size : {Index(0), Index(1), Index(100)}) {
      std::vector<int> calls(size, 0);
      for_each_part(size, number_of_threads, [&calls](Index i) { ++calls[i]; });
      EXPECT_EQ(calls, std::vector<int>(size, 1));
    }
  }
}

TEST(Call_both, calls_both_and_returns_when_they_have_returned)
{
  const CSCD::test::Allow_threads allow(2);
  for (const unsigned number_of_threads : {1u, 2u}) {
    int first = 0;
    int second = 0;
    call_both(
        number_of_threads, [&] { ++first; }, [&] { ++second; });
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 1);
  }
}

} // namespace
