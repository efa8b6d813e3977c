// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplification of skeletons, compiled once.

#include <CSCD/Skeleton/simplify_skeleton_impl.h>
