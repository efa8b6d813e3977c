// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arguments of `cscd skeletonize`.

#ifndef CSCD_PROGRAM_SKELETONIZE_OPTIONS_H
#define CSCD_PROGRAM_SKELETONIZE_OPTIONS_H

#include <cstddef>
#include <string>
#include <vector>

namespace cscd {

/// The name that means standard input or standard output.
inline constexpr const char* standard_stream = "-";

/// \name Values of options
/// @{
inline constexpr const char* local_method = "local";
inline constexpr const char* published_method = "published";
inline constexpr const char* euclidean_target = "euclidean";
inline constexpr const char* geodesic_target = "geodesic";
inline constexpr const char* flip_shortening = "flips";
inline constexpr const char* variational_shortening = "variational";
inline constexpr const char* automatic_shape = "auto";
inline constexpr const char* surface_shape = "surface";
inline constexpr const char* tree_shape = "tree";
/// @}

/// What to skeletonize, how, and where the results go.
struct Skeletonize_options
{
  std::string input;                ///< a file name, or `standard_stream`
  std::string format;               ///< of the input: off, obj, ply, stl, xyz or pts; by its ending if empty
  std::vector<std::string> outputs; ///< file names, or `standard_stream` for GEL's graph format
  std::string method = local_method;
  std::string target;                  ///< of the published method: which cut point; `euclidean_target` if empty
  std::string shortening;              ///< of the published method: how loops are shortened; `flip_shortening` if empty
  std::string shape = automatic_shape; ///< what points sample: the surface of a body, or trees and other thin things
  std::vector<double> root;            ///< of a tree: where its trunk begins, three coordinates; or empty
  unsigned int seed = 0;
  unsigned int number_of_threads = 0;        ///< 0 for all that the machine has
  std::size_t maximum_number_of_sources = 0; ///< from which separators are sought; 0 lets the method decide
  std::string report;                        ///< file name for the report as JSON, or empty
  std::string html;                          ///< file name for the viewer page, or empty
  bool is_quiet = false;
};

} // namespace cscd

#endif // CSCD_PROGRAM_SKELETONIZE_OPTIONS_H
