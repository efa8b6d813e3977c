// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points with their neighborhoods, as the skeletonization sees them: no surface is made of them.

#ifndef CSCD_TRAITS_POINT_SET_TRAITS_H
#define CSCD_TRAITS_POINT_SET_TRAITS_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector3.h>

#include <CGAL/Iterator_range.h>

#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>

namespace CSCD {

/// The adapter of a point set to a `Point_solid`, without a surface: the input of CSCD-PC, as published. A model of
/// `SkeletonizationTraits`.
///
/// Vertices are the points of the fragments that are not small; every point of the input belongs to one vertex: its
/// own, that of an equal point, or the nearest.
/// \tparam PointRange a range over elements of any type, or a `CGAL::Point_set_3`
/// \tparam PointMap a readable map from these elements to points with coordinates `x()`, `y()`, `z()`, constructible
///         from three coordinates
template <class PointRange, class PointMap = decltype(internal::default_point_map(std::declval<const PointRange&>()))>
class Point_set_traits
{
public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = typename boost::property_traits<PointMap>::value_type;
  /// The identifier of a point of the input: its index in a `CGAL::Point_set_3`, else its number in the order of
  /// iteration.
  using Input_descriptor = internal::Point_descriptor<PointRange>;
  /// The surface that the pipeline runs on.
  using Surface = Point_solid;
  /// @}

  /// Joins `points`, which are not referred to later, with their neighbors; O(n log n).
  /// \throw Input_error naming the point and the remedy if a coordinate is not finite, or if the points sample no
  ///        surface: fewer than four different ones, all on a line, none of them connected
  Point_set_traits(const PointRange& points, const PointMap& point_map)
      : Point_set_traits(points, point_map, internal::No_normals())
  {
  }
  /// The same, with the point map of a `CGAL::Point_set_3`; of other ranges the elements are the points.
  explicit Point_set_traits(const PointRange& points) : Point_set_traits(points, internal::default_point_map(points)) {}
  /// The same for points with normals.
  /// \param points the points
  /// \param point_map maps the elements of `points` to points
  /// \param normal_map a readable map from the elements of `points` to vectors with coordinates `x()`, `y()`, `z()`,
  ///        of any length and of either orientation
  template <class NormalMap>
  Point_set_traits(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map)
  {
    const auto start = std::chrono::steady_clock::now();
    const Point_cloud cloud = internal::collect_points(points, point_map, normal_map);
    m_normalization = cloud.normalization;
    m_number_of_duplicates = cloud.number_of_duplicates();
    m_surface.emplace(cloud);
    const std::size_t number_of_vertices = m_surface->triangulation().number_of_vertices();
    m_number_of_points_off_surface = cloud.points.size() - number_of_vertices;
    m_points = {points, cloud, m_surface->vertex_of_point(), number_of_vertices};
    m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// A temporary range is refused: the descriptors would refer to it.
  explicit Point_set_traits(PointRange&&) = delete;
  Point_set_traits(PointRange&&, const PointMap&) = delete;

  /// The points with the triangles that join them.
  const Point_solid& surface() const { return *m_surface; }

  /// \name Back to the input
  /// @{

  /// The points of the input that belong to `vertex`.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index vertex) const { return m_points[vertex]; }
  /// A point of the surface in the coordinates of the input.
  Point to_input_point(const Vector3& point) const { return CSCD::to_input_point<Point>(m_normalization, point); }
  /// A length on the surface in the unit of the input.
  double to_input_length(double length) const { return length * m_normalization.unit; }
  /// Describes the input in `report`, without a genus: the triangles need not be a surface.
  void describe_input(Skeletonization_report& report) const
  {
    report.number_of_input_vertices = m_points.number_of_points();
    report.number_of_surface_components = m_surface->number_of_components();
    report.seconds[std::size_t(Skeletonization_stage::compile_surface)] = m_seconds;
    report.add_warning(m_number_of_duplicates, "point at the place of another: it belongs to the same node",
                       "points at the place of others: they belong to the same nodes");
    report.add_warning(m_number_of_points_off_surface,
                       "point in a small fragment or alone: it belongs to the node of the nearest",
                       "points in small fragments or alone: they belong to the nodes of the nearest");
  }
  /// @}

private:
  std::optional<Point_solid> m_surface;
  Normalization m_normalization;
  internal::Input_points<PointRange> m_points;
  std::size_t m_number_of_duplicates = 0;
  std::size_t m_number_of_points_off_surface = 0;
  double m_seconds = 0;
};

} // namespace CSCD

#endif // CSCD_TRAITS_POINT_SET_TRAITS_H
