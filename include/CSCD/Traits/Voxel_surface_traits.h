// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The adapter of surfaces around the voxels of an image.

#ifndef CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H
#define CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H

#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/Surface_adapter.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <cstddef>
#include <utility>

namespace CSCD {

/// The adapter of the surface of voxels to a `Triangulated_solid`; a model of `SkeletonizationTraits`. Vertices of the
/// input are identified by their numbers among the points of the voxel surface.
/// \tparam OutputPoint the points of skeletons, in the coordinates of the volume; constructible from three coordinates
template <class OutputPoint>
class Voxel_surface_traits : public Surface_adapter<Triangulated_solid, OutputPoint, std::size_t>
{
public:
  /// Compiles `surface`, which is not copied if it is moved here; near linear.
  /// \pre the surface is as `Voxel_surface_builder` makes it
  explicit Voxel_surface_traits(Voxel_surface surface)
  {
    surface.turn_cavities();
    this->m_surface.emplace(std::move(surface.triangles.points), std::move(surface.triangles.faces));
    this->describe_solid([](Index number) { return std::size_t(number); });
  }
};

} // namespace CSCD

#endif // CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H
