// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Branches as JSON, for those who use nlohmann-json themselves.

#ifndef CSCD_IO_INTERNAL_JSON_BRANCHES_H
#define CSCD_IO_INTERNAL_JSON_BRANCHES_H

#include <CSCD/Measure/Skeleton_branches.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace CSCD::internal {

/// The branches as objects; numbers that are infinite or not known are written as null. Members that belong to a
/// surface, a root or a tree are left out where there is none.
nlohmann::ordered_json json_branches(const std::vector<Skeleton_branch>& branches);

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_JSON_BRANCHES_H
