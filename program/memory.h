// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bound on the memory of this process.

#ifndef CSCD_PROGRAM_MEMORY_H
#define CSCD_PROGRAM_MEMORY_H

#include <cstddef>
#include <string>

namespace cscd {

/// The bytes that the control groups of Linux, of version 2, from `group` up to `root`, which are folders, leave
/// to their processes; the largest number if none has a bound. The cache of files counts as free.
/// \param swap the bytes of swap that the machine has left
/// \pre `group` is `root`, or begins with `root` and a slash
std::size_t memory_left_in_groups(std::string group, const std::string& root, std::size_t swap);

/// Limits the memory that this process may write to, to the amount that the machine or the container can give, unless
/// its limit is lower: more ends it with a message. Without a limit, Linux promises memory that it does not have, and
/// kills this program or another when that is used. Other systems are left alone.
void limit_memory_to_available();

} // namespace cscd

#endif // CSCD_PROGRAM_MEMORY_H
