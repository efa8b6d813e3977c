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

/// Calls `function(begin, end)` for ranges of `range_size` indices, from 0 to `size` - 1, the last one shorter: which
/// they are does not depend on the number of threads. In order where there is one thread.
/// \param number_of_threads 0 for as many as TBB allows
void for_each_range(Index size, unsigned number_of_threads, const std::function<void(Index, Index)>& function);

/// Calls `function(i)` for `i` from 0 to `size` - 1, each of which is enough work for a thread. In order where there is
/// one thread.
void for_each_part(Index size, unsigned number_of_threads, const std::function<void(Index)>& function);

/// Calls `first()` and `second()`, at the same time where there are several threads, else in this order.
void call_both(unsigned number_of_threads, const std::function<void()>& first, const std::function<void()>& second);

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/internal/for_each_range_impl.h>
#endif

#endif // CSCD_INTERNAL_FOR_EACH_RANGE_H
