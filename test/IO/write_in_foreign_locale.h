// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing to text where the global locale has decimal commas and grouped digits.

#ifndef CSCD_TEST_IO_WRITE_IN_FOREIGN_LOCALE_H
#define CSCD_TEST_IO_WRITE_IN_FOREIGN_LOCALE_H

#include <CSCD/exceptions.h>

#include <gtest/gtest.h>

#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

namespace test_support {

/// Numbers as in `1.234,5`.
class Foreign_punctuation : public std::numpunct<char>
{
protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Makes a foreign locale the global one while it lives.
class Foreign_global_locale
{
public:
  Foreign_global_locale() : m_old(std::locale::global(std::locale(std::locale::classic(), new Foreign_punctuation))) {}
  Foreign_global_locale(const Foreign_global_locale&) = delete;
  Foreign_global_locale& operator=(const Foreign_global_locale&) = delete;
  ~Foreign_global_locale() { std::locale::global(m_old); }

private:
  std::locale m_old;
};

/// The output of `write(stream, skeleton)`; checks that it keeps the stream's format and fails on a bad stream.
template <class Write, class SampleSkeleton>
std::string write_in_foreign_locale(Write write, const SampleSkeleton& skeleton)
{
  const Foreign_global_locale locale;
  std::ostringstream out;
  out << std::hexfloat << std::setprecision(2) << std::showpos;
  const auto flags = out.flags();
  write(out, skeleton);
  EXPECT_EQ(flags, out.flags());
  EXPECT_EQ(2, out.precision());
  EXPECT_EQ(std::locale(), out.getloc());

  std::ostringstream bad;
  bad.setstate(std::ios::badbit);
  EXPECT_THROW(write(bad, skeleton), CSCD::File_error);
  return out.str();
}

} // namespace test_support

#endif // CSCD_TEST_IO_WRITE_IN_FOREIGN_LOCALE_H
