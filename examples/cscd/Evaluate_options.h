// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arguments of `cscd evaluate`.

#ifndef CSCD_PROGRAM_EVALUATE_OPTIONS_H
#define CSCD_PROGRAM_EVALUATE_OPTIONS_H

#include <cstddef>
#include <string>

namespace cscd {

/// The names of the radii that a skeleton is measured with.
inline constexpr const char* estimated_radii = "estimated";
inline constexpr const char* own_radii = "own";

/// What to measure against what, and how.
struct Evaluate_options
{
  std::string input;                   ///< a file name, or `standard_stream`
  std::string format;                  ///< of the input: off, obj, ply or stl; by its ending if empty
  std::string skeleton;                ///< a file name, or `standard_stream` for GEL's graph format
  std::string radii = estimated_radii; ///< or `own_radii`
  std::size_t resolution = 200;        ///< cells of the reconstructed surfaces along the diagonal of the bounding box
  std::string convolution_surface;     ///< file name for it as a mesh, or empty
  std::string round_cones;             ///< likewise
  bool is_json = false;
  bool is_quiet = false;
};

} // namespace cscd

#endif // CSCD_PROGRAM_EVALUATE_OPTIONS_H
