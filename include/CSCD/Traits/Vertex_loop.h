// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed curves along edges.

#ifndef CSCD_TRAITS_VERTEX_LOOP_H
#define CSCD_TRAITS_VERTEX_LOOP_H

#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// The vertices of a simple closed curve along edges, in order; the last one and the first are neighbors.
using Vertex_loop = std::vector<Index>;

} // namespace CSCD::internal

#endif // CSCD_TRAITS_VERTEX_LOOP_H
