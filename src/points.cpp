// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point clouds, their bodies and their surfaces, compiled once.

#include <CSCD/Graph/Spatial_graph_impl.h>
#include <CSCD/Points/Point_cloud_impl.h>
#include <CSCD/Points/Point_solid_impl.h>
#include <CSCD/Points/reconstruct_surface_impl.h>
