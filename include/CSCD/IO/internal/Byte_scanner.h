// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading numbers from bytes.

#ifndef CSCD_IO_INTERNAL_BYTE_SCANNER_H
#define CSCD_IO_INTERNAL_BYTE_SCANNER_H

#include <CSCD/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

/// Goes through binary data number by number.
class Byte_scanner
{
public:
  /// \param bytes must outlive the scanner
  /// \param order the byte order of the data
  /// \param filename for messages
  Byte_scanner(std::string_view bytes, boost::endian::order order, std::string filename)
      : m_bytes(bytes), m_order(order), m_filename(std::move(filename))
  {
  }

  /// What is left of the data, in bytes.
  std::size_t remaining() const { return m_bytes.size(); }

  /// Reads a number.
  /// \throw File_error if the data end before
  template <class Number>
  Number number()
  {
    skip_check(sizeof(Number));
    unsigned char raw[sizeof(Number)];
    std::memcpy(raw, m_bytes.data(), sizeof(Number));
    m_bytes.remove_prefix(sizeof(Number));
    return m_order == boost::endian::order::little
               ? boost::endian::endian_load<Number, sizeof(Number), boost::endian::order::little>(raw)
               : boost::endian::endian_load<Number, sizeof(Number), boost::endian::order::big>(raw);
  }

  /// Passes over `size` bytes.
  /// \throw File_error if the data end before
  void skip(std::size_t size)
  {
    skip_check(size);
    m_bytes.remove_prefix(size);
  }

private:
  void skip_check(std::size_t size) const
  {
    if (size > m_bytes.size()) {
      throw File_error(m_filename + ": the file ends before all that its header promises; it seems truncated, fetch or "
                                    "write it again");
    }
  }

  std::string_view m_bytes;
  boost::endian::order m_order;
  std::string m_filename;
};

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_BYTE_SCANNER_H
