// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is done with skeletons, compiled once.

#include <CSCD/Application/estimate_shape_diameters_impl.h>
#include <CSCD/Application/find_surface_loops_impl.h>
#include <CSCD/Application/make_rig_impl.h>
#include <CSCD/Application/segment_mesh_impl.h>
