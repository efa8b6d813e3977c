// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers from bytes and from text, the only places where either become numbers, and the tags of XML.

#ifndef CSCD_SRC_IO_SCANNERS_H
#define CSCD_SRC_IO_SCANNERS_H

#include "IO/formats.h"
#include <CSCD/Vector3.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <locale>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CSCD::internal {

using Byte_order = boost::endian::order;

/// `text` in lower case, whatever the locale is.
inline std::string lower_case(std::string_view text)
{
  return boost::algorithm::to_lower_copy(std::string(text), std::locale::classic());
}

/// Removes `prefix` from the beginning of `text`. \return whether it was there
inline bool drop_prefix(std::string_view& text, std::string_view prefix)
{
  const bool is_there = boost::algorithm::starts_with(text, prefix);
  text.remove_prefix(is_there ? prefix.size() : 0);
  return is_there;
}

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

/// The type that a format calls `name`, such as `uchar`, `unsigned char`, `UInt8`, `uint8_t` or `MET_UCHAR`; a type
/// that is not valid for other names. \param size_of_long in bytes, as formats differ; 0 where `long` is not a type
inline Number_type number_type(std::string_view name, std::size_t size_of_long = 0)
{
  std::string letters = boost::algorithm::erase_all_copy(lower_case(name), " ");
  boost::algorithm::erase_all(letters, "_");
  std::string_view plain = letters;
  drop_prefix(plain, "met");     // of MetaImage
  drop_prefix(plain, "vtktype"); // of VTK
  const bool has_no_sign = drop_prefix(plain, "unsigned") || (!drop_prefix(plain, "signed") && drop_prefix(plain, "u"));
  const std::map<std::string_view, Number_type> types{
      {"char", {'i', 1}},        {"int8", {'i', 1}},    {"int8t", {'i', 1}},     {"short", {'i', 2}},
      {"shortint", {'i', 2}},    {"int16", {'i', 2}},   {"int16t", {'i', 2}},    {"int", {'i', 4}},
      {"int32", {'i', 4}},       {"int32t", {'i', 4}},  {"vtkidtype", {'i', 4}}, {"longlong", {'i', 8}},
      {"longlongint", {'i', 8}}, {"int64", {'i', 8}},   {"int64t", {'i', 8}},    {"long", {'i', size_of_long}},
      {"float", {'f', 4}},       {"float32", {'f', 4}}, {"double", {'f', 8}},    {"float64", {'f', 8}}};
  const auto found = types.find(plain);
  Number_type result = found != types.end() ? found->second : Number_type();
  result.kind = has_no_sign && result.kind == 'i' ? 'u' : result.kind;
  return result;
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
  using boost::endian::endian_load;
  const auto* const raw = reinterpret_cast<const unsigned char*>(bytes);
  return order == Byte_order::little ? endian_load<Number, sizeof(Number), Byte_order::little>(raw)
                                     : endian_load<Number, sizeof(Number), Byte_order::big>(raw);
}

/// Numbers of one type in memory, each `stride` bytes behind the one before.
struct Number_view
{
  const char* bytes = nullptr; ///< of the first one
  Number_type type;
  Byte_order order = Byte_order::little;
  std::size_t stride = 0;
  std::size_t count = 0;

  /// Calls `use(i, number)` for all of them in their order, with numbers of the type that is stored.
  template <class Use>
  void for_each(const Use& use) const
  {
    with_number_type(type, [this, &use](auto zero) {
      for (std::size_t i = 0; i < count; ++i) {
        use(i, stored_number<decltype(zero)>(bytes + i * stride, order));
      }
    });
  }
};

/// Goes through binary data number by number. \throw Content_error, in all functions that read, if the data end before
class Byte_scanner
{
public:
  /// \param bytes must outlive the scanner
  Byte_scanner(std::string_view bytes, Byte_order order) : m_bytes(bytes), m_order(order) {}

  /// The size of the rest of the data, in bytes.
  std::size_t remaining() const { return m_bytes.size(); }

  /// Reads a number.
  template <class Number>
  Number number()
  {
    return stored_number<Number>(skip(sizeof(Number)), m_order);
  }

  /// Reads three numbers.
  template <class Number>
  Vector3 vector()
  {
    Vector3 result = Vector3::Zero();
    for (double& coordinate : result) {
      coordinate = double(number<Number>());
    }
    return result;
  }

  /// Reads a number of any type. \pre the type is valid
  double number(const Number_type& type)
  {
    return with_number_type(type, [this](auto zero) { return double(number<decltype(zero)>()); });
  }

  /// Passes over `size` bytes and returns where they begin.
  const char* skip(std::size_t size)
  {
    if (size > m_bytes.size()) {
      fail_at_end("all that its header promises");
    }
    const char* const first = m_bytes.data();
    m_bytes.remove_prefix(size);
    return first;
  }

private:
  std::string_view m_bytes;
  Byte_order m_order;
};

/// Writes a number in binary.
template <class Number>
void write_little_endian(std::ostream& out, Number number)
{
  boost::endian::native_to_little_inplace(number);
  out.write(reinterpret_cast<const char*>(&number), sizeof(number));
}

/// As `std::from_chars()`, which not every standard library has for floating-point numbers; where it is
/// missing, an underflow gives 0, and the locale of C has to be "C".
inline std::from_chars_result number_from_chars(const char* first, const char* last, double& value)
{
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, value);
#else
  constexpr std::string_view behind_numbers = " \t\n\v\f\rxX"; // `x`: hexadecimal ones are not read
  const std::string text(first, std::find_first_of(first, last, behind_numbers.begin(), behind_numbers.end()));
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const auto size = end - text.c_str();
  if (size == 0 || text.front() == '+') {
    return {first, std::errc::invalid_argument};
  }
  if (std::isinf(number) && text.find_first_of("0123456789") < std::size_t(size)) {
    return {first + size, std::errc::result_out_of_range};
  }
  value = number;
  return {first + size, std::errc()};
#endif
}

inline bool is_blank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Goes through a text token by token, in the C locale whatever the global one is. Tokens end at blanks. Functions that
/// read throw a `Content_error`, which names the line and the remedy, if what they read is not at this place.
/// `CGAL::IO::read_OFF()` and its like are not used: they take some fifteen times as long, allocate what a header
/// promises before it is checked, and are undefined on some malformed files.
class Text_scanner
{
public:
  /// A fault, and the remedy of most faults.
  static constexpr const char* number_expected = "a number with a decimal point is expected";
  static constexpr const char* correct_line = "correct this line or write the file again";

  /// \param text must outlive the scanner
  explicit Text_scanner(std::string_view text)
      : m_begin(text.data()), m_at(text.data()), m_end(text.data() + text.size())
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

  /// Goes on to the next token; `what` is missing if there is none.
  void expect(const char* what, char comment = 0)
  {
    if (!skip_blanks(comment)) {
      fail_at_end(what);
    }
  }

  /// Goes on to the next token of this line; `fault` and `remedy` are named if there is none.
  void expect_in_line(const char* fault, const char* remedy = correct_line)
  {
    if (!skip_blanks_in_line()) {
      fail(fault, remedy);
    }
  }

  /// Goes on to the beginning of the next line.
  void skip_line()
  {
    m_at = std::find(m_at, m_end, '\n');
    m_at += m_at != m_end ? 1 : 0;
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
    const char* const first = m_at;
    m_at = std::find_if(m_at, m_end, is_blank);
    return {first, static_cast<std::size_t>(m_at - first)};
  }

  /// Reads a number, which may be infinite or not a number.
  double number()
  {
    skip_character('+');
    double value = 0;
    const char* const end = read_number(m_at, m_end, value);
    if (end == nullptr || (end != m_end && !is_blank(*end))) {
      fail(number_expected);
    }
    m_at = end;
    return value;
  }

  /// Reads a number without a plus; underflow gives 0. \return its end; null if it is missing or too large
  static const char* read_number(const char* first, const char* last, double& value)
  {
    const std::from_chars_result result = number_from_chars(first, last, value);
    if (result.ec == std::errc::result_out_of_range && is_underflow(first, result.ptr)) {
      value = 0;
      return result.ptr;
    }
    return result.ec == std::errc() ? result.ptr : nullptr;
  }

  /// Reads a number which is finite.
  double coordinate()
  {
    const double value = number();
    if (!std::isfinite(value)) {
      fail("a coordinate is not finite", "correct or remove this line");
    }
    return value;
  }

  /// Reads three finite numbers of this line. \param too_few the message if there are fewer
  Vector3 point_in_line(const char* too_few)
  {
    Vector3 point = Vector3::Zero();
    for (double& number : point) {
      expect_in_line(too_few);
      number = coordinate();
    }
    return point;
  }

  /// Reads an integer.
  std::int64_t integer(const char* meaning)
  {
    skip_character('+');
    std::int64_t value = 0;
    const std::from_chars_result result = std::from_chars(m_at, m_end, value);
    if (result.ec != std::errc()) {
      fail(std::string(meaning) + " is expected, an integer");
    }
    m_at = result.ptr;
    return value;
  }

  /// Reads an integer that must not be negative.
  std::size_t count(const char* meaning)
  {
    const std::int64_t value = integer(meaning);
    if (value < 0) {
      fail(std::string(meaning) + " is negative");
    }
    return static_cast<std::size_t>(value);
  }

  /// \throw Content_error naming the line, the fault and the remedy
  [[noreturn]] void fail(const std::string& fault, const std::string& remedy = correct_line) const
  {
    const auto line = 1 + std::count(m_begin, m_at, '\n');
    internal::fail(fault, remedy, ", line " + std::to_string(line));
  }

private:
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
};

/// Goes through XML tag by tag and holds only the current one, so that large files take no more memory than
/// their text, and binary data may follow. Comments and declarations are passed over; character references are left as
/// they are.
class Xml_scanner
{
public:
  /// \param text must outlive the scanner
  explicit Xml_scanner(std::string_view text) : m_text(text) {}

  /// Goes on to the next tag. \return false if there is none
  /// \throw Content_error if it does not end
  bool next()
  {
    constexpr std::string_view comment = "<!--";
    while (true) {
      const std::size_t begin = m_text.find('<', m_end);
      if (begin == std::string_view::npos) {
        return false;
      }
      const bool is_comment = m_text.substr(begin, comment.size()) == comment;
      const std::size_t end = is_comment ? m_text.find("-->", begin) : end_of_tag(begin);
      if (end == std::string_view::npos) {
        fail("an XML tag does not end", "fetch or write the file again");
      }
      m_end = end + (is_comment ? 3 : 1);
      const char first = m_text[begin + 1];
      if (!is_comment && first != '?' && first != '!') {
        m_tag = m_text.substr(begin + 1, end - begin - 1);
        return true;
      }
    }
  }

  /// Whether the tag closes an element; one without content is not closed by a tag of its own.
  bool is_closing() const { return m_tag.front() == '/'; }
  bool is_empty() const { return m_tag.back() == '/'; }

  /// The name of the element.
  std::string_view name() const
  {
    const std::string_view tag = m_tag.substr(is_closing() ? 1 : 0);
    return tag.substr(0, tag.find_first_of(" \t\r\n/"));
  }

  /// The value of an attribute; empty if there is none.
  std::string_view attribute(std::string_view name) const
  {
    for (std::size_t at = m_tag.find(name); at != std::string_view::npos; at = m_tag.find(name, at + 1)) {
      const std::size_t equals = m_tag.find_first_not_of(" \t\r\n", at + name.size());
      const bool is_name =
          at > 0 && is_blank(m_tag[at - 1]) && equals != std::string_view::npos && m_tag[equals] == '=';
      const std::size_t quote = is_name ? m_tag.find_first_of("\"'", equals) : std::string_view::npos;
      if (quote != std::string_view::npos) {
        return m_tag.substr(quote + 1, m_tag.find(m_tag[quote], quote + 1) - quote - 1);
      }
    }
    return {};
  }

  /// The text up to the next tag.
  std::string_view content() const { return m_text.substr(m_end, m_text.find('<', m_end) - m_end); }

private:
  /// The `>` that ends the tag, which is not one within quotes.
  std::size_t end_of_tag(std::size_t begin) const
  {
    std::size_t end = m_text.find_first_of("\"'>", begin + 1);
    while (end != std::string_view::npos && (m_text[end] != '>' || end == begin + 1)) {
      end = m_text[end] == '>' ? end : m_text.find(m_text[end], end + 1); // over the quoted text
      end = end == std::string_view::npos ? end : m_text.find_first_of("\"'>", end + 1);
    }
    return end;
  }

  std::string_view m_text;
  std::string_view m_tag;
  std::size_t m_end = 0; ///< of the tag
};

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_SCANNERS_H
