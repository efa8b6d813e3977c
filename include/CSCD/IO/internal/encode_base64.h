// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrays of numbers as text.

#ifndef CSCD_IO_INTERNAL_ENCODE_BASE64_H
#define CSCD_IO_INTERNAL_ENCODE_BASE64_H

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace CSCD::internal {

/// The bytes of `numbers`, least significant first: what the typed arrays of a browser hold.
template <class Number>
std::string little_endian_bytes(const std::vector<Number>& numbers)
{
  using Bits = std::conditional_t<sizeof(Number) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  static_assert(sizeof(Number) == sizeof(Bits), "only numbers of four or eight bytes");
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Bits bits;
    std::memcpy(&bits, &numbers[i], sizeof bits);
    boost::endian::native_to_little_inplace(bits);
    std::memcpy(&bytes[i * sizeof bits], &bits, sizeof bits);
  }
  return bytes;
}

/// `bytes` in base 64, padded with `=` to a multiple of four characters.
inline std::string encode_base64(std::string bytes)
{
  namespace iterators = boost::archive::iterators;
  constexpr int bits_of_character = 6;
  constexpr int bits_of_byte = 8;
  using Encoded =
      iterators::base64_from_binary<iterators::transform_width<const char*, bits_of_character, bits_of_byte>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0'); // the iterators read groups of three bytes to their end
  std::string text(Encoded(bytes.data()), Encoded(bytes.data() + bytes.size()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_ENCODE_BASE64_H
