// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What counts as time that several threads can share.

#include <CSCD/Vector_3.h>
#include <CSCD/internal/Parallel_clock.h>
#include <CSCD/internal/for_each_range.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#ifdef CGAL_LINKED_WITH_TBB

namespace {

using CSCD::Index;
using CSCD::internal::call_both;
using CSCD::internal::for_each_part;
using CSCD::internal::Parallel_clock;

constexpr double pause = 0.02; // in seconds; sleeping takes longer, never shorter

void wait(double seconds = pause)
{
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// What is counted while `function` runs.
template <class Function>
double counted(const Function& function)
{
  const double begin = Parallel_clock::seconds();
  function();
  return Parallel_clock::seconds() - begin;
}

TEST(Parallel_clock, counts_loops_of_one_thread_once_where_they_are_in_each_other)
{
  EXPECT_GE(counted([] { for_each_part(2, 1, [](Index) { wait(); }); }), 2 * pause);
  double seconds = 0;
  const double nested = counted([&seconds] {
    const auto begin = std::chrono::steady_clock::now();
    for_each_part(2, 1, [](Index) { for_each_part(2, 1, [](Index) { wait(); }); });
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  });
  EXPECT_GE(nested, 4 * pause);
  EXPECT_LE(nested, seconds);
}

TEST(Parallel_clock, counts_no_loop_of_a_single_call_and_nothing_outside_of_loops)
{
  EXPECT_EQ(counted([] { wait(); }), 0);
  EXPECT_EQ(counted([] { for_each_part(1, 1, [](Index) { wait(); }); }), 0);
}

TEST(Parallel_clock, leaves_out_serial_parts_of_loops)
{
  double seconds = 0;
  const double all = counted([&seconds] {
    const auto begin = std::chrono::steady_clock::now();
    for_each_part(2, 1, [](Index) { Parallel_clock::run_serial_part([] { wait(); }); });
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  });
  EXPECT_LE(all, seconds - 2 * pause);
}

TEST(Parallel_clock, counts_of_two_calls_twice_the_shorter_one_and_their_loops)
{
  double longer = 0;
  const double both = counted([&longer] {
    call_both(
        1, [] { wait(); },
        [&longer] {
          const auto begin = std::chrono::steady_clock::now();
          wait(4 * pause);
          longer = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        });
  });
  EXPECT_GE(both, 2 * pause);
  EXPECT_LE(both, 2 * longer);
  const double with_loop = counted([] {
    call_both(
        1, [] {}, [] { for_each_part(2, 1, [](Index) { wait(); }); });
  });
  EXPECT_GE(with_loop, 2 * pause);
}

} // namespace

#endif // CGAL_LINKED_WITH_TBB
