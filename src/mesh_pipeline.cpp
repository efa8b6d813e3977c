// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces and the local method, compiled once.

#include <CSCD/Local_policies_impl.h>
#include <CSCD/Surface/Triangulated_solid_impl.h>
#include <CSCD/skeletonize_impl.h>
