// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading a skeleton that is named on the command line.

#ifndef CSCD_PROGRAM_READ_SKELETON_ARGUMENT_H
#define CSCD_PROGRAM_READ_SKELETON_ARGUMENT_H

#include "types.h"

#include <string>

namespace cscd {

/// Whether a skeleton can be read from `filename`, by its ending or since it means standard input.
/// \throw Usage_error if not
void check_skeleton_argument(const std::string& filename);

/// Reads the skeleton from a file in the format that its ending names, or from standard input as a graph of GEL.
/// \throw CSCD::File_error if it cannot be read
Skeleton read_skeleton_argument(const std::string& filename);

} // namespace cscd

#endif // CSCD_PROGRAM_READ_SKELETON_ARGUMENT_H
