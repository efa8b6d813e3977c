// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Has the same includes as consumer.cpp. Names of kernels stay free where all names of the library are visible.

#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>

using namespace CSCD;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
static_assert(sizeof(Vector_3) > 0);
