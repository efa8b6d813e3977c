// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parallel loop over ranges of indices, for headers that should not include that of TBB.

#ifndef CSCD_INTERNAL_FOR_EACH_RANGE_H
#define CSCD_INTERNAL_FOR_EACH_RANGE_H

#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <functional>

namespace CSCD::internal {

/// The indices that `for_each_range()` passes at once: enough that the loop itself does not count.
inline constexpr Index range_size = 1U << 13U;

#ifdef CGAL_LINKED_WITH_TBB

/// Whether there can be several threads.
inline constexpr bool has_threads = true;

/// Calls `function(begin, end)` for ranges of `range_size` indices, from 0 to `size` - 1, the last one shorter: which
/// they are does not depend on the number of threads. In order where there is one thread.
/// \param number_of_threads 0 for as many as TBB allows
void for_each_range(Index size, unsigned number_of_threads, const std::function<void(Index, Index)>& function);

/// Calls `function(i)` for `i` from 0 to `size` - 1, each of which is enough work for a thread. In order where there is
/// one thread.
void for_each_part(Index size, unsigned number_of_threads, const std::function<void(Index)>& function);

/// Calls `first()` and `second()`, at the same time where there are several threads, else in this order.
void call_both(unsigned number_of_threads, const std::function<void()>& first, const std::function<void()>& second);

#else

inline constexpr bool has_threads = false;

// Templates, as a `std::function` takes more code than the loop of one thread.

template <class Function>
void for_each_range(Index size, unsigned /* number_of_threads */, const Function& function)
{
  for (Index begin = 0, end = 0; begin < size; begin = end) {
    end = begin + (size - begin < range_size ? size - begin : range_size);
    function(begin, end);
  }
}

template <class Function>
void for_each_part(Index size, unsigned /* number_of_threads */, const Function& function)
{
  for (Index i = 0; i < size; ++i) {
    function(i);
  }
}

template <class First, class Second>
void call_both(unsigned /* number_of_threads */, const First& first, const Second& second)
{
  first();
  second();
}

#endif // CGAL_LINKED_WITH_TBB

} // namespace CSCD::internal

#if defined(CGAL_LINKED_WITH_TBB) && !defined(CSCD_COMPILED)
#include <CSCD/internal/for_each_range_impl.h>
#endif

#endif // CSCD_INTERNAL_FOR_EACH_RANGE_H
