// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body whose surface points sample: the surface of the pipeline for point clouds.

#ifndef CSCD_POINTS_POINT_SOLID_H
#define CSCD_POINTS_POINT_SOLID_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD {
namespace internal {

/// A complex with its holes closed, its fragments joined, and bridges between sheets cut, as where a surface is made of
/// points: it shows which parts are connected.
struct Closed_complex
{
  /// O(n log n) where false handles are few.
  explicit Closed_complex(const Point_complex& complex);

  Triangulated_surface surface;         ///< the closed surface
  std::vector<Index> vertex_in_complex; ///< of each of its vertices; `no_index` for inserted and second ones
};

} // namespace internal

/// Points joined by the triangles that their neighborhoods agree on, and the queries for the body that they enclose:
/// that of the closed surface which the triangles are a part of. The model of `SkeletonizationSurface` for point clouds
/// without a surface.
///
/// Triangles are Delaunay in the tangent planes (supplement, appendix G.2); neighborhoods do not extend to another
/// sheet. The triangles are nearly a surface, and need not be one: only gaps of a few edges are closed, no handle is
/// cut. All members are const and may be called by several threads at once.
class Point_solid
{
public:
  /// Joins the points of `cloud` with their neighbors, and leaves out small fragments; O(n log n).
  /// \throw Input_error if none of the points are connected
  explicit Point_solid(const Point_cloud& cloud);
  Point_solid(Point_solid&&) = delete;

  /// The triangles between the points, in the coordinates of the cloud.
  const Point_complex& triangulation() const { return m_complex; }
  /// The number of connected components.
  std::size_t number_of_components() const { return m_complex.number_of_components(); }
  /// For every point of the cloud its vertex, or that of the nearest point that has one.
  const std::vector<Index>& vertex_of_point() const { return m_vertex_of_point; }
  /// The closed surface that the triangles are a part of.
  const internal::Closed_complex& closed() const { return m_closed; }

  /// \name Body
  /// @{

  /// Whether the body holds `point`.
  bool is_inside(const Vector3& point) const { return m_queries.is_inside(point); }
  /// The middle of the body behind where its surface is nearest to `point`, if there is one.
  std::optional<Vector3> middle_behind(const Vector3& point) const { return m_queries.middle_behind(point); }
  /// Writes the distances from `from` at which the segment from there to `to` enters or leaves the body, in ascending
  /// order.
  void crossings(const Vector3& from, const Vector3& to, std::vector<double>& distances) const
  {
    m_queries.crossings(from, to, distances);
  }
  /// @}

private:
  std::vector<Index> m_vertex_of_point;
  Point_complex m_complex;
  internal::Closed_complex m_closed;
  internal::Solid_queries m_queries; // of the closed surface
};

namespace internal {

/// The complex of the triangulation of `cloud`, with gaps of a few edges closed: shortest paths would go around these.
/// \throw Input_error if no triangle can be made
Point_complex build_point_complex(const Point_cloud& cloud);

} // namespace internal
} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Points/Point_solid_impl.h>
#endif

#endif // CSCD_POINTS_POINT_SOLID_H
