// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The greatest memory of the process.

#ifndef CSCD_BENCHMARK_SUPPORT_PEAK_MEMORY_H
#define CSCD_BENCHMARK_SUPPORT_PEAK_MEMORY_H

#include <fstream>
#include <limits>
#include <malloc.h>
#include <string>

namespace CSCD::benchmark {

/// The greatest resident memory of the process since this object was made, on Linux.
class Peak_memory
{
public:
  Peak_memory()
  {
    malloc_trim(0);                                // memory that earlier work has freed shall not count
    std::ofstream("/proc/self/clear_refs") << "5"; // resets the peak
  }

  /// In megabytes of 10^6 bytes, the input included; 0 on other systems.
  double megabytes() const
  {
    constexpr double megabytes_per_kibibyte = 1.024e-3;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word; status.ignore(std::numeric_limits<std::streamsize>::max(), '\n')) {
      if (word == "VmHWM:") {
        double kibibytes = 0;
        status >> kibibytes;
        return megabytes_per_kibibyte * kibibytes;
      }
    }
    return 0;
  }
};

} // namespace CSCD::benchmark

#endif // CSCD_BENCHMARK_SUPPORT_PEAK_MEMORY_H
