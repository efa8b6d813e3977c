// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method, compiled once for both surfaces, and that for graphs.

#include <CSCD/Graph_policies_impl.h>
#include <CSCD/Published_policies.h>

namespace CSCD {

CSCD_PUBLISHED_POLICIES_INSTANCE(, Triangulated_solid)
CSCD_PUBLISHED_POLICIES_INSTANCE(, Point_solid)

} // namespace CSCD
