// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve skeletons of the bodies in an image volume.

#ifndef CSCD_EXTRACT_CURVE_SKELETON_FROM_VOLUME_H
#define CSCD_EXTRACT_CURVE_SKELETON_FROM_VOLUME_H

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Voxel_surface_traits.h>
#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/tags.h>

namespace CSCD {

/// extracts the curve skeleton of the voxels that have one label.
///
/// Every connected component of the voxels gets a connected skeleton; the first Betti number of the skeleton is the
/// number of handles of the voxels. Nodes have coordinates and radii in the unit of the volume, and hold the vertices
/// of `surface` that belong to them, by their numbers. See `extract_curve_skeleton()` of a mesh for the rest. The
/// named parameters are `random_seed`, `maximum_number_of_sources`, `number_of_threads`, `detail`, `node_spacing`,
/// `policies` and `visitor`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam Skeleton a model of `CurveSkeletonGraph`: `Skeleton_graph<Point, std::size_t>`
/// \param surface made by `make_voxel_surfaces()` or `read_voxel_surfaces()`
/// \param skeleton is cleared first; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters
/// \return counts, timings and warnings
/// \throw Input_error if `detail` is not from 0 to 1
/// \throw Cancelled_error if the visitor stops the work
template <class ConcurrencyTag = CGAL::Sequential_tag, class Skeleton,
          class NamedParameters = parameters::Default_named_parameters>
Skeletonization_report extract_curve_skeleton(const Voxel_surface& surface, Skeleton& skeleton,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::random_seed_t, CGAL::internal_np::visitor_t,
                                   internal_np::maximum_number_of_sources_t, internal_np::number_of_threads_t,
                                   internal_np::detail_t, internal_np::node_spacing_t, internal_np::policies_t>();
  const auto make_traits = [&] { return Voxel_surface_traits<internal::Skeleton_point<Skeleton>>(surface); };
  return internal::skeletonize<ConcurrencyTag>(make_traits, internal::skeletonization_policies(np), skeleton, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CURVE_SKELETON_FROM_VOLUME_H
