// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The roots of a skeleton, and files whose content depends on them.

#ifndef CSCD_PROGRAM_ROOTS_H
#define CSCD_PROGRAM_ROOTS_H

#include "options.h"
#include "types.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Vector_3.h>

#include <optional>
#include <string>
#include <vector>

namespace cscd {

/// The coordinates that the value of `--root` gives; none if it names a rule.
/// \pre `check_root()` has accepted it
std::optional<Vector_3> root_point(const std::string& root);

/// The roots that the value of `--root` chooses; none if it is empty.
/// \throw CSCD::Input_error if they cannot be chosen
std::vector<Index> find_roots(const Skeleton& skeleton, const std::string& root);

/// Writes a skeleton to a file of `files` in the format of its ending, or to standard output as a graph of GEL.
void write_skeleton_output(CSCD::File_group& files, const std::string& output, const Skeleton& skeleton,
                           const std::vector<Index>& roots, const Swc_arguments& swc);

} // namespace cscd

#endif // CSCD_PROGRAM_ROOTS_H
