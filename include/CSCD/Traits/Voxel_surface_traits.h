// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The adapter of surfaces around the voxels of an image.

#ifndef CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H
#define CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <CGAL/Iterator_range.h>

#include <chrono>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

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
  explicit Voxel_surface_traits(Voxel_surface surface) : m_numbers(surface.triangles.points.size())
  {
    const auto start = std::chrono::steady_clock::now();
    std::iota(m_numbers.begin(), m_numbers.end(), std::size_t(0));
    surface.turn_cavities();
    m_surface.emplace(std::move(surface.triangles), std::move(surface.pairing));
    m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// The surface of the voxels.
  const Triangulated_solid& surface() const { return *m_surface; }

  /// \name Back to the input
  /// @{

  /// The number of the vertex of the input that `vertex` is, or none for an inserted vertex.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index vertex) const
  {
    const Index input = m_surface->input_vertex(vertex);
    const Input_descriptor* first = m_numbers.data() + (input == no_index ? 0 : input);
    return {first, input == no_index ? first : first + 1};
  }
  /// A point of the surface in the coordinates of the volume.
  Point to_input_point(const Vector_3& point) const
  {
    return CSCD::to_input_point<Point>(m_surface->normalization(), point);
  }
  /// A length on the surface in the unit of the volume.
  double to_input_length(double length) const { return length * m_surface->normalization().unit; }
  /// Describes the input in `report`.
  void describe_input(Skeletonization_report& report) const
  {
    report.number_of_input_vertices = m_numbers.size();
    report.seconds[std::size_t(Skeletonization_stage::compile_surface)] = m_seconds;
    m_surface->describe(report);
    m_surface->warn(report);
  }
  /// @}

private:
  std::vector<Input_descriptor> m_numbers; // of the points of the input
  std::optional<Triangulated_solid> m_surface;
  double m_seconds = 0;
};

} // namespace CSCD

#endif // CSCD_TRAITS_VOXEL_SURFACE_TRAITS_H
