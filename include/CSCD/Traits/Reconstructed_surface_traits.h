// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface through points, as the skeletonization sees it.

#ifndef CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H
#define CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H

#include <CSCD/Reconstruction/Surface_reconstruction.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Neighbor_table.h>
#include <CSCD/Surface/Point_cloud.h>
#include <CSCD/Surface/compile_surface.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Traits/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// The surface traits of a point set, a model of `SkeletonizationTraits` and of
/// `TriangulatedSolidSkeletonizationTraits`.
///
/// A closed surface is made of the points: they are triangulated by an advancing front, fragments joined, holes closed,
/// and handles removed that are too small for the sampling to prove them. Sites are the vertices of this surface. Every
/// point of the input belongs to one site: its own, that of an equal point, or the nearest, if it is no vertex.
/// \tparam PointRange a range over elements of any type, or a `CGAL::Point_set_3`
/// \tparam PointMap a readable map from these elements to points with coordinates `x()`, `y()`, `z()`, constructible
///         from three coordinates
template <class PointRange, class PointMap = decltype(internal::default_point_map(std::declval<const PointRange&>()))>
class Reconstructed_surface_traits : public internal::Compiled_surface_traits<typename boost::property_traits<PointMap>::value_type>
{
  using Base = internal::Compiled_surface_traits<typename boost::property_traits<PointMap>::value_type>;

public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = typename Base::Point;
  /// The number of a site.
  using Index = typename Base::Index;
  /// What identifies a point of the input: its index in a `CGAL::Point_set_3`, else its number in the order of
  /// iteration.
  using Input_descriptor = internal::Point_descriptor<PointRange>;
  /// @}

  /// Makes a surface of `points`, which are not referred to later; O(n log n).
  /// \throw Input_error naming the point and the remedy if a coordinate is not finite, or if no surface can be made of
  ///        the points: fewer than four different ones, all on a line, none of them connected
  Reconstructed_surface_traits(const PointRange& points, const PointMap& point_map)
  {
    compile(points, point_map, internal::No_normals());
  }
  /// The same, with the point map of a `CGAL::Point_set_3`; of other ranges the elements are the points.
  explicit Reconstructed_surface_traits(const PointRange& points) : Reconstructed_surface_traits(points, internal::default_point_map(points)) {}
  /// The same for points with normals.
  /// \param points the points
  /// \param point_map maps the elements of `points` to points
  /// \param normal_map a readable map from the elements of `points` to vectors with coordinates `x()`, `y()`, `z()`,
  ///        of any length and of either orientation: surfaces are not made across them
  template <class NormalMap>
  Reconstructed_surface_traits(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map)
  {
    compile(points, point_map, normal_map);
  }
  /// The descriptors of the sites would refer to a range that is gone.
  explicit Reconstructed_surface_traits(PointRange&&) = delete;
  Reconstructed_surface_traits(PointRange&&, const PointMap&) = delete;

  /// \name Sites of the input
  /// @{

  /// The points of the input for which the site stands; none for an inserted site.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index site) const { return m_points[site]; }
  /// The number of points of the input.
  std::size_t number_of_input_vertices() const { return m_points.number_of_points(); }
  /// None: every point belongs to a site.
  std::size_t number_of_isolated_vertices() const { return 0; }
  /// @}

  /// Whether the points hardly sample the surface of a body, by the number of border edges of what was made of them:
  /// such are scans of trees, which `extract_tree_skeleton()` is for.
  bool is_surface_doubtful() const
  {
    return double(m_report.number_of_border_edges) > doubtful_border_edges * double(m_report.number_of_points);
  }

  /// What is doubtful about the input or was mended, one sentence each.
  std::vector<std::string> warnings() const
  {
    std::vector<std::string> result;
    const auto warn = [&result](std::size_t count, const char* what) {
      if (count > 0) {
        result.push_back(std::to_string(count) + ' ' + what);
      }
    };
    if (is_surface_doubtful()) {
      result.emplace_back("the points hardly sample the surface of a body: it has " +
                          std::to_string(m_report.number_of_border_edges) + " border edges for " +
                          std::to_string(m_report.number_of_points) +
                          " points, and the skeleton may be wrong; if this is a scan of trees or of other thin things, "
                          "extract_tree_skeleton() is made for it");
    }
    warn(m_report.number_of_duplicates, "points at the place of others: they belong to the same nodes");
    warn(m_report.number_of_unused_points, "points off the surface: they belong to the nodes of the nearest");
    warn(m_report.number_of_holes, "holes of the reconstructed surface: closed by faces without weight");
    warn(m_report.joined_gaps.size(), "gaps between fragments of the reconstructed surface: bridged");
    warn(m_report.cut_handles.size(), "handles too small for the spacing of the points: cut");
    return result;
  }

  /// What was done to make a surface of the points.
  const Reconstruction_report& reconstruction_report() const { return m_report; }

  /// The wall-clock seconds that the constructor took.
  double seconds_to_compile() const { return m_seconds_to_compile; }

private:
  /// Border edges for each point from which on the surface is doubtful: 70 clouds of surfaces had at most 0.07, three
  /// scans of trees 0.20 and more.
  static constexpr double doubtful_border_edges = 0.12;

  template <class NormalMap>
  void compile(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map)
  {
    const auto start = std::chrono::steady_clock::now();
    const internal::Point_cloud cloud = internal::collect_points(points, point_map, normal_map);
    internal::Reconstructed_surface reconstructed = internal::reconstruct_surface(cloud);
    m_report = std::move(reconstructed.report);
    auto compiled = internal::compile_surface(std::move(reconstructed.triangles), std::move(reconstructed.pairing));
    compiled.normalization = cloud.normalization.then(compiled.normalization);
    compiled.number_of_bridged_borders = m_report.number_of_holes;
    Base::set_surface(std::move(compiled));
    m_points = {points, cloud, vertices_of_points(cloud, reconstructed.point_of_vertex), Base::number_of_sites()};
    m_seconds_to_compile = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// Finds the site of every point of the cloud.
  std::vector<Index> vertices_of_points(const internal::Point_cloud& cloud,
                                     const std::vector<Index>& point_of_vertex) const
  {
    std::vector<Index> result(cloud.points.size(), no_index);
    for (Index site = 0; site < Base::number_of_sites(); ++site) {
      const Index vertex = Base::input_point(site);
      if (vertex != no_index && point_of_vertex[vertex] != no_index) {
        result[point_of_vertex[vertex]] = site;
      }
    }
    internal::assign_to_nearest(cloud.points, result);
    return result;
  }

  internal::Input_points<PointRange> m_points;
  Reconstruction_report m_report;
  double m_seconds_to_compile = 0;
};

} // namespace CSCD

#endif // CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H
