// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of skeletons by the endings of file names.

#ifndef CSCD_IO_INTERNAL_SKELETON_ENDINGS_H
#define CSCD_IO_INTERNAL_SKELETON_ENDINGS_H

#include <CSCD/exceptions.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <locale>
#include <string>
#include <vector>

namespace CSCD::internal {

/// The endings of the formats that skeletons are written in; those that are read, too, come first.
inline constexpr std::array<const char*, 8> skeleton_endings{".graph",         ".json", ".obj", ".ply",
                                                             ".polylines.txt", ".swc",  ".vtp", ".graphml"};

/// How many of `skeleton_endings` are read.
inline constexpr std::size_t number_of_read_skeleton_endings = 7;

/// The first `number` endings, separated by blanks.
inline std::string list_of_skeleton_endings(std::size_t number)
{
  return boost::algorithm::join(
      std::vector<std::string>(skeleton_endings.begin(), skeleton_endings.begin() + std::ptrdiff_t(number)), " ");
}

/// The position in `skeleton_endings` of the ending of `filename`, in lower or upper case.
/// \throw File_error if it is not one of them
inline std::size_t skeleton_ending(const std::string& filename)
{
  const std::string lower = boost::algorithm::to_lower_copy(filename, std::locale::classic());
  const auto* ending = std::find_if(skeleton_endings.begin(), skeleton_endings.end(), [&](const char* candidate) {
    return boost::algorithm::ends_with(lower, candidate);
  });
  if (ending == skeleton_endings.end()) {
    throw File_error(filename + ": the ending names no known skeleton format; use one of " +
                     list_of_skeleton_endings(skeleton_endings.size()));
  }
  return static_cast<std::size_t>(ending - skeleton_endings.begin());
}

/// The position in `skeleton_endings` of the ending of the name of a file to be read.
/// \throw File_error if the format is unknown, or is written only
inline std::size_t readable_skeleton_ending(const std::string& filename)
{
  const std::size_t ending = skeleton_ending(filename);
  if (ending >= number_of_read_skeleton_endings) {
    throw File_error(filename + ": skeletons are written as " + skeleton_endings[ending] +
                     ", but not read from it; use one of " + list_of_skeleton_endings(number_of_read_skeleton_endings));
  }
  return ending;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SKELETON_ENDINGS_H
