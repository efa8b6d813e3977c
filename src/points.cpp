// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point clouds and what is made of them, compiled once.

#include <CSCD/Reconstruction/reconstruct_surface_impl.h>
#include <CSCD/Surface/Point_cloud_impl.h>
#include <CSCD/Surface/Point_solid_impl.h>
#include <CSCD/Surface/Spatial_graph_impl.h>
