// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parallel loop.

#ifndef CSCD_INTERNAL_FOR_EACH_INDEX_H
#define CSCD_INTERNAL_FOR_EACH_INDEX_H

#include <CSCD/internal/Loop_order.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <type_traits>
#include <utility>

namespace CSCD::internal {

/// Runs a function on indices, each time with a working object that belongs to the running thread.
/// Sequential, and the model for every tag where TBB is not linked.
template <class ConcurrencyTag, class Worker, class = void>
class For_each_index
{
public:
  /// Prepares one worker, made by `make_worker()`.
  template <class MakeWorker>
  For_each_index(MakeWorker make_worker, unsigned /* number_of_threads */) : m_worker(make_worker())
  {
  }

  /// Calls `function(i, worker)` for `i` from 0 to `size` - 1, in any order.
  template <class Function>
  void operator()(Index size, const Function& function)
  {
    for (Index i = 0; i < size; ++i) {
      function(i, m_worker);
    }
  }

  unsigned number_of_threads() const { return 1; }

private:
  Worker m_worker;
};

#ifdef CGAL_LINKED_WITH_TBB
/// The same on several threads, with one worker a thread.
template <class ConcurrencyTag, class Worker>
class For_each_index<ConcurrencyTag, Worker,
                     std::enable_if_t<std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>>>
{
public:
  /// \param make_worker makes the worker of a thread when it first needs one
  /// \param number_of_threads 0: as many as TBB allows, one a core unless the application has set another limit by
  ///        `tbb::global_control`; more than that are never used
  template <class MakeWorker>
  For_each_index(MakeWorker make_worker, unsigned number_of_threads)
      : m_number_of_threads(bounded(number_of_threads, most_threads())), m_arena(int(m_number_of_threads)),
        m_workers(std::move(make_worker))
  {
  }

  template <class Function>
  void operator()(Index size, const Function& function)
  {
    [[maybe_unused]] const Loop_order::Loop loop;
    m_arena.execute([&] {
      tbb::parallel_for(
          Index(0), size,
          [&](Index i) {
            [[maybe_unused]] const Loop_order::Call call;
            function(i, m_workers.local());
          },
          tbb::simple_partitioner());
    });
  }

  unsigned number_of_threads() const { return m_number_of_threads; }

private:
  static unsigned most_threads()
  {
    return unsigned(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  }

  static unsigned bounded(unsigned asked, unsigned available)
  {
    return asked == 0 ? available : std::min(asked, available);
  }

  unsigned m_number_of_threads;
  tbb::task_arena m_arena;
  tbb::enumerable_thread_specific<Worker> m_workers;
};
#endif

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_FOR_EACH_INDEX_H
