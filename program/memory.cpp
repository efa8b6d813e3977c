// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace cscd {

namespace {

constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();

/// The number in a file, or after `key` there; nothing without a number, for example if a group has no bound.
std::optional<std::size_t> number_in(const std::string& file, const std::string& key = "")
{
  std::ifstream in(file);
  for (std::string word; !key.empty() && in >> word && word != key;) {
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  std::size_t result = 0;
  return in >> result ? std::optional(result) : std::nullopt;
}

/// The bytes that a bound leaves. \param used the file of the bytes in use \param free how many of them are a cache
std::size_t left_by(const std::string& bound, const std::string& used, std::size_t free)
{
  const std::optional<std::size_t> most = number_in(bound);
  const std::optional<std::size_t> now = number_in(used);
  return most && now ? *most - std::min(*most, *now - std::min(*now, free)) : unbounded;
}

/// The bytes that one control group leaves.
std::size_t memory_left_in_group(const std::string& group, std::size_t swap)
{
  const std::size_t cache = number_in(group + "/memory.stat", "file").value_or(0);
  const std::size_t swap_left = std::min(swap, left_by(group + "/memory.swap.max", group + "/memory.swap.current", 0));
  const std::size_t left = left_by(group + "/memory.max", group + "/memory.current", cache);
  return left > unbounded - swap_left ? unbounded : left + swap_left;
}

#ifdef __linux__
/// The bytes that the control groups of this process leave.
std::size_t memory_left_in_own_groups(std::size_t swap)
{
  const std::string root = "/sys/fs/cgroup";
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (line.rfind("0::/", 0) == 0) { // the path of the group of version 2 is behind the colons
      return memory_left_in_groups(root + line.substr(line.find('/')), root, swap);
    }
  }
  return unbounded;
}
#endif

} // namespace

// Strings, since copies of std::filesystem::path crash in libstdc++ where memory runs out.
std::size_t memory_left_in_groups(std::string group, const std::string& root, std::size_t swap)
{
  std::size_t least = memory_left_in_group(root, swap);
  for (; group.size() > root.size(); group.resize(group.rfind('/'))) {
    least = std::min(least, memory_left_in_group(group, swap));
  }
  return least;
}

void limit_memory_to_available()
{
#ifdef __linux__
  constexpr std::size_t kilobyte = 1024; // bytes
  const std::size_t available = kilobyte * number_in("/proc/meminfo", "MemAvailable:").value_or(0);
  const std::size_t swap = kilobyte * number_in("/proc/meminfo", "SwapFree:").value_or(0);
  std::ifstream process("/proc/self/statm"); // pages: whole size, resident, shared, code, 0, data
  std::size_t pages = 0;
  for (int column = 0; column < 6; ++column) {
    process >> pages;
  }
  // RLIMIT_DATA counts memory that is written to, unlike RLIMIT_AS, which counts memory that is only reserved.
  rlimit limit{};
  if (available > 0 && process && getrlimit(RLIMIT_DATA, &limit) == 0) {
    const std::size_t more = std::min(available + swap, memory_left_in_own_groups(swap));
    limit.rlim_cur = std::min(limit.rlim_cur, rlim_t(pages * std::size_t(sysconf(_SC_PAGESIZE)) + more));
    setrlimit(RLIMIT_DATA, &limit);
  }
#endif
}

} // namespace cscd
