// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes from Base64, and from data compressed by zlib or gzip.

#ifndef CSCD_SRC_IO_DECOMPRESS_H
#define CSCD_SRC_IO_DECOMPRESS_H

#include "IO/formats.h"

#ifdef CSCD_WITH_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

  /// All bytes that are left of Base64.
  std::string take_all()
  {
    while (skip_blanks()) {
      decode_quartet(m_decoded);
    }
    return std::move(m_decoded);
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
    fail_in_file(m_filename, "binary data are not Base64, or end before all that their header promises",
                 "fetch or write the file again");
  }

  std::string_view m_text;
  bool m_is_base64;
  std::string m_filename;
  std::string m_decoded; ///< and not taken
};

/// The greatest compression ratio of deflate: 258 bytes to 2 bits.
inline constexpr std::size_t max_deflate_ratio = 1032;

#ifdef CSCD_WITH_ZLIB

/// Decompresses zlib or gzip, piece by piece. \throw File_error, in all functions, if the data are damaged
class Inflating_stream
{
public:
  /// \param in must outlive this object
  /// \param filename for messages
  Inflating_stream(std::istream& in, std::string filename) : m_in(in), m_filename(std::move(filename))
  {
    constexpr int recognizes_header = 32;
    if (inflateInit2(&m_stream, MAX_WBITS + recognizes_header) != Z_OK) {
      fail("are damaged");
    }
  }
  Inflating_stream(Inflating_stream&&) = delete;
  ~Inflating_stream() { inflateEnd(&m_stream); }

  /// \throw File_error also if there are not `size` bytes left
  void read(char* bytes, std::size_t size)
  {
    while (size > 0) {
      const std::size_t number = read_some(bytes, size);
      if (number == 0) {
        fail("end too early");
      }
      bytes += number;
      size -= number;
    }
  }

  /// Passes over `size` bytes. \throw File_error also if there are not as many
  void skip(std::size_t size)
  {
    std::array<char, 4096> skipped{};
    for (; size > 0; size -= std::min(size, skipped.size())) {
      read(skipped.data(), std::min(size, skipped.size()));
    }
  }

  /// All that is left, but at most `max_size` bytes. \throw File_error also if it ends within a stream
  std::string read_all(std::size_t max_size = std::string::npos)
  {
    std::string result;
    for (std::size_t added = read_block_size; added > 0;) {
      const std::size_t size = result.size();
      result.resize(size + std::min(read_block_size, max_size - size));
      added = read_some(result.data() + size, result.size() - size);
      result.resize(size + added);
    }
    return result;
  }

private:
  /// Decompresses the next bytes, `size` of them at most. \return their number, 0 at the end of the data
  std::size_t read_some(char* bytes, std::size_t size)
  {
    const uInt room = uInt(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
    m_stream.next_out = reinterpret_cast<Bytef*>(bytes);
    m_stream.avail_out = room;
    while (m_stream.avail_out > 0 && (m_stream.avail_in > 0 || refill())) {
      const int status = ::inflate(&m_stream, Z_NO_FLUSH);
      m_is_between_streams = status == Z_STREAM_END;
      if (m_is_between_streams) {
        inflateReset(&m_stream); // gzip allows several streams in one file
      } else if (status != Z_OK) {
        fail("are damaged");
      }
    }
    return room - m_stream.avail_out;
  }

  /// \return false at the end of the data
  bool refill()
  {
    m_in.read(m_buffer.data(), std::streamsize(m_buffer.size()));
    m_stream.next_in = reinterpret_cast<Bytef*>(m_buffer.data());
    m_stream.avail_in = uInt(m_in.gcount());
    if (m_stream.avail_in == 0 && !m_is_between_streams) {
      fail("end too early");
    }
    return m_stream.avail_in > 0;
  }

  [[noreturn]] void fail(const std::string& fault) const
  {
    fail_in_file(m_filename, "compressed data " + fault, "fetch or write the file again");
  }

  std::istream& m_in;
  std::string m_filename;
  std::vector<char> m_buffer = std::vector<char>(read_block_size);
  z_stream m_stream{};
  bool m_is_between_streams = true;
};

#else

/// Refuses compressed data.
class Inflating_stream
{
public:
  Inflating_stream(std::istream&, const std::string& filename)
  {
    fail_in_file(filename, "is compressed, and this was built without zlib",
                 "install zlib1g-dev and build again, or write the file without compression");
  }
  void read(char*, std::size_t) {}
  void skip(std::size_t) {}
  std::string read_all(std::size_t = 0) { return {}; }
};

#endif

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_DECOMPRESS_H
