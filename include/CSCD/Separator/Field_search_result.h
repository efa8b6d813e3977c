// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the search for a separator from a distance field says.

#ifndef CSCD_SEPARATOR_FIELD_SEARCH_RESULT_H
#define CSCD_SEPARATOR_FIELD_SEARCH_RESULT_H

#include <CSCD/Separator/Cut_loop_outcome.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Shortening_outcome.h>

namespace CSCD::internal {

/// The result of the search for the separator of one source.
struct Field_search_result
{
  /// `found`, or why no loop was.
  Cut_loop_outcome outcome = Cut_loop_outcome::no_cut_point;
  /// Of the loop, if one was found; `collapsed` leaves no separator.
  Shortening_outcome shortening = Shortening_outcome::collapsed;
  Separator separator;

  bool has_separator() const
  {
    return outcome == Cut_loop_outcome::found && shortening != Shortening_outcome::collapsed;
  }
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_FIELD_SEARCH_RESULT_H
