// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#ifdef __linux__
#include <algorithm>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace cscd {

void limit_memory_to_available()
{
#ifdef __linux__
  constexpr std::size_t kilobyte = 1024; // bytes
  std::ifstream machine("/proc/meminfo");
  std::string key;
  std::size_t available = 0; // kilobytes
  while (machine >> key && key != "MemAvailable:") {
    machine.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  std::ifstream process("/proc/self/statm"); // pages: whole size, resident, shared, code, 0, data
  std::size_t pages = 0;
  for (int column = 0; column < 6; ++column) {
    process >> pages;
  }
  // RLIMIT_DATA counts memory that is written to, unlike RLIMIT_AS, which counts memory that is only reserved.
  rlimit limit{};
  if (machine >> available && process && getrlimit(RLIMIT_DATA, &limit) == 0) {
    limit.rlim_cur =
        std::min(limit.rlim_cur, rlim_t(pages * std::size_t(sysconf(_SC_PAGESIZE)) + available * kilobyte));
    setrlimit(RLIMIT_DATA, &limit);
  }
#endif
}

} // namespace cscd
