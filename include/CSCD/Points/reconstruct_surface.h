// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to a closed surface.

#ifndef CSCD_POINTS_RECONSTRUCT_SURFACE_H
#define CSCD_POINTS_RECONSTRUCT_SURFACE_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <vector>

namespace CSCD::internal {

/// Makes a closed surface of `cloud`. O(n log n) for points on a surface.
/// \throw Surface_error if there is none; another Input_error if the points lie in slices that are too far apart
Reconstructed_surface reconstruct_surface(const Point_cloud& cloud);

/// For every point of `cloud`, its vertex in `solid`, or that of the nearest point that has one.
/// \param solid the solid that was made of the reconstructed surface
/// \param point_of_vertex that of the reconstructed surface
std::vector<Index> vertices_of_points(const Triangulated_solid& solid, const Point_cloud& cloud,
                                      const std::vector<Index>& point_of_vertex);

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Points/reconstruct_surface_impl.h>
#endif

#endif // CSCD_POINTS_RECONSTRUCT_SURFACE_H
