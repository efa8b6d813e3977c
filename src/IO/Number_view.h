// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that are stored as bytes: the only place where bytes become numbers.

#ifndef CSCD_SRC_IO_NUMBER_VIEW_H
#define CSCD_SRC_IO_NUMBER_VIEW_H

#include <CSCD/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

using Byte_order = boost::endian::order;

/// How a number is stored.
struct Number_type
{
  char kind = 'f';      ///< `i` an integer, `u` one without sign, `f` a floating-point number
  std::size_t size = 0; ///< in bytes: 1, 2, 4 or 8, of floating-point numbers 4 or 8

  /// Whether there is such a type.
  bool is_valid() const
  {
    const bool has_floating_size = size == 4 || size == 8;
    return has_floating_size ? kind == 'i' || kind == 'u' || kind == 'f'
                             : (size == 1 || size == 2) && (kind == 'i' || kind == 'u');
  }
};

inline bool operator==(const Number_type& a, const Number_type& b)
{
  return a.kind == b.kind && a.size == b.size;
}

/// Calls `use` with a zero of the type of C++ that `type` means. \pre the type is valid
template <class Use>
auto with_number_type(const Number_type& type, const Use& use)
{
  const bool has_sign = type.kind == 'i';
  switch (type.size) {
  case 1:
    return has_sign ? use(std::int8_t(0)) : use(std::uint8_t(0));
  case 2:
    return has_sign ? use(std::int16_t(0)) : use(std::uint16_t(0));
  case 4:
    return type.kind == 'f' ? use(float(0)) : has_sign ? use(std::int32_t(0)) : use(std::uint32_t(0));
  default:
    return type.kind == 'f' ? use(double(0)) : has_sign ? use(std::int64_t(0)) : use(std::uint64_t(0));
  }
}

/// The number that is stored at `bytes`.
template <class Number>
Number stored_number(const char* bytes, Byte_order order)
{
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes, sizeof(Number));
  if (order != Byte_order::native) {
    std::reverse(raw.begin(), raw.end());
  }
  Number number;
  std::memcpy(&number, raw.data(), sizeof(Number));
  return number;
}

/// Numbers of one type in memory, each `stride` bytes behind the one before. Integers beyond 2^53 are rounded.
struct Number_view
{
  const char* bytes = nullptr; ///< of the first one
  Number_type type;
  Byte_order order = Byte_order::little;
  std::size_t stride = 0;
  std::size_t count = 0;

  /// \pre i < count
  double operator[](std::size_t i) const
  {
    return with_number_type(
        type, [this, i](auto zero) { return double(stored_number<decltype(zero)>(bytes + i * stride, order)); });
  }

  /// Calls `use(i, number)` for all of them in their order.
  template <class Use>
  void for_each(const Use& use) const
  {
    with_number_type(type, [this, &use](auto zero) {
      for (std::size_t i = 0; i < count; ++i) {
        use(i, double(stored_number<decltype(zero)>(bytes + i * stride, order)));
      }
    });
  }
};

/// Goes through binary data number by number.
class Byte_scanner
{
public:
  /// \param bytes must outlive the scanner
  /// \param filename for messages
  Byte_scanner(std::string_view bytes, Byte_order order, std::string filename)
      : m_bytes(bytes), m_order(order), m_filename(std::move(filename))
  {
  }

  /// The size of the rest of the data, in bytes.
  std::size_t remaining() const { return m_bytes.size(); }
  /// Where the data that are left begin.
  const char* data() const { return m_bytes.data(); }
  Byte_order order() const { return m_order; }

  /// Reads a number. \throw File_error if the data end before
  template <class Number>
  Number number()
  {
    return stored_number<Number>(skip(sizeof(Number)), m_order);
  }

  /// Reads a number of any type. \pre the type is valid \throw File_error if the data end before
  double number(const Number_type& type) { return Number_view{skip(type.size), type, m_order, 0, 1}[0]; }

  /// Reads `count` numbers, one behind the other. \throw File_error if the data end before
  Number_view numbers(const Number_type& type, std::size_t count)
  {
    check(count <= m_bytes.size() / type.size);
    return {skip(count * type.size), type, m_order, type.size, count};
  }

  /// Passes over `size` bytes and returns where they begin. \throw File_error if the data end before
  const char* skip(std::size_t size)
  {
    check(size <= m_bytes.size());
    const char* const first = m_bytes.data();
    m_bytes.remove_prefix(size);
    return first;
  }

private:
  void check(bool fits) const
  {
    if (!fits) {
      throw File_error(m_filename + ": the file ends before all that its header promises; it seems truncated, fetch or "
                                    "write it again");
    }
  }

  std::string_view m_bytes;
  Byte_order m_order;
  std::string m_filename;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_NUMBER_VIEW_H
