// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point where a curve crosses an edge of a surface.

#ifndef CSCD_TRAITS_EDGE_CROSSING_H
#define CSCD_TRAITS_EDGE_CROSSING_H

#include <CSCD/internal/Vector_3.h>

namespace CSCD::internal {

/// A point where a curve crosses an edge of the surface.
/// The curve passes with the origin of the halfedge on its right and the target on its left, and goes on into the face
/// of the halfedge's twin.
struct Edge_crossing
{
  Index halfedge;
  /// In (0, 1): from the origin of `halfedge` to its target.
  double position;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_EDGE_CROSSING_H
