// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exception for wrong use of the program.

#ifndef CSCD_PROGRAM_USAGE_ERROR_H
#define CSCD_PROGRAM_USAGE_ERROR_H

#include <stdexcept>

namespace cscd {

/// The arguments cannot be obeyed. The message names the argument and the remedy.
struct Usage_error : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

} // namespace cscd

#endif // CSCD_PROGRAM_USAGE_ERROR_H
