// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd classify`, and its arguments.

#ifndef CSCD_PROGRAM_CLASSIFY_H
#define CSCD_PROGRAM_CLASSIFY_H

#include <string>

namespace cscd {

/// \name What shapes are compared by
/// @{
inline constexpr const char* diameter_descriptor = "diameter";
inline constexpr const char* skeleton_descriptor = "skeleton";
/// @}

/// Which shapes to classify.
struct Classify_options
{
  std::string manifest; ///< file name of a table of mesh files and classes
  std::string output;   ///< a file name, or `standard_stream`
  std::string descriptor = skeleton_descriptor;
  bool is_quiet = false;
};

/// Reads meshes and writes the class of each, as found by the nearest of the others, as JSON.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void classify(const Classify_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_CLASSIFY_H
