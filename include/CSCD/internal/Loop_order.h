// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order that a parallel loop keeps, made visible to the thread sanitizer.

#ifndef CSCD_INTERNAL_LOOP_ORDER_H
#define CSCD_INTERNAL_LOOP_ORDER_H

#ifdef CSCD_THREAD_SANITIZER
#include <atomic>
#endif

namespace CSCD::internal {

/// What comes before a parallel loop comes before each of its calls, and each call before what follows the loop. TBB
/// keeps this order by means of its library, which is not compiled with the thread sanitizer: all that a loop hands to
/// its calls and gets back from them would look like a race. With the macro `CSCD_THREAD_SANITIZER` these objects keep
/// the order once more, where the sanitizer sees it; without it they do nothing.
/// The calls of a loop stay without order among themselves, so that races between them are found.
struct Loop_order
{
#ifdef CSCD_THREAD_SANITIZER
  /// Lives in the calling thread from before the loop until after it, also when the loop throws.
  struct Loop
  {
    Loop() { number_of_begins.fetch_add(1, std::memory_order_release); }
    ~Loop() { number_of_ends.load(std::memory_order_acquire); }
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
  };
  /// Lives as long as one call of the loop; to be made before the call reads anything from outside.
  struct Call
  {
    Call() { number_of_begins.load(std::memory_order_acquire); }
    ~Call() { number_of_ends.fetch_add(1, std::memory_order_release); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
  };

private:
  // Not members of a loop: a call would have to read where that is before it has an order.
  static inline std::atomic<unsigned> number_of_begins{0};
  static inline std::atomic<unsigned> number_of_ends{0};
#else
  struct Loop
  {
  };
  struct Call
  {
  };
#endif
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_LOOP_ORDER_H
