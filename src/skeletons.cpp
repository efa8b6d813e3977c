// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of branches and the simplification of skeletons, compiled once.

#include <CSCD/Skeleton/Branch_hierarchy_impl.h>
#include <CSCD/Skeleton/Skeleton_branches_impl.h>
#include <CSCD/Skeleton/simplify_skeleton_impl.h>
