// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of the program that use a skeleton or its separators, and their arguments.

#ifndef CSCD_PROGRAM_APPLICATIONS_H
#define CSCD_PROGRAM_APPLICATIONS_H

#include <CSCD/Application/find_surface_loops.h>

#include <cstddef>
#include <string>

namespace cscd {

/// What the commands that use the skeleton of a mesh have in common.
struct Application_options
{
  std::string input;  ///< a file name, or `standard_stream`
  std::string format; ///< of the input: off, obj, ply or stl; by its ending if empty
  std::string output; ///< a file name, or `standard_stream`
  std::string report; ///< file for the report, or empty
  bool is_quiet = false;
};

/// Refuses files that are the input, and two results on standard output.
/// \throw Usage_error
void check_files(const Application_options& options);

/// \name What a segmentation goes by
/// @{
inline constexpr const char* by_skeleton = "skeleton";
inline constexpr const char* by_diameter = "diameter";
/// @}

/// How to segment a mesh.
struct Segment_options : Application_options
{
  std::size_t number_of_parts = 0; ///< 0 lets the shape decide
  std::string by = by_skeleton;
};

/// Reads a mesh, segments it and writes the number of the part of each face, one a line.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void segment(const Segment_options& options);

/// Reads a mesh and writes the shape diameter at each of its vertices, one a line.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void write_diameters(const Application_options& options);

/// Which loops to find; all kinds if none is chosen.
struct Loops_options : Application_options
{
  bool handles = false;
  bool tunnels = false;
  bool constrictions = false;
  double min_depth = CSCD::default_min_constriction_depth;
};

/// Reads a mesh and writes its handle loops, tunnel loops and constrictions, in the format of the output's ending.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void write_loops(const Loops_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_APPLICATIONS_H
