// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foreign text inside a page.

#ifndef CSCD_IO_INTERNAL_ESCAPE_HTML_H
#define CSCD_IO_INTERNAL_ESCAPE_HTML_H

#include <boost/algorithm/string/replace.hpp>

#include <string>

namespace CSCD::internal {

/// `text` such that a page shows it literally.
inline std::string escape_html(std::string text)
{
  boost::algorithm::replace_all(text, "&", "&amp;");
  boost::algorithm::replace_all(text, "<", "&lt;");
  boost::algorithm::replace_all(text, ">", "&gt;");
  boost::algorithm::replace_all(text, "\"", "&quot;");
  boost::algorithm::replace_all(text, "'", "&#39;");
  return text;
}

/// `source` such that it can stand in a script element: it neither ends the element nor begins a comment in it.
/// In the strings, regular expressions and comments of JavaScript, where alone these can occur, the meaning stays.
inline std::string escape_script(std::string source)
{
  boost::algorithm::ireplace_all(source, "</script", "<\\/script");
  boost::algorithm::replace_all(source, "<!--", "<\\!--");
  return source;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_ESCAPE_HTML_H
