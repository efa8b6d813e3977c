// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arguments of `cscd compare`.

#ifndef CSCD_PROGRAM_COMPARE_OPTIONS_H
#define CSCD_PROGRAM_COMPARE_OPTIONS_H

#include <string>

namespace cscd {

/// Which two skeletons to compare, and how.
struct Compare_options
{
  std::string first;            ///< a file name, or `standard_stream` for GEL's graph format
  std::string second;           ///< likewise
  double match_distance = 0.02; ///< relative to the diagonal of the bounding box of both
  bool is_json = false;
};

} // namespace cscd

#endif // CSCD_PROGRAM_COMPARE_OPTIONS_H
