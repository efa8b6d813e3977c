// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method for both surfaces, its distances and cut loci, and the method for graphs, compiled once.

#include <CSCD/Graph_policies_impl.h>
#include <CSCD/Published/Cut_locus_extraction_impl.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Prepared_distances_impl.h>
#include <CSCD/Published_policies.h>

namespace CSCD {

CSCD_PUBLISHED_POLICIES_INSTANCE(, Triangulated_solid)
CSCD_PUBLISHED_POLICIES_INSTANCE(, Point_solid)

} // namespace CSCD
