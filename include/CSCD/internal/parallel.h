// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parallel loop.

#ifndef CSCD_INTERNAL_PARALLEL_H
#define CSCD_INTERNAL_PARALLEL_H

#include <CSCD/Vector3.h>

#include <algorithm>
#include <utility>

#ifdef CSCD_THREAD_SANITIZER
#include <atomic>
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CSCD::internal {

/// The code before a parallel loop runs before each of its calls, and each call before the code after the loop. TBB
/// keeps this order by means of its library, which is not compiled with the thread sanitizer: all data that a loop
/// hands to its calls and gets back from them would look like a race. With the macro `CSCD_THREAD_SANITIZER` these
/// objects keep the order once more, where the sanitizer sees it; without it they do nothing. The calls of a loop stay
/// without order among themselves, so that races between them are found.
struct Tsan_ordering
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

/// The number of threads that a loop has for `requested` ones, 0 for as many as TBB allows: never more than that.
inline unsigned number_of_loop_threads(unsigned requested)
{
#ifdef CGAL_LINKED_WITH_TBB
  const auto allowed = unsigned(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
#else
  const unsigned allowed = 1;
#endif
  return requested == 0 ? allowed : std::min(requested, allowed);
}

/// Runs a function on indices, each time with a working object that belongs to the running thread: by TBB where it is
/// linked and more than one thread is requested.
template <class Worker>
class For_each_index
{
public:
  /// \param make_worker makes the worker of a thread when it first needs one
  /// \param number_of_threads 0: as many as TBB allows, one a core unless the application has set another limit by
  ///        `tbb::global_control`; more than that are never used
  template <class MakeWorker>
  For_each_index(MakeWorker make_worker, unsigned number_of_threads)
      : m_number_of_threads(number_of_loop_threads(number_of_threads)),
#ifdef CGAL_LINKED_WITH_TBB
        m_arena(int(m_number_of_threads)),
#endif
        m_workers(std::move(make_worker))
  {
  }

  /// Calls `function(i, worker)` for `i` from 0 to `size` - 1, in this order where there is one thread.
  template <class Function>
  void operator()(Index size, const Function& function)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if (m_number_of_threads > 1) {
      [[maybe_unused]] const Tsan_ordering::Loop loop;
      m_arena.execute([&] {
        tbb::parallel_for(
            Index(0), size,
            [&](Index i) {
              [[maybe_unused]] const Tsan_ordering::Call call;
              function(i, m_workers.local());
            },
            tbb::simple_partitioner());
      });
      return;
    }
#endif
    for (Index i = 0; i < size; ++i) {
      function(i, m_workers.local());
    }
  }

  unsigned number_of_threads() const
  {
    return m_number_of_threads;
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  using Workers = tbb::enumerable_thread_specific<Worker>;
#else
  struct Workers
  {
    template <class MakeWorker>
    explicit Workers(MakeWorker make_worker) : worker(make_worker())
    {
    }
    Worker& local() { return worker; }
    Worker worker;
  };
#endif

  unsigned m_number_of_threads;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_arena m_arena;
#endif
  Workers m_workers;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_PARALLEL_H
