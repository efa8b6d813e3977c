// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of for_each_range.h.

#ifndef CSCD_INTERNAL_FOR_EACH_RANGE_IMPL_H
#define CSCD_INTERNAL_FOR_EACH_RANGE_IMPL_H

#include <CSCD/internal/for_each_index.h>
#include <CSCD/internal/for_each_range.h>

#include <algorithm>

#ifdef CGAL_LINKED_WITH_TBB

namespace CSCD::internal {

CSCD_INLINE void for_each_range(Index size, unsigned number_of_threads,
                                const std::function<void(Index, Index)>& function)
{
  const Index number_of_ranges = size / range_size + (size % range_size != 0 ? 1 : 0);
  for_each_part(number_of_ranges, number_of_threads, [size, &function](Index range) {
    const Index begin = range * range_size;
    function(begin, begin + std::min(range_size, size - begin));
  });
}

CSCD_INLINE void for_each_part(Index size, unsigned number_of_threads, const std::function<void(Index)>& function)
{
  For_each_index<char> for_each([] { return '\0'; }, size > 1 ? number_of_threads : 1);
  for_each(size, [&function](Index i, char&) { function(i); });
}

CSCD_INLINE void call_both(unsigned number_of_threads, const std::function<void()>& first,
                           const std::function<void()>& second)
{
  if (number_of_loop_threads(number_of_threads) == 1) {
    first();
    second();
    return;
  }
  For_each_index<char> for_each([] { return '\0'; }, number_of_threads);
  for_each(2, [&](Index i, char&) { i == 0 ? first() : second(); });
}

} // namespace CSCD::internal

#endif // CGAL_LINKED_WITH_TBB

#endif // CSCD_INTERNAL_FOR_EACH_RANGE_IMPL_H
