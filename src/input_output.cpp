// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readers and writers, compiled once.

#include <CSCD/IO/read_points_impl.h>
#include <CSCD/IO/read_skeleton_impl.h>
#include <CSCD/IO/read_triangle_mesh_impl.h>
#include <CSCD/IO/read_volume_impl.h>
#include <CSCD/IO/write_html_page_impl.h>
#include <CSCD/IO/write_rig_impl.h>
#include <CSCD/IO/write_skeleton_impl.h>
