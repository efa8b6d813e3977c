// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd skeletonize`.

#ifndef CSCD_PROGRAM_SKELETONIZE_H
#define CSCD_PROGRAM_SKELETONIZE_H

#include "Skeletonize_options.h"

namespace cscd {

/// Reads a mesh or points, skeletonizes it and writes the results.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void skeletonize(const Skeletonize_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_SKELETONIZE_H
