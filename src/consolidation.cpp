// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The consolidation of point clouds, compiled once, apart from their triangulation, which takes long to compile.

#include <CSCD/Points/consolidate_points_impl.h>
