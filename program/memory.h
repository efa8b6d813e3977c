// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes of memory in options and messages, and the bound that the system keeps.

#ifndef CSCD_PROGRAM_MEMORY_H
#define CSCD_PROGRAM_MEMORY_H

#include <cstddef>
#include <filesystem>
#include <string>

namespace cscd {

/// The bytes that `size` means: a number of megabytes, or of what the letter K, M, G or T behind it says.
/// \throw Usage_error naming `option` if it means none
std::size_t parse_memory_size(const std::string& size, const std::string& option);

/// Limits the memory that this process may write to, unless its limit is lower: more ends it with a message. May be
/// called between fork and exec.
void limit_memory(std::size_t bytes);

/// The bytes that the control groups (version 2 of Linux) from `group` up to `root`, which are folders, leave to their
/// processes; the largest number if none has a bound. The cache of files counts as free.
std::size_t memory_left_in_groups(std::filesystem::path group, const std::filesystem::path& root);

/// Limits it to what the machine, or the container, can give. Without a limit, the system promises what it does not
/// have, and kills this program or another where that is used.
void limit_memory_to_available();

} // namespace cscd

#endif // CSCD_PROGRAM_MEMORY_H
