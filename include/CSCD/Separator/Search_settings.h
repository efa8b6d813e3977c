// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user may set about the search for separators.

#ifndef CSCD_SEPARATOR_SEARCH_SETTINGS_H
#define CSCD_SEPARATOR_SEARCH_SETTINGS_H

#include <cstddef>
#include <functional>
#include <limits>

namespace CSCD {

/// What a user may set about the search for separators.
struct Search_settings
{
  /// Seed of the order in which sources are tried.
  unsigned random_seed = 0;
  /// Number of threads; 0 means as many as TBB allows.
  unsigned number_of_threads = 1;
  /// Bounds the number of sources.
  std::size_t maximum_number_of_sources = std::numeric_limits<std::size_t>::max();
};

/// Called with the part of a stage that is done, in [0, 1]; what it throws ends the stage.
using Progress = std::function<void(double fraction)>;

} // namespace CSCD

#endif // CSCD_SEPARATOR_SEARCH_SETTINGS_H
