// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bound of memory that the system keeps.

#ifndef CSCD_PROGRAM_MEMORY_H
#define CSCD_PROGRAM_MEMORY_H

namespace cscd {

/// Limits the memory that this process may write to, to the amount that the machine can give, unless its limit is
/// lower: more ends it with a message. Without a limit, Linux promises memory that it does not have, and kills this
/// program or another when that is used. Other systems are left alone.
void limit_memory_to_available();

} // namespace cscd

#endif // CSCD_PROGRAM_MEMORY_H
