// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to a closed surface.

#ifndef CSCD_POINTS_RECONSTRUCT_SURFACE_H
#define CSCD_POINTS_RECONSTRUCT_SURFACE_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <optional>
#include <vector>

namespace CSCD::internal {

/// What belongs to a solid that is made of points.
struct Reconstruction
{
  Normalization normalization;        ///< from the coordinates of the input to those of the solid
  std::vector<Index> vertex_of_point; ///< for every point of the input its vertex, or that of the nearest with one
  Skeletonization_report report;      ///< describes the points and the surface
  bool is_surface_doubtful = false;   ///< whether the points hardly sample the surface of a body
};

/// Thins `cloud`, makes a closed surface of it, and of that `solid`. O(n log n) for points on a surface.
/// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
/// \throw Surface_error if there is none; another Input_error if the points lie in slices that are too far apart
Reconstruction reconstruct_surface(Point_cloud&& cloud, unsigned number_of_threads,
                                   std::optional<Triangulated_solid>& solid);

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Points/reconstruct_surface_impl.h>
#endif

#endif // CSCD_POINTS_RECONSTRUCT_SURFACE_H
