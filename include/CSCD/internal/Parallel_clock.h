// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures how much of the time several threads can share.

#ifndef CSCD_INTERNAL_PARALLEL_CLOCK_H
#define CSCD_INTERNAL_PARALLEL_CLOCK_H

#include <algorithm>
#include <chrono>

namespace CSCD::internal {

/// Wall-clock time that the calling thread has spent in parallel loops, whether or not other threads shared them: of a
/// single thread, what others could share. Reading the clock takes some tens of nanoseconds at the begin and the end of
/// a loop; of loops within loops the outermost one counts. Without TBB no loop is parallel, and all is 0.
class Parallel_clock
{
  using Clock = std::chrono::steady_clock;

public:
  /// Seconds in parallel loops of the calling thread so far. To be read outside of them.
  static double seconds() { return std::chrono::duration<double>(state().total).count(); }

  /// Lives as long as a loop.
  class Loop
  {
  public:
    /// \param is_shared whether there is more than one call, so that several threads could share them
    explicit Loop(bool is_shared) : m_is_counted(is_measuring && is_shared)
    {
      if (m_is_counted && state().depth++ == 0) {
        state().begin = Clock::now();
      }
    }
    ~Loop()
    {
      if (m_is_counted && --state().depth == 0) {
        state().total += Clock::now() - state().begin;
      }
    }
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

  private:
    const bool m_is_counted;
  };

  /// Calls `function`, within a loop of one thread, and does not count its time: several threads leave it until after
  /// the loop.
  template <class Function>
  static void run_serial_part(const Function& function)
  {
    const Clock::time_point begin = now();
    function();
    if (is_measuring) {
      state().begin += now() - begin;
    }
  }

  /// Calls `first` and `second` in the calling thread, and counts what two threads would share: the loops of both, and
  /// of the rest twice the shorter one.
  template <class First, class Second>
  static void run_both(const First& first, const Second& second)
  {
    const Clock::duration outside_first = time_outside_loops(first);
    const Clock::duration outside_second = time_outside_loops(second);
    if (is_measuring && state().depth == 0) {
      state().total += 2 * std::min(outside_first, outside_second);
    }
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  static constexpr bool is_measuring = true;
#else
  static constexpr bool is_measuring = false;
#endif

  struct State
  {
    int depth = 0;
    Clock::time_point begin; // of the outermost loop
    Clock::duration total{0};
  };

  static State& state()
  {
    static thread_local State state;
    return state;
  }

  static Clock::time_point now()
  {
    return is_measuring ? Clock::now() : Clock::time_point();
  }

  template <class Function>
  static Clock::duration time_outside_loops(const Function& function)
  {
    if (!is_measuring) {
      function();
      return {};
    }
    const Clock::duration total = state().total;
    const Clock::time_point begin = now();
    function();
    return now() - begin - (state().total - total);
  }
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_PARALLEL_CLOCK_H
