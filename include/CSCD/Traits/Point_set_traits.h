// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points with their neighborhoods, as the skeletonization sees them: no surface is made of them.

#ifndef CSCD_TRAITS_POINT_SET_TRAITS_H
#define CSCD_TRAITS_POINT_SET_TRAITS_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Traits/Surface_adapter.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/property_map/property_map.hpp>

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
class Point_set_traits : public Surface_adapter<Point_solid, typename boost::property_traits<PointMap>::value_type,
                                                Point_descriptor<PointRange>>
{
public:
  /// Joins `points`, which are not referred to later, with their neighbors; O(n log n).
  /// \param points the points
  /// \param point_map maps the elements of `points` to points
  /// \param normal_map a readable map from the elements of `points` to vectors with coordinates `x()`, `y()`, `z()`,
  ///        of any length and of either orientation; none by default
  /// \throw Input_error naming the point and the remedy if a coordinate is not finite, or if the points sample no
  ///        surface: fewer than four different ones, all on a line, none of them connected
  template <class NormalMap = internal::No_normals>
  Point_set_traits(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map = NormalMap())
  {
    const Point_cloud cloud = internal::collect_points(points, point_map, normal_map);
    const Point_solid& solid = this->m_surface.emplace(cloud);
    this->m_normalization = cloud.normalization;
    // Without a genus: the triangles need not be a surface.
    Skeletonization_report& report = this->m_report;
    report.number_of_surface_components = solid.number_of_components();
    report.add_warning(cloud.number_of_duplicates(), "point at the place of another: it belongs to the same node",
                       "points at the place of others: they belong to the same nodes");
    report.add_warning(cloud.points.size() - solid.triangulation().number_of_vertices(),
                       "point in a small fragment or alone: it belongs to the node of the nearest",
                       "points in small fragments or alone: they belong to the nodes of the nearest");
    this->describe(internal::descriptors_of(points), internal::reordered(solid.vertex_of_point(), cloud.input_point));
  }
  /// The same, with the point map of a `CGAL::Point_set_3`; of other ranges the elements are the points.
  explicit Point_set_traits(const PointRange& points) : Point_set_traits(points, internal::default_point_map(points)) {}
  /// A temporary range is refused: the descriptors would refer to it.
  explicit Point_set_traits(PointRange&&) = delete;
  Point_set_traits(PointRange&&, const PointMap&) = delete;
};

} // namespace CSCD

#endif // CSCD_TRAITS_POINT_SET_TRAITS_H
