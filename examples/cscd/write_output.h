// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing the results.

#ifndef CSCD_PROGRAM_WRITE_OUTPUT_H
#define CSCD_PROGRAM_WRITE_OUTPUT_H

#include "Input.h"
#include "Skeletonization_result.h"
#include "types.h"

#include <string>

namespace cscd {

/// Whether skeletons can be written to `filename`, by its ending or since it means standard output.
/// \throw Usage_error if not
void check_output(const std::string& filename);

/// Writes the skeleton to a file in the format that its ending names, or to standard output as a graph of GEL.
/// \throw CSCD::File_error if it cannot be written
void write_output(const std::string& filename, const Skeleton& skeleton);

/// Whether the program was built with three.js, so that it can write the viewer page.
bool has_viewer_page();

/// Writes the viewer page.
/// \throw CSCD::File_error if it cannot be written
void write_viewer_page(const std::string& filename, const Input& input, const Skeletonization_result& result,
                       const std::string& title);

} // namespace cscd

#endif // CSCD_PROGRAM_WRITE_OUTPUT_H
