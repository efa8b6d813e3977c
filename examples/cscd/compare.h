// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd compare`.

#ifndef CSCD_PROGRAM_COMPARE_H
#define CSCD_PROGRAM_COMPARE_H

#include "Compare_options.h"

namespace cscd {

/// Reads two skeletons and writes how alike they are.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void compare(const Compare_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPARE_H
