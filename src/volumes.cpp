// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces of volumes, compiled once.

#include <CSCD/Volume/Voxel_surface_impl.h>
