// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd loops`, and its arguments.

#ifndef CSCD_PROGRAM_LOOPS_H
#define CSCD_PROGRAM_LOOPS_H

#include "applications.h"
#include <CSCD/Application/find_surface_loops.h>

namespace cscd {

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

#endif // CSCD_PROGRAM_LOOPS_H
