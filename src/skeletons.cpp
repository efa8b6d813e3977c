// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of branches and the simplification of skeletons, compiled once.

#include <CSCD/Measure/Skeleton_branches_impl.h>
#include <CSCD/Measure/simplify_skeleton_impl.h>
#include <CSCD/Skeleton/Branch_hierarchy_impl.h>
