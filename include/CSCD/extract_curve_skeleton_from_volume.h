// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve skeletons of the bodies in an image volume.

#ifndef CSCD_EXTRACT_CURVE_SKELETON_FROM_VOLUME_H
#define CSCD_EXTRACT_CURVE_SKELETON_FROM_VOLUME_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Voxel_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <chrono>
#include <cstddef>
#include <numeric>
#include <optional>
#include <type_traits>
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
  /// What identifies a vertex of the input: its number among the points of the voxel surface.
  using Input_descriptor = std::size_t;
  /// The surface on which the pipeline runs.
  using Surface = Triangulated_solid;
  /// @}

  /// Compiles `surface`, which is not referred to later; near linear.
  /// \pre the surface is as `Voxel_surface_builder` makes it
  explicit Voxel_surface_traits(const Voxel_surface& surface) : m_numbers(surface.triangles.points.size())
  {
    const auto start = std::chrono::steady_clock::now();
    std::iota(m_numbers.begin(), m_numbers.end(), std::size_t(0));
    m_surface.emplace(Indexed_triangles(surface.triangles), Halfedge_pairing(surface.pairing));
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
  /// Writes what is known of the input to `report`.
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

/// extracts the curve skeleton of the voxels that have one label.
///
/// Every connected component of the voxels gets a connected skeleton; the first Betti number of the skeleton is the
/// number of handles of the voxels. Nodes have coordinates and radii in the unit of the volume, and hold the vertices
/// of `surface` that belong to them, by their numbers. See `extract_curve_skeleton()` of a mesh for the rest, the named
/// parameters among it, but for `vertex_point_map`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam Skeleton a model of `CurveSkeletonGraph`: `Skeleton_graph<Point, std::size_t>`
/// \param surface made by `make_voxel_surfaces()` or `read_voxel_surfaces()`
/// \param skeleton is cleared first; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters
/// \return counts, timings and warnings
/// \throw Cancelled_error if the visitor stops the work
template <class ConcurrencyTag = CGAL::Sequential_tag, class Skeleton,
          class NamedParameters = parameters::Default_named_parameters>
Skeletonization_report extract_curve_skeleton(const Voxel_surface& surface, Skeleton& skeleton,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::random_seed_t, CGAL::internal_np::visitor_t,
                                   internal_np::maximum_number_of_sources_t, internal_np::number_of_threads_t,
                                   internal_np::separator_cost_t, internal_np::detail_t, internal_np::policies_t>();
  using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  using Point = std::decay_t<decltype(std::declval<Skeleton&>()[std::declval<Vertex>()].point)>;
  const auto make_traits = [&] { return Voxel_surface_traits<Point>(surface); };
  return internal::skeletonize<ConcurrencyTag, Voxel_surface_traits<Point>>(
      make_traits, internal::skeletonization_policies(np), skeleton, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CURVE_SKELETON_FROM_VOLUME_H
