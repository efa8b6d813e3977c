// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points with their neighborhoods, as the skeletonization sees them: no surface is made of them.

#ifndef CSCD_TRAITS_POINT_SET_TRAITS_H
#define CSCD_TRAITS_POINT_SET_TRAITS_H

#include <CSCD/Surface/Neighbor_table.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Point_cloud.h>
#include <CSCD/Surface/Point_complex.h>
#include <CSCD/Surface/Point_solid_queries.h>
#include <CSCD/Surface/build_point_complex.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// The surface traits of a point cloud by its neighborhoods, a model of `SkeletonizationTraits` and of
/// `SolidSkeletonizationTraits`: what CSCD-PC works on, as published.
///
/// Every point is joined to those around it by triangles that are Delaunay in the tangent planes (supplement, appendix
/// G.2); neighborhoods do not lead over to another sheet. The triangles are nearly a surface, and need not be one: no
/// hole is closed, nothing is cut. A point is inside where the winding number of the points with their normals and
/// areas says so. Sites are the points of the fragments that are not small; every point of the input belongs to one
/// site: its own, that of an equal point, or the nearest.
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
  /// What identifies a point of the input: its index in a `CGAL::Point_set_3`, else its number in the order of
  /// iteration.
  using Input_descriptor = internal::Point_descriptor<PointRange>;
  /// @}

  /// Joins `points`, which are not referred to later, with their neighbors; O(n log n).
  /// \throw Input_error naming the point and the remedy if a coordinate is not finite, or if the points sample no
  ///        surface: fewer than four different ones, all on a line, none of them connected
  Point_set_traits(const PointRange& points, const PointMap& point_map)
  {
    compile(points, point_map, internal::No_normals());
  }
  /// The same, with the point map of a `CGAL::Point_set_3`; of other ranges the elements are the points.
  explicit Point_set_traits(const PointRange& points)
      : Point_set_traits(points, internal::default_point_map(points))
  {
  }
  /// The same for points with normals.
  /// \param points the points
  /// \param point_map maps the elements of `points` to points
  /// \param normal_map a readable map from the elements of `points` to vectors with coordinates `x()`, `y()`, `z()`,
  ///        of any length and of either orientation
  template <class NormalMap>
  Point_set_traits(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map)
  {
    compile(points, point_map, normal_map);
  }
  /// The descriptors of the sites would refer to a range that is gone.
  explicit Point_set_traits(PointRange&&) = delete;
  Point_set_traits(PointRange&&, const PointMap&) = delete;
  Point_set_traits(const Point_set_traits&) = delete;
  Point_set_traits& operator=(const Point_set_traits&) = delete;
  ~Point_set_traits() = default;

  /// \name Sites
  /// @{

  /// One for each place of points.
  Index number_of_sites() const { return m_complex.number_of_vertices(); }
  /// Its place, in the normalized frame.
  const Vector_3& point(Index site) const { return m_complex.point(site); }
  /// The part of the area that the site stands for.
  double weight(Index site) const { return m_complex.vertex_area(site); }
  /// The outward unit normal.
  const Vector_3& normal(Index site) const { return m_complex.normal(site); }
  /// The sites that are joined with `site`, counterclockwise.
  auto neighbors(Index site) const
  {
    const auto target = [this](Index halfedge) { return m_complex.target(halfedge); };
    const auto outgoing = m_complex.outgoing(site);
    return CGAL::make_range(boost::make_transform_iterator(outgoing.begin(), target),
                            boost::make_transform_iterator(outgoing.end(), target));
  }
  /// The points of the input for which the site stands.
  auto descriptors(Index site) const { return m_points[site]; }
  /// @}

  /// \name Triangles
  /// @{

  /// Those that join the points.
  Index number_of_triangles() const { return m_complex.number_of_faces(); }
  /// The three sites of a triangle, counterclockwise seen from outside.
  std::array<Index, 3> triangle(Index face) const { return m_complex.face_vertices(face); }
  /// The triangles with their edges.
  const Point_complex& surface() const { return m_complex; }
  /// @}

  /// \name Coordinates of the input
  /// @{

  /// A point of the normalized frame in the coordinates of the input.
  Point to_input_point(const Vector_3& point) const { return CSCD::to_input_point<Point>(m_normalization, point); }
  /// A length of the normalized frame in the unit of the input.
  double to_input_length(double length) const { return length * m_normalization.unit; }
  /// @}

  /// \name The body
  /// @{

  /// Whether the winding number of the points around `point` is more than a half.
  bool is_inside(const Vector_3& point) const { return m_body->is_inside(point); }
  /// The middle of the body behind the site that is nearest to `point`, if it can be told.
  std::optional<Vector_3> middle_behind(const Vector_3& point) const { return m_body->middle_behind(point); }
  /// Writes the distances from `from` at which the segment from there to `to` meets the surface, in ascending order.
  /// What it crosses twice within half the spacing of the points may be missed.
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
  {
    m_body->crossings(from, to, distances);
  }
  /// @}

  /// \name Counts
  /// @{

  /// The number of points of the input.
  std::size_t number_of_input_vertices() const { return m_points.number_of_points(); }
  /// None: every point belongs to a site.
  std::size_t number_of_isolated_vertices() const { return 0; }
  /// None: borders stay as they are.
  std::size_t number_of_bridged_borders() const { return 0; }
  /// None: points are not refined.
  std::size_t number_of_inserted_vertices() const { return 0; }
  /// None: triangles are made of the points.
  std::size_t number_of_degenerate_faces() const { return 0; }
  /// The number of connected parts that are not small fragments.
  std::size_t number_of_components() const { return m_complex.number_of_components(); }
  /// Not known: the triangles need not be a surface.
  std::optional<std::size_t> genus() const { return std::nullopt; }
  /// @}

  /// What is doubtful about the input or was mended, one sentence each.
  std::vector<std::string> warnings() const
  {
    std::vector<std::string> result;
    if (m_number_of_duplicates > 0) {
      result.push_back(std::to_string(m_number_of_duplicates) +
                       " points at the place of others: they belong to the same nodes");
    }
    if (m_number_of_points_off_surface > 0) {
      result.push_back(std::to_string(m_number_of_points_off_surface) +
                       " points in small fragments or alone: they belong to the nodes of the nearest");
    }
    return result;
  }

  /// The wall-clock seconds that the constructor took.
  double seconds_to_compile() const { return m_seconds_to_compile; }

private:
  template <class NormalMap>
  void compile(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map)
  {
    const auto start = std::chrono::steady_clock::now();
    const internal::Point_cloud cloud = internal::collect_points(points, point_map, normal_map);
    m_normalization = cloud.normalization;
    m_number_of_duplicates = cloud.number_of_duplicates();
    std::vector<Index> vertex_of_point;
    m_complex = drop_fragments(internal::build_point_complex(cloud), vertex_of_point);
    m_number_of_points_off_surface = cloud.points.size() - m_complex.number_of_vertices();
    internal::assign_to_nearest(cloud.points, vertex_of_point);
    m_points = {points, cloud, vertex_of_point, number_of_sites()};
    m_body = std::make_unique<internal::Point_solid_queries>(m_complex);
    m_seconds_to_compile = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Point_complex m_complex;
  Normalization m_normalization;
  internal::Input_points<PointRange> m_points;
  std::unique_ptr<const internal::Point_solid_queries> m_body; // refers to the complex
  std::size_t m_number_of_duplicates = 0;
  std::size_t m_number_of_points_off_surface = 0;
  double m_seconds_to_compile = 0;
};

} // namespace CSCD

#endif // CSCD_TRAITS_POINT_SET_TRAITS_H
