// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How numbers are written to files.

#ifndef CSCD_IO_INTERNAL_EXACT_FORMAT_H
#define CSCD_IO_INTERNAL_EXACT_FORMAT_H

#include <CSCD/exceptions.h>

#include <boost/io/ios_state.hpp>

#include <limits>
#include <locale>
#include <ostream>

namespace CSCD::internal {

/// While it lives, its stream writes numbers in the C locale, and doubles with so many digits that reading them gives
/// the same value again; afterwards the stream is formatted as before.
class Exact_format
{
public:
  explicit Exact_format(std::ostream& out) : m_flags(out), m_precision(out), m_locale(out), m_out(out)
  {
    out.imbue(std::locale::classic());
    out.precision(std::numeric_limits<double>::max_digits10);
    out.setf(std::ios::dec, std::ios::basefield);
    out.unsetf(std::ios::floatfield | std::ios::showpos | std::ios::showbase);
  }

  /// Flushes the stream.
  /// \throw File_error if not everything could be written
  void finish()
  {
    if (!m_out.flush()) {
      throw File_error("the skeleton could not be written to the stream: check that it is open and that the disk "
                       "is not full");
    }
  }

private:
  boost::io::ios_flags_saver m_flags;
  boost::io::ios_precision_saver m_precision;
  boost::io::ios_locale_saver m_locale;
  std::ostream& m_out;
};

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_EXACT_FORMAT_H
