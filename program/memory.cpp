// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include "commands.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
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
  if (machine >> available && process) {
    limit_memory(pages * std::size_t(sysconf(_SC_PAGESIZE)) + available * std::size_t(kilobyte));
  }
#endif
}

} // namespace cscd
