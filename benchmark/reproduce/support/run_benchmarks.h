// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The main function of benchmarks that are registered at run time.

#ifndef CSCD_BENCHMARK_SUPPORT_RUN_BENCHMARKS_H
#define CSCD_BENCHMARK_SUPPORT_RUN_BENCHMARKS_H

#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>

namespace CSCD::benchmark {

/// Calls `add()`, which registers benchmarks, and runs them by the arguments of the program. \return its exit status
template <class Add>
int run_benchmarks(int argc, char** argv, const Add& add)
{
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  try {
    add();
    ::benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  ::benchmark::Shutdown();
  return 0;
}

} // namespace CSCD::benchmark

#endif // CSCD_BENCHMARK_SUPPORT_RUN_BENCHMARKS_H
