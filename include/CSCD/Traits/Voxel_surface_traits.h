// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The adapter of surfaces around the voxels of an image.

#ifndef CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H
#define CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CSCD {

/// The adapter of the surface of voxels to a `Triangulated_solid`; a model of `SkeletonizationTraits`.
/// \tparam OutputPoint constructible from three coordinates
template <class OutputPoint>
class Voxel_surface_traits
{
public:
  /// \name Types
  /// @{

  /// The points of skeletons, in the coordinates of the volume.
  using Point = OutputPoint;
  /// The identifier of a vertex of the input: its number among the points of the voxel surface.
  using Input_descriptor = std::size_t;
  /// The surface that the pipeline runs on.
  using Surface = Triangulated_solid;
  /// @}

  /// Compiles `surface`, which is not copied if it is moved here; near linear.
  /// \pre the surface is as `Voxel_surface_builder` makes it
  explicit Voxel_surface_traits(Voxel_surface surface)
  {
    surface.turn_cavities();
    m_solid.emplace(std::move(surface.triangles), std::move(surface.pairing));
  }

  /// The surface of the voxels.
  const Triangulated_solid& surface() const { return *m_solid; }

  /// \name Back to the input
  /// @{

  /// The number of the vertex of the input that `vertex` is, or none for an inserted vertex.
  CGAL::Iterator_range<const Index*> descriptors(Index vertex) const { return m_solid->input_vertices(vertex); }
  /// A point of the surface in the coordinates of the volume.
  Point to_input_point(const Vector3& point) const
  {
    return CSCD::to_input_point<Point>(surface().normalization(), point);
  }
  /// A length on the surface in the unit of the volume.
  double to_input_length(double length) const { return length * surface().normalization().unit; }
  /// Describes the input in `report`.
  void describe_input(Skeletonization_report& report) const { report = m_solid->report(); }
  /// @}

private:
  std::optional<Triangulated_solid> m_solid;
};

} // namespace CSCD

#endif // CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H
