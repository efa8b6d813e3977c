// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The input of a fuzz target, read byte by byte, and its end by a fault.

#ifndef CSCD_TEST_FUZZ_BYTES_H
#define CSCD_TEST_FUZZ_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace CSCD::test {

/// Bytes that are taken one after the other; behind their end there are zeros.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_next(data), m_end(data + size) {}

  bool is_at_end() const { return m_next == m_end; }
  std::uint8_t take() { return is_at_end() ? std::uint8_t(0) : *m_next++; }
  /// All that is left, as text.
  std::string rest() const { return {m_next, m_end}; }

private:
  const std::uint8_t* m_next;
  const std::uint8_t* m_end;
};

/// Prints a fault of the library and aborts, which is what fuzzers look for.
[[noreturn]] inline void fail(const std::string& fault)
{
  std::cerr << fault << '\n';
  std::abort();
}

} // namespace CSCD::test

#endif // CSCD_TEST_FUZZ_BYTES_H
