// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers and words from text.

#ifndef CSCD_SRC_IO_TEXT_SCANNER_H
#define CSCD_SRC_IO_TEXT_SCANNER_H

#include <CSCD/exceptions.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CSCD::internal {

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

  /// The size of the rest of the text, in bytes.
  std::size_t remaining() const { return static_cast<std::size_t>(m_end - m_at); }
  /// The rest of the text.
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
  /// \throw File_error if none is at this place
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

  /// \throw File_error naming the file, the line, the fault and the remedy
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

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_TEXT_SCANNER_H
