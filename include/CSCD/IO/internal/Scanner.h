// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the contents of files, numbers and words from text, and numbers from bytes.

#ifndef CSCD_IO_INTERNAL_SCANNER_H
#define CSCD_IO_INTERNAL_SCANNER_H

#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/internal/Inflating_stream.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CSCD::internal {

/// The number of bytes that are left in `in`, or 0 where that is not known, as of a pipe.
inline std::size_t remaining_size(std::istream& in)
{
  const std::istream::pos_type begin = in.tellg();
  if (begin == std::istream::pos_type(-1)) {
    return 0;
  }
  in.seekg(0, std::ios::end);
  const std::istream::pos_type end = in.tellg();
  in.clear();
  in.seekg(begin);
  return end > begin ? static_cast<std::size_t>(end - begin) : 0;
}

/// All that is left in `in`, decompressed if the ending of `format` tells how.
/// \param name for messages
/// \throw File_error if reading fails, or if it cannot be decompressed
inline std::string read_content(std::istream& in, const std::string& name, const std::string& format = "")
{
  if (const std::optional<Compression> compression = find_compression(format)) {
    return read_compressed(in, *compression, name);
  }
  constexpr std::size_t block_size = std::size_t(1) << 20; // bytes; large enough that the calls do not count
  std::string content;
  content.reserve(remaining_size(in) + block_size); // growing, it would be in memory twice
  while (in) {
    const std::size_t size = content.size();
    content.resize(size + block_size);
    in.read(content.data() + size, static_cast<std::streamsize>(block_size));
    content.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) {
    throw File_error(name + ": cannot be read to its end; check the disk or the connection");
  }
  return content;
}

/// The content of the file `filename`, decompressed if its ending tells how.
/// \throw File_error if it cannot be read
inline std::string read_content(const std::string& filename)
{
  std::error_code error;
  if (std::filesystem::is_directory(filename, error)) {
    throw File_error(filename + ": is a folder; name a file in it");
  }
  errno = 0;
  std::ifstream in(filename, std::ios::binary);
  if (!in) {
    throw File_error(filename + ": cannot be opened (" + (errno != 0 ? std::strerror(errno) : "unknown reason") +
                     "); check the name and the permissions");
  }
  const auto size = std::filesystem::file_size(filename, error);
  if (error || find_compression(filename)) {
    return read_content(in, filename, filename); // a pipe, or of another size
  }
  std::string content(static_cast<std::size_t>(size), '\0');
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) {
    throw File_error(filename + ": cannot be read to its end; check the disk or the connection");
  }
  return content;
}

/// As `std::from_chars()`, which not every standard library has for floating-point numbers; where it is
/// missing, an underflow gives 0, and the locale of C has to be "C".
inline std::from_chars_result number_from_chars(const char* first, const char* last, double& value)
{
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, value);
#else
  const auto belongs = [&](const char* at) {
    const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(*at)));
    return (lower != 'x' && std::isalnum(static_cast<unsigned char>(*at)) != 0) || *at == '.' ||
           (*at == '-' && at == first) || ((*at == '-' || *at == '+') && (at[-1] == 'e' || at[-1] == 'E'));
  };
  const char* end = first;
  while (end != last && belongs(end)) {
    ++end;
  }
  const std::string text(first, end);
  char* text_end = nullptr;
  const double number = std::strtod(text.c_str(), &text_end);
  if (text_end == text.c_str()) {
    return {first, std::errc::invalid_argument};
  }
  const bool is_out_of_range = std::isinf(number) && text.find_first_of("0123456789") != std::string::npos;
  if (is_out_of_range) {
    return {first + (text_end - text.c_str()), std::errc::result_out_of_range};
  }
  value = number;
  return {first + (text_end - text.c_str()), std::errc()};
#endif
}

/// Goes through a text token by token, in the C locale whatever the global one is. Tokens end at blanks.
/// `CGAL::IO::read_OFF()` and its like are not used: they take some fifteen times as long, allocate what a header
/// promises before it is checked, and are undefined on some malformed files.
class Text_scanner
{
public:
  /// \param text must outlive the scanner
  /// \param filename for messages
  Text_scanner(std::string_view text, std::string filename)
      : m_begin(text.data()), m_at(text.data()), m_end(text.data() + text.size()), m_filename(std::move(filename))
  {
  }

  /// What is left of the text, in bytes.
  std::size_t remaining() const { return static_cast<std::size_t>(m_end - m_at); }
  /// What is left of the text.
  std::string_view rest() const { return {m_at, remaining()}; }

  /// Passes over `size` bytes. \pre there are as many
  void skip(std::size_t size) { m_at += size; }
  /// Goes back by `size` bytes. \pre so many were read
  void unread(std::size_t size) { m_at -= size; }

  /// Goes on to the next token, over line ends and, if `comment` is not 0, over all that follows it in a line.
  /// \return false at the end of the text
  bool skip_blanks(char comment = 0)
  {
    while (m_at != m_end) {
      if (is_blank(*m_at)) {
        ++m_at;
      } else if (comment != 0 && *m_at == comment) {
        skip_line();
      } else {
        return true;
      }
    }
    return false;
  }

  /// Goes on to the next token of this line. \return false if there is none
  bool skip_blanks_in_line()
  {
    while (m_at != m_end && *m_at != '\n' && is_blank(*m_at)) {
      ++m_at;
    }
    return m_at != m_end && *m_at != '\n';
  }

  /// Goes on to the beginning of the next line.
  void skip_line()
  {
    while (m_at != m_end && *m_at != '\n') {
      ++m_at;
    }
    if (m_at != m_end) {
      ++m_at;
    }
  }

  /// Whether the next character is a digit.
  bool is_at_digit() const { return m_at != m_end && *m_at >= '0' && *m_at <= '9'; }

  /// Whether a number is next.
  bool is_at_number() const
  {
    double value = 0;
    const bool has_plus = m_at != m_end && *m_at == '+';
    return number_from_chars(m_at + (has_plus ? 1 : 0), m_end, value).ec != std::errc::invalid_argument;
  }

  /// Whether `text` is next.
  bool is_at(std::string_view text) const { return std::string_view(m_at, remaining()).substr(0, text.size()) == text; }

  /// Passes over `character` if it is the next one. \return whether it is
  bool skip_character(char character)
  {
    const bool is_next = m_at != m_end && *m_at == character;
    m_at += is_next ? 1 : 0;
    return is_next;
  }

  /// Reads up to the next blank; empty if there is nothing before it.
  std::string_view word()
  {
    const char* first = m_at;
    while (m_at != m_end && !is_blank(*m_at)) {
      ++m_at;
    }
    return {first, static_cast<std::size_t>(m_at - first)};
  }

  /// Reads a number, which may be infinite or none (`nan`).
  /// \throw File_error if there is no number at this place
  double number()
  {
    skip_plus();
    double value = 0;
    const std::from_chars_result result = number_from_chars(m_at, m_end, value);
    if (result.ec == std::errc::result_out_of_range && is_underflow(m_at, result.ptr)) {
      value = 0;
    } else if (result.ec != std::errc() || (result.ptr != m_end && !is_blank(*result.ptr))) {
      fail("a number with a decimal point is expected", "correct this line or write the file again");
    }
    m_at = result.ptr;
    return value;
  }

  /// Reads a number which is finite.
  /// \throw File_error if there is none at this place
  double coordinate()
  {
    const double value = number();
    if (!std::isfinite(value)) {
      fail("a coordinate is not finite", "correct or remove this line");
    }
    return value;
  }

  /// Reads an integer.
  /// \throw File_error if there is none at this place
  std::int64_t integer(const char* meaning)
  {
    skip_plus();
    std::int64_t value = 0;
    const std::from_chars_result result = std::from_chars(m_at, m_end, value);
    if (result.ec != std::errc()) {
      fail(std::string(meaning) + " is expected, an integer", "correct this line or write the file again");
    }
    m_at = result.ptr;
    return value;
  }

  /// Reads a number that must not be negative.
  /// \throw File_error if there is none at this place
  std::size_t count(const char* meaning)
  {
    const std::int64_t value = integer(meaning);
    if (value < 0) {
      fail(std::string(meaning) + " is negative", "correct this line or write the file again");
    }
    return static_cast<std::size_t>(value);
  }

  /// \throw File_error naming the file, the line, what is wrong and the remedy
  [[noreturn]] void fail(const std::string& fault, const std::string& remedy) const
  {
    std::size_t line = 1;
    for (const char* c = m_begin; c != m_at; ++c) {
      line += *c == '\n' ? 1 : 0;
    }
    throw File_error(m_filename + ", line " + std::to_string(line) + ": " + fault + "; " + remedy);
  }

  /// \throw File_error telling that the file ends too early
  [[noreturn]] void fail_at_end(const std::string& what) const
  {
    throw File_error(m_filename + ": the file ends before " + what + "; it seems truncated, fetch or write it again");
  }

private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_plus()
  {
    if (m_at != m_end && *m_at == '+') {
      ++m_at;
    }
  }

  /// Whether a number out of range is one of very small magnitude.
  static bool is_underflow(const char* first, const char* last)
  {
    const std::string_view number(first, static_cast<std::size_t>(last - first));
    const std::size_t exponent = number.find_first_of("eE");
    return exponent != std::string_view::npos && exponent + 1 < number.size() && number[exponent + 1] == '-';
  }

  const char* m_begin;
  const char* m_at;
  const char* m_end;
  std::string m_filename;
};

/// The number of points as an index is checked once here, so that no reader can overflow `Index`.
inline void check_number_of_points(std::size_t number_of_points, const std::string& filename)
{
  if (number_of_points >= no_index) {
    throw File_error(filename + ": there are more than 4 billion points; split or simplify the mesh");
  }
}

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

  /// Passes over `size` bytes and returns where they begin.
  /// \throw File_error if the data end before
  const char* skip(std::size_t size)
  {
    skip_check(size);
    const char* const first = m_bytes.data();
    m_bytes.remove_prefix(size);
    return first;
  }

  /// Where the data that are left begin.
  const char* data() const { return m_bytes.data(); }
  /// Whether the bytes of a number are in the order of this machine.
  bool is_native() const { return m_order == boost::endian::order::native; }

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

/// Reads a number of any type; integers beyond 2^53 are rounded.
/// \pre the type is valid
/// \throw File_error if the data end before
inline double next_number(Byte_scanner& scanner, const Number_type& type)
{
  if (type.kind == 'f') {
    return type.size == sizeof(float) ? double(scanner.number<float>()) : scanner.number<double>();
  }
  const bool has_sign = type.kind == 'i';
  switch (type.size) {
  case 1:
    return has_sign ? double(scanner.number<std::int8_t>()) : double(scanner.number<std::uint8_t>());
  case 2:
    return has_sign ? double(scanner.number<std::int16_t>()) : double(scanner.number<std::uint16_t>());
  case 4:
    return has_sign ? double(scanner.number<std::int32_t>()) : double(scanner.number<std::uint32_t>());
  default:
    return has_sign ? double(scanner.number<std::int64_t>()) : double(scanner.number<std::uint64_t>());
  }
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SCANNER_H
