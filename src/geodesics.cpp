// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances along surfaces and cut loci, compiled once.

#include <CSCD/Cut_locus/Cut_locus_extraction_impl.h>
#include <CSCD/Geodesic/Heat_method_impl.h>
#include <CSCD/Geodesic/Prepared_distances_impl.h>
