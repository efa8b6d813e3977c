// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbering of halfedges that all triangulations share.

#ifndef CSCD_INTERNAL_TRIANGLE_HALFEDGES_H
#define CSCD_INTERNAL_TRIANGLE_HALFEDGES_H

#include <CSCD/internal/Vector_3.h>

namespace CSCD::internal {

/// Halfedge `h` runs along side `h % 3` of face `h / 3`, counterclockwise: so the way around a face needs no memory.
/// Triangulations are derived from this.
struct Triangle_halfedges
{
  static Index next(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
  static Index previous(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
  static Index face(Index halfedge) { return halfedge / 3; }
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_TRIANGLE_HALFEDGES_H
