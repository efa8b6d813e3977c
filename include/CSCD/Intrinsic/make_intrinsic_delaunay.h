// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The intrinsic Delaunay triangulation of a surface in one call.

#ifndef CSCD_INTRINSIC_MAKE_INTRINSIC_DELAUNAY_H
#define CSCD_INTRINSIC_MAKE_INTRINSIC_DELAUNAY_H

#include <CSCD/Intrinsic/Intrinsic_triangulation.h>
#include <CSCD/internal/Vector_3.h>

namespace CSCD::internal {

/// Makes the intrinsic Delaunay triangulation of the first `number_of_faces` faces of `surface`, which is referred to.
template <class Triangulation>
Intrinsic_triangulation<Triangulation> make_intrinsic_delaunay(const Triangulation& surface, Index number_of_faces)
{
  Intrinsic_triangulation<Triangulation> result(surface, number_of_faces);
  result.make_delaunay();
  return result;
}

/// The same of all faces.
template <class Triangulation>
Intrinsic_triangulation<Triangulation> make_intrinsic_delaunay(const Triangulation& surface)
{
  return make_intrinsic_delaunay(surface, surface.number_of_faces());
}

} // namespace CSCD::internal

#endif // CSCD_INTRINSIC_MAKE_INTRINSIC_DELAUNAY_H
