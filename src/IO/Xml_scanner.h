// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Goes through the elements of XML.

#ifndef CSCD_SRC_IO_XML_SCANNER_H
#define CSCD_SRC_IO_XML_SCANNER_H

#include <CSCD/exceptions.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

/// Goes through XML tag by tag and holds nothing but the current one, so that large files take no more memory than
/// their text, and binary data may follow. Comments and declarations are passed over; character references are left as
/// they are.
class Xml_scanner
{
public:
  /// \param text must outlive the scanner
  /// \param filename for messages
  Xml_scanner(std::string_view text, std::string filename) : m_text(text), m_filename(std::move(filename)) {}

  /// Goes on to the next tag. \return false if there is none
  /// \throw File_error if it does not end
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
        fail("an XML tag does not end");
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

  /// The name of the element, without its name space.
  std::string_view name() const
  {
    const std::string_view tag = m_tag.substr(is_closing() ? 1 : 0);
    const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/"));
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
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
  /// All that follows.
  std::string_view rest() const { return m_text.substr(m_end); }

  /// \throw File_error naming the file and `fault`
  [[noreturn]] void fail(const std::string& fault) const
  {
    throw File_error(m_filename + ": " + fault + "; fetch or write the file again");
  }

private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  /// The `>` that ends the tag, which is not one within quotes.
  std::size_t end_of_tag(std::size_t begin) const
  {
    char quote = 0;
    for (std::size_t i = begin + 1; i < m_text.size(); ++i) {
      const char c = m_text[i];
      if (quote != 0) {
        quote = c == quote ? char(0) : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>' && i > begin + 1) {
        return i;
      }
    }
    return std::string_view::npos;
  }

  std::string_view m_text;
  std::string m_filename;
  std::string_view m_tag;
  std::size_t m_end = 0; ///< of the tag
};

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_XML_SCANNER_H
