// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the mesh.

#ifndef CSCD_PROGRAM_READ_INPUT_H
#define CSCD_PROGRAM_READ_INPUT_H

#include "Skeletonize_options.h"
#include "types.h"
#include <CSCD/IO/Mesh_repair_report.h>

namespace cscd {

/// Reads the mesh from the file that `options` name, or from standard input.
/// \return what was mended
/// \throw Usage_error if standard input has no format; `CSCD::File_error` or `CSCD::Input_error` if there is no mesh
CSCD::Mesh_repair_report read_input(const Skeletonize_options& options, Mesh& mesh);

} // namespace cscd

#endif // CSCD_PROGRAM_READ_INPUT_H
