// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several threads on any machine.

#ifndef CSCD_TEST_SUPPORT_ALLOW_THREADS_H
#define CSCD_TEST_SUPPORT_ALLOW_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>

namespace CSCD::test {

/// While an object lives, TBB runs up to `max_threads` threads, even if there are fewer cores: then they take turns at
/// any point of their work. Without TBB it does nothing.
class Allow_threads
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Allow_threads(std::size_t max_threads) : m_control(tbb::global_control::max_allowed_parallelism, max_threads)
  {
  }

private:
  tbb::global_control m_control;
#else
  explicit Allow_threads(std::size_t /* max_threads */)
  {
  }
#endif
};

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_ALLOW_THREADS_H
