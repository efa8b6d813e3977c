// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed surface made of points.

#ifndef CSCD_POINTS_RECONSTRUCTED_SURFACE_H
#define CSCD_POINTS_RECONSTRUCTED_SURFACE_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// The result of a reconstruction: a closed surface through points.
struct Reconstructed_surface
{
  Indexed_triangles triangles; ///< a closed manifold, looking outwards
  Halfedge_pairing pairing;    ///< of the triangles
  /// The point that a vertex is; `no_index` for inserted vertices and for second copies of points.
  std::vector<Index> point_of_vertex;
  Reconstruction_report report;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_RECONSTRUCTED_SURFACE_H
