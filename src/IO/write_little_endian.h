// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Binary numbers to streams.

#ifndef CSCD_SRC_IO_WRITE_LITTLE_ENDIAN_H
#define CSCD_SRC_IO_WRITE_LITTLE_ENDIAN_H

#include <boost/endian/conversion.hpp>

#include <array>
#include <ostream>

namespace CSCD::internal {

/// Writes a number in binary.
template <class Number>
void write_little_endian(std::ostream& out, Number number)
{
  std::array<unsigned char, sizeof(Number)> bytes{};
  boost::endian::endian_store<Number, sizeof(Number), boost::endian::order::little>(bytes.data(), number);
  out.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_WRITE_LITTLE_ENDIAN_H
