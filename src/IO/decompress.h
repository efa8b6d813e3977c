// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes from Base64, and from data compressed by zlib or gzip.

#ifndef CSCD_SRC_IO_DECOMPRESS_H
#define CSCD_SRC_IO_DECOMPRESS_H

#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

/// Bytes that are read at once: the calls do not count, and small files are fast.
inline constexpr std::size_t read_block_size = std::size_t(1) << 16U;

/// Bytes that stand in a file as they are or in Base64, read piece by piece.
class Encoded_bytes
{
public:
  /// \param text must outlive the bytes
  /// \param filename for messages
  Encoded_bytes(std::string_view text, bool is_base64, std::string filename)
      : m_text(text), m_is_base64(is_base64), m_filename(std::move(filename))
  {
  }

  /// At least as many bytes as are left.
  std::size_t max_remaining() const
  {
    return m_is_base64 ? m_decoded.size() + m_text.size() / 4 * 3 + 3 : m_text.size();
  }

  /// The next `size` bytes.
  /// \throw File_error if there are fewer
  std::string take(std::size_t size)
  {
    if (size > max_remaining()) {
      fail();
    }
    if (!m_is_base64) {
      std::string result(m_text.substr(0, size));
      m_text.remove_prefix(size);
      return result;
    }
    std::string result = std::move(m_decoded);
    result.reserve(size + 2);
    while (result.size() < size) {
      decode_quartet(result);
    }
    m_decoded = result.substr(size);
    result.resize(size);
    return result;
  }

  /// All bytes that are left, up to the end of the Base64.
  std::string take_all()
  {
    std::string result = m_is_base64 ? std::move(m_decoded) : std::string(m_text);
    while (m_is_base64 && skip_blanks()) {
      decode_quartet(result);
    }
    m_text = {};
    return result;
  }

private:
  bool skip_blanks()
  {
    m_text.remove_prefix(std::min(m_text.find_first_not_of(" \t\r\n"), m_text.size()));
    return !m_text.empty();
  }

  /// Appends three bytes; fewer where `=` fills the last digits; further data may follow.
  void decode_quartet(std::string& bytes)
  {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::uint32_t bits = 0;
    int number_of_digits = 0;
    for (int i = 0; i < 4; ++i) {
      if (!skip_blanks()) {
        fail();
      }
      const std::size_t digit = digits.find(m_text.front());
      const bool is_digit = digit < digits.size() && number_of_digits == i;
      if (!is_digit && (m_text.front() != '=' || i < 2)) {
        fail();
      }
      number_of_digits += is_digit ? 1 : 0;
      bits = bits << 6U | std::uint32_t(is_digit ? digit : 0);
      m_text.remove_prefix(1);
    }
    for (int i = 0; i + 1 < number_of_digits; ++i) {
      bytes.push_back(char(bits >> (16 - 8 * i) & 0xffU));
    }
  }

  [[noreturn]] void fail() const
  {
    throw File_error(m_filename +
                     ": binary data are not Base64, or end before all that their header promises; fetch or "
                     "write the file again");
  }

  std::string_view m_text;
  bool m_is_base64;
  std::string m_filename;
  std::string m_decoded; ///< and not taken
};

/// The greatest compression ratio of deflate: 258 bytes to 2 bits.
inline constexpr std::size_t max_deflate_ratio = 1032;

/// Decompresses zlib or gzip, piece by piece.
class Inflating_stream
{
public:
  /// \param in must outlive this object
  /// \param filename for messages
  /// \throw File_error if this is built without zlib
  Inflating_stream(std::istream& in, const std::string& filename);
  ~Inflating_stream();

  /// \throw File_error if there are not `size` bytes left, or they are damaged
  void read(char* bytes, std::size_t size);
  /// Passes over `size` bytes. \throw File_error if there are not as many, or they are damaged
  void skip(std::size_t size);
  /// All that is left, but at most `max_size` bytes. \throw File_error if it is damaged, or ends within a stream
  std::string read_all(std::size_t max_size = std::string::npos);

private:
  struct State;
  std::unique_ptr<State> m_state;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_DECOMPRESS_H
