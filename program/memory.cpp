// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace cscd {

std::size_t memory_left_in_groups(std::filesystem::path group, const std::filesystem::path& root)
{
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (;; group = group.parent_path()) {
    std::size_t bound = 0; // not a number if there is none
    std::size_t used = 0;
    if (std::ifstream(group / "memory.max") >> bound && std::ifstream(group / "memory.current") >> used) {
      std::ifstream statistics(group / "memory.stat");
      std::string key;
      for (std::size_t value = 0; statistics >> key >> value;) {
        used -= key == "file" ? std::min(used, value) : 0;
      }
      least = std::min(least, bound - std::min(bound, used));
    }
    if (group == root || group == group.parent_path()) {
      return least;
    }
  }
}

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
  const std::filesystem::path root = "/sys/fs/cgroup";
  std::ifstream groups("/proc/self/cgroup");
  std::string group;
  while (std::getline(groups, group) && group.rfind("0::/", 0) != 0) {
  }
  const std::size_t left = groups ? memory_left_in_groups((root / group.substr(4)).lexically_normal(), root)
                                  : std::numeric_limits<std::size_t>::max();
  // RLIMIT_DATA counts memory that is written to, unlike RLIMIT_AS, which counts memory that is only reserved.
  rlimit limit{};
  if (machine >> available && process && getrlimit(RLIMIT_DATA, &limit) == 0) {
    const std::size_t more = std::min(available * kilobyte, left);
    limit.rlim_cur = std::min(limit.rlim_cur, rlim_t(pages * std::size_t(sysconf(_SC_PAGESIZE)) + more));
    setrlimit(RLIMIT_DATA, &limit);
  }
#endif
}

} // namespace cscd
