// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of branches, compiled once.

#include <CSCD/Skeleton/Skeleton_branches_impl.h>
