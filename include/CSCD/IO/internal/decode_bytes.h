// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes from Base64, and from compressed bytes.

#ifndef CSCD_IO_INTERNAL_DECODE_BYTES_H
#define CSCD_IO_INTERNAL_DECODE_BYTES_H

#include <CSCD/exceptions.h>

#ifdef CSCD_WITH_ZLIB
#include <zlib.h>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

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

  /// All bytes that are left, up to what is no Base64.
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
  static constexpr int bits_of_digit = 6;

  bool skip_blanks()
  {
    const std::size_t digit = m_text.find_first_not_of(" \t\r\n");
    m_text.remove_prefix(digit == std::string_view::npos ? m_text.size() : digit);
    return !m_text.empty();
  }

  /// The value of a digit; -1 of other characters.
  static int value(char c)
  {
    return c >= 'A' && c <= 'Z'   ? c - 'A'
           : c >= 'a' && c <= 'z' ? c - 'a' + 26
           : c >= '0' && c <= '9' ? c - '0' + 52
           : c == '+'             ? 62
           : c == '/'             ? 63
                                  : -1;
  }

  /// Appends three bytes; fewer where `=` fills the last digits, behind which further data may follow.
  void decode_quartet(std::string& bytes)
  {
    std::uint32_t bits = 0;
    int number_of_digits = 0;
    for (int i = 0; i < 4; ++i) {
      if (!skip_blanks()) {
        fail();
      }
      const char c = m_text.front();
      m_text.remove_prefix(1);
      const int digit = value(c);
      const bool is_filling = c == '=' && i >= 2;
      if ((digit < 0 && !is_filling) || (digit >= 0 && number_of_digits < i)) {
        fail();
      }
      number_of_digits += is_filling ? 0 : 1;
      bits = bits << bits_of_digit | std::uint32_t(is_filling ? 0 : digit);
    }
    for (int i = 0; i + 1 < number_of_digits; ++i) {
      bytes.push_back(char(bits >> (16 - 8 * i) & 0xffU));
    }
  }

  [[noreturn]] void fail() const
  {
    throw File_error(m_filename + ": binary data are no Base64, or end before all that their header promises; fetch or "
                                  "write the file again");
  }

  std::string_view m_text;
  bool m_is_base64;
  std::string m_filename;
  std::string m_decoded; ///< and not taken
};

/// \throw File_error telling that compressed data are damaged
[[noreturn]] inline void fail_to_decompress(const std::string& filename)
{
  throw File_error(filename + ": compressed data are damaged; fetch or write the file again");
}

/// \throw File_error telling that this was built without `library`, that of Debian's `package`
[[noreturn]] inline void fail_without_library(const std::string& filename, const char* library, const char* package)
{
  throw File_error(filename + ": is compressed, and this was built without " + library + "; install " + package +
                   " and build again, or write the file without compression");
}

/// \throw File_error telling that this was built without zlib
[[noreturn]] inline void fail_without_zlib(const std::string& filename)
{
  fail_without_library(filename, "zlib", "zlib1g-dev");
}

/// \throw File_error telling that compressed data end too early
[[noreturn]] inline void fail_at_end_of_compressed(const std::string& filename)
{
  throw File_error(filename + ": compressed data end too early; fetch or write the file again");
}

/// Decompresses what zlib has compressed.
/// \param size of the result
/// \throw File_error if the result has another size, if the data are damaged, or if this is built without zlib
inline std::string inflate(std::string_view bytes, std::size_t size, const std::string& filename)
{
  constexpr std::size_t max_ratio = 1032; // of deflate: 258 bytes of 2 bits
  if (size / max_ratio > bytes.size()) {
    fail_to_decompress(filename);
  }
#ifdef CSCD_WITH_ZLIB
  std::string result(size, '\0');
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = uInt(result.size());
  const bool fits = bytes.size() == stream.avail_in && result.size() == stream.avail_out;
  if (!fits || inflateInit(&stream) != Z_OK) {
    fail_to_decompress(filename);
  }
  const int status = ::inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (status != Z_STREAM_END || stream.total_out != size) {
    fail_to_decompress(filename);
  }
  return result;
#else
  fail_without_zlib(filename);
#endif
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_DECODE_BYTES_H
