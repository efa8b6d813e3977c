// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the input.

#ifndef CSCD_PROGRAM_READ_INPUT_H
#define CSCD_PROGRAM_READ_INPUT_H

#include "Input.h"
#include "Skeletonize_options.h"

namespace cscd {

/// Reads a mesh or points from the file that `options` name, or from standard input.
/// \throw Usage_error if standard input has no format; `CSCD::File_error` or `CSCD::Input_error` if there is neither
Input read_input(const Skeletonize_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_READ_INPUT_H
