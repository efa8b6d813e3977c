// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library that is loaded before a program: the call of `operator new` with the number in the variable CSCD_FAIL_AT
// fails.

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

void* operator new(std::size_t size)
{
  static const char* const text = std::getenv("CSCD_FAIL_AT");
  static const unsigned long fail_at = text != nullptr ? std::strtoul(text, nullptr, 10) : 0;
  static std::atomic<unsigned long> number{0};
  void* const memory = ++number != fail_at ? std::malloc(size > 0 ? size : 1) : nullptr;
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
