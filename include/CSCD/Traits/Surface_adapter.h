// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the adapters of all inputs have in common.

#ifndef CSCD_TRAITS_SURFACE_ADAPTER_H
#define CSCD_TRAITS_SURFACE_ADAPTER_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD {

/// A surface that is made of an input, and the way back: a model of `SkeletonizationTraits`, the base of adapters,
/// which fill it when they are constructed.
/// \tparam AdaptedSurface a model of `SkeletonizationSurface`, or `Spatial_graph`
/// \tparam InputPoint constructible from three coordinates
template <class AdaptedSurface, class InputPoint, class InputDescriptor>
class Surface_adapter
{
public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = InputPoint;
  /// The identifier of a vertex or point of the input.
  using Input_descriptor = InputDescriptor;
  /// The surface that the pipeline runs on.
  using Surface = AdaptedSurface;
  /// @}

  /// The surface.
  const Surface& surface() const { return *m_surface; }
  /// The vertices or points of the input that belong to `vertex`; none for an inserted vertex.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index vertex) const { return m_descriptors[vertex]; }
  /// From the coordinates of the input to those of the surface.
  const Normalization& normalization() const { return m_normalization; }
  /// Describes the input in `report`.
  void describe_input(Skeletonization_report& report) const { report = m_report; }

protected:
  /// Fills all but the surface from that, a `Triangulated_solid`.
  /// \param descriptor `descriptor(i)` identifies the vertex or point of the input with the number `i`
  template <class Descriptor>
  void describe_solid(const Descriptor& descriptor)
  {
    const Index number_of_vertices = surface().triangulation().number_of_vertices();
    m_descriptors = internal::Compressed_rows<Input_descriptor>(number_of_vertices, [&](const auto& add) {
      for (Index vertex = 0; vertex < number_of_vertices; ++vertex) {
        for (const Index input : surface().input_vertices(vertex)) {
          add(vertex, descriptor(input));
        }
      }
    });
    m_normalization = surface().normalization();
    m_report = surface().report();
  }

  /// Fills the rows of descriptors, and notes the number of them and the time since the construction began.
  /// \param descriptors of all vertices or points of the input
  /// \param vertices for each of them, the vertex of the surface that it belongs to
  void describe(const std::vector<Input_descriptor>& descriptors, const std::vector<Index>& vertices)
  {
    m_descriptors = internal::Compressed_rows<Input_descriptor>(surface().triangulation().number_of_vertices(),
                                                                [&](const auto& add) {
                                                                  for (std::size_t i = 0; i < descriptors.size(); ++i) {
                                                                    add(vertices[i], descriptors[i]);
                                                                  }
                                                                });
    m_report.number_of_input_vertices = descriptors.size();
    m_report.seconds[std::size_t(Skeletonization_stage::compile_surface)] =
        std::chrono::duration<double>(Clock::now() - m_start).count();
  }

  std::optional<Surface> m_surface;                          ///< the surface
  internal::Compressed_rows<Input_descriptor> m_descriptors; ///< of every vertex
  Normalization m_normalization;                             ///< the coordinates of the surface
  Skeletonization_report m_report;                           ///< the description of the input

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point m_start = Clock::now();
};

} // namespace CSCD

#endif // CSCD_TRAITS_SURFACE_ADAPTER_H
