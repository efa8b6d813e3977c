// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts in messages.

#ifndef CSCD_INTERNAL_COUNTED_H
#define CSCD_INTERNAL_COUNTED_H

#include <cstddef>
#include <string>

namespace CSCD::internal {

/// `count` and what is counted: `one` after 1, else `many`.
inline std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// The same for nouns whose plural ends in `s`.
inline std::string counted(std::size_t count, const std::string& noun)
{
  return counted(count, noun, noun + 's');
}

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_COUNTED_H
