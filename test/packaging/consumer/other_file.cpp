// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Has the same includes as consumer.cpp.

#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>
