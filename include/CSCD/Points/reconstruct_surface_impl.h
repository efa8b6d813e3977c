// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of reconstruct_surface.h.

#ifndef CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
#define CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Reconstructed_surface.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/advance_front.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Makes a closed surface of a cloud, step by step.
class Surface_reconstruction
{
public:
  explicit Surface_reconstruction(const Point_cloud& cloud)
      : m_cloud(cloud), m_neighbors(cloud.points, Cloud_sampling::number_of_neighbors),
        m_sampling(cloud.points, m_neighbors)
  {
    m_result.report.number_of_points = cloud.input_point.size();
    m_result.report.number_of_duplicates = cloud.number_of_duplicates();
    m_result.report.number_of_thinned_points = cloud.number_of_thinned_points;
    m_result.report.is_averaged = cloud.is_averaged;
    m_result.report.number_of_neighbors = m_neighbors.number();
    m_result.report.spacing = m_sampling.spacing() * cloud.normalization.unit;
    m_result.report.noise = m_sampling.noise();
    m_result.report.is_smoothed = m_sampling.is_smoothed();
    m_result.report.number_of_outliers = m_sampling.number_of_outliers();
  }

  /// \throw Surface_error if the points do not sample a surface; another Input_error if it is that of a body in slices
  Reconstructed_surface operator()()
  {
    // A triangulation of points along curves can be of quadratic size.
    if (lie_along_curves(m_cloud.points, m_sampling.spacing())) {
      refuse("they lie along curves; sample the surface more densely between them");
    }
    triangulate();
    Surface_completion complete(m_result, m_cloud.normalization);
    complete.prepare();
    check_border();
    complete();
    m_result.report.number_of_unused_points = m_cloud.points.size() - count_used_points();
    return std::move(m_result);
  }

private:
  /// The longest edge of a triangle, relative to how far the neighborhood of its ends reaches.
  static constexpr double longest_edge = 2;
  /// How far points are moved, for the triangulation only, relative to the reach of their neighborhoods: far more than
  /// rounding, far less than matters.
  static constexpr double jitter = 1e-6;
  /// With more border edges than this for each vertex there is no surface: curves have about one.
  static constexpr double max_border_edges = 0.6;
  void triangulate()
  {
    // The result of the front must not depend on the pose, nor, among equal triangles, on the addresses of their
    // points.
    std::vector<Vector_3> posed(m_sampling.points().size());
    std::vector<Front_limit> limits(m_sampling.points().size());
    for (Index point = 0; point < m_sampling.points().size(); ++point) {
      const double reach = m_cloud.pose.scale() * m_neighbors.reach(point);
      posed[point] = m_cloud.pose(m_sampling.points()[point]) + jitter * reach * pseudo_random_vector(point);
      limits[point].longest_edge = m_sampling.is_outlier(point) ? 0 : longest_edge * reach;
      if (!m_cloud.normals.empty()) {
        limits[point].normal = m_cloud.pose.turn(m_cloud.normals[point]);
      }
    }
    Indexed_triangles& triangles = m_result.triangles;
    triangles.points = m_sampling.points();
    triangles.faces = advance_front(posed, limits);
    if (triangles.faces.empty()) {
      throw Surface_error("no surface could be made of the points: they do not sample one densely enough");
    }
  }

  void check_border() const
  {
    const std::size_t number_of_vertices = m_result.triangles.points.size();
    if (double(m_result.report.number_of_border_edges) > max_border_edges * double(number_of_vertices)) {
      refuse("what connects them has " + std::to_string(m_result.report.number_of_border_edges) + " border edges at " +
             std::to_string(number_of_vertices) + " points; sample the surface more densely");
    }
  }

  [[noreturn]] void refuse(const std::string& reason) const
  {
    const std::string what = "the points do not sample a surface: ";
    if (lie_in_slices(m_cloud.points)) {
      throw Input_error(what + "they lie along curves in parallel planes, which are too far apart; add planes between");
    }
    throw Surface_error(what + reason);
  }

  std::size_t count_used_points() const
  {
    return m_result.point_of_vertex.size() -
           std::size_t(std::count(m_result.point_of_vertex.begin(), m_result.point_of_vertex.end(), no_index));
  }

  const Point_cloud& m_cloud;
  Neighbor_table m_neighbors;
  Cloud_sampling m_sampling;
  Reconstructed_surface m_result;
};

CSCD_INLINE Reconstructed_surface reconstruct_surface(const Point_cloud& cloud)
{
  return Surface_reconstruction(cloud)();
}

CSCD_INLINE std::vector<Index> vertices_of_points(const Triangulated_solid& solid, const Point_cloud& cloud,
                                                  const std::vector<Index>& point_of_vertex)
{
  std::vector<Index> result(cloud.points.size(), no_index);
  for (Index vertex = 0; vertex < solid.triangulation().number_of_vertices(); ++vertex) {
    const Index input = solid.input_vertex(vertex);
    if (input != no_index && point_of_vertex[input] != no_index) {
      result[point_of_vertex[input]] = vertex;
    }
  }
  assign_to_nearest(cloud.points, result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
