// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances along surfaces and cut loci, compiled once.

#include <CSCD/Published/Cut_locus_extraction_impl.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Prepared_distances_impl.h>
