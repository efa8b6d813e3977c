// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd evaluate`.

#ifndef CSCD_PROGRAM_EVALUATE_H
#define CSCD_PROGRAM_EVALUATE_H

#include "Evaluate_options.h"

namespace cscd {

/// Reads a mesh and a skeleton, measures the skeleton and writes the measures.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void evaluate(const Evaluate_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_EVALUATE_H
