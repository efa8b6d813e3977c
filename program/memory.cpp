// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include "commands.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace cscd {

namespace {

constexpr double kilobyte = 1024; // bytes

} // namespace

std::size_t parse_memory_size(const std::string& size, const std::string& option)
{
  const std::string letters = "KMGT";
  std::istringstream in(size);
  in.imbue(std::locale::classic());
  double number = 0;
  char letter = 'M';
  const bool has_number = size.find_first_not_of("0123456789.kKmMgGtT") == std::string::npos && bool(in >> number);
  if (has_number && in.peek() != std::istringstream::traits_type::eof()) {
    letter = char(std::toupper(static_cast<unsigned char>(in.get())));
  }
  const std::size_t power = letters.find(letter) + 1;
  const double bytes = std::floor(number * std::pow(kilobyte, double(power)));
  constexpr double too_many = 9e18; // about the greatest number of bytes that the system's type holds
  if (!has_number || power == 0 || in.peek() != std::istringstream::traits_type::eof() || !(bytes >= 1) ||
      bytes > too_many) {
    throw Usage_error(option +
                      ": must be a number of megabytes, or with K, M, G or T behind it, as in 800M or 2G, not " + size);
  }
  return std::size_t(bytes);
}

void limit_memory(std::size_t bytes)
{
#ifdef __linux__
  // What is written to counts, unlike RLIMIT_AS, which counts what the allocator only reserves.
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) == 0) {
    limit.rlim_cur = std::min(limit.rlim_cur, rlim_t(bytes));
    setrlimit(RLIMIT_DATA, &limit);
  }
#endif
}

std::size_t memory_left_in_groups(std::filesystem::path group, const std::filesystem::path& root)
{
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (;; group = group.parent_path()) {
    std::size_t bound = 0; // no number where there is none
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
  if (machine >> available && process) {
    limit_memory(pages * std::size_t(sysconf(_SC_PAGESIZE)) + std::min(available * std::size_t(kilobyte), left));
  }
#endif
}

} // namespace cscd
