// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of the program.

#ifndef CSCD_PROGRAM_COMMANDS_H
#define CSCD_PROGRAM_COMMANDS_H

#include "options.h"

namespace cscd {

/// \name Commands
/// \throw Usage_error if the options cannot be obeyed, `CSCD::File_error`, `CSCD::Input_error`
/// @{

/// Reads a mesh, points, a volume or a graph, skeletonizes it and writes the results.
void skeletonize(const Skeletonize_options& options);

/// Reads a mesh and a skeleton, measures the skeleton and writes the measures.
void evaluate(const Evaluate_options& options);

/// Reads two skeletons and writes a comparison.
void compare(const Compare_options& options);

/// Reads a skeleton, simplifies it and writes it.
void simplify(const Simplify_options& options);

/// Reads a mesh, segments it and writes the number of the part of each face, one a line.
void segment(const Segment_options& options);

/// Reads a mesh and writes the shape diameter at each of its vertices, one a line.
void write_diameters(const Application_options& options);

/// Reads a mesh and writes its handle loops, tunnel loops and constrictions, in the format of the output's ending.
void write_loops(const Loops_options& options);
/// @}

} // namespace cscd

#endif // CSCD_PROGRAM_COMMANDS_H
