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
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <streambuf>
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
  Encoded_bytes(std::string_view text, bool is_base64) : m_text(text), m_is_base64(is_base64) {}

  /// At least as many bytes as are left.
  std::size_t max_remaining() const
  {
    return m_is_base64 ? m_decoded.size() + m_text.size() / 4 * 3 + 3 : m_text.size();
  }

  /// The next `size` bytes.
  /// \throw Content_error if there are fewer
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

  [[noreturn]] static void fail()
  {
    internal::fail("binary data are not Base64, or end before all that their header promises",
                   "fetch or write the file again");
  }

  std::string_view m_text;
  bool m_is_base64;
  std::string m_decoded; ///< and not taken
};

/// The greatest compression ratio of deflate: 258 bytes to 2 bits.
inline constexpr std::size_t max_deflate_ratio = 1032;

#ifdef CSCD_WITH_ZLIB

/// Decompresses zlib or gzip as it is read. \throw Content_error if the data are damaged or end within a stream
class Inflating_buffer : public std::streambuf
{
public:
  /// \param in must outlive this object
  explicit Inflating_buffer(std::istream& in) : m_in(in)
  {
    constexpr int recognizes_header = 32;
    if (inflateInit2(&m_stream, MAX_WBITS + recognizes_header) != Z_OK) {
      fail("are damaged");
    }
  }
  Inflating_buffer(Inflating_buffer&&) = delete;
  ~Inflating_buffer() override { inflateEnd(&m_stream); }

protected:
  /// Decompresses no more than is asked for: later bytes may be damaged.
  std::streamsize xsgetn(char* bytes, std::streamsize size) override
  {
    std::streamsize done = 0;
    if (size > 0 && gptr() != egptr()) {
      bytes[done++] = traits_type::to_char_type(sbumpc());
    }
    for (std::streamsize added = 1; done < size && added > 0; done += added) {
      added = inflate_to(bytes + done, size - done);
    }
    return done;
  }

  int_type underflow() override
  {
    setg(&m_next, &m_next, &m_next + inflate_to(&m_next, 1));
    return gptr() == egptr() ? traits_type::eof() : traits_type::to_int_type(m_next);
  }

private:
  /// Decompresses the next bytes, `size` of them at most. \return their number, 0 at the end of the data
  std::streamsize inflate_to(char* bytes, std::streamsize size)
  {
    const uInt room = uInt(std::min<std::streamsize>(size, std::numeric_limits<uInt>::max()));
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
    m_in.read(m_input.data(), std::streamsize(m_input.size()));
    m_stream.next_in = reinterpret_cast<Bytef*>(m_input.data());
    m_stream.avail_in = uInt(m_in.gcount());
    if (m_stream.avail_in == 0 && !m_is_between_streams) {
      fail("end too early");
    }
    return m_stream.avail_in > 0;
  }

  [[noreturn]] static void fail(const std::string& fault)
  {
    internal::fail("compressed data " + fault, "fetch or write the file again");
  }

  std::istream& m_in;
  std::vector<char> m_input = std::vector<char>(read_block_size);
  char m_next = 0; ///< the get area: one byte that is decompressed and perhaps not taken
  z_stream m_stream{};
  bool m_is_between_streams = true;
};

#else

/// Refuses compressed data.
struct Inflating_buffer : std::streambuf
{
  explicit Inflating_buffer(std::istream&)
  {
    fail("is compressed, and this was built without zlib",
         "install zlib1g-dev and build again, or write the file without compression");
  }
};

#endif

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_DECOMPRESS_H
