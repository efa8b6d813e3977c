// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of reconstruct_surface.h.

#ifndef CSCD_RECONSTRUCTION_RECONSTRUCT_SURFACE_IMPL_H
#define CSCD_RECONSTRUCTION_RECONSTRUCT_SURFACE_IMPL_H

#include <CSCD/Reconstruction/Fragment_joining.h>
#include <CSCD/Reconstruction/Handle_repair.h>
#include <CSCD/Reconstruction/advance_front.h>
#include <CSCD/Reconstruction/recognize_tree_scan.h>
#include <CSCD/Reconstruction/reconstruct_surface.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Cloud_sampling.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Neighbor_table.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Point_cloud.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/bridge_borders.h>
#include <CSCD/Surface/canonical_order.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
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

  /// \throw Surface_error if the points do not sample a surface
  Reconstructed_surface operator()()
  {
    // A triangulation of points along curves can be of quadratic size.
    if (lie_along_curves(m_cloud.points, m_sampling.spacing())) {
      throw Surface_error("the points do not sample a surface: they lie along curves; sample the surface more densely "
                          "between them");
    }
    triangulate();
    join_fragments();
    close();
    remove_false_handles();
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
    m_result.pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
    CGAL_assertion(m_result.pairing.conflict() == no_index);
    split_pinched_vertices(triangles, m_result.pairing);
    // Copies come after all points: they are of no point.
    for (Index point = 0; point < m_cloud.points.size(); ++point) {
      m_result.point_of_vertex.push_back(point);
    }
    m_result.point_of_vertex.resize(triangles.points.size(), no_index);
    for (Index h = 0; h < m_result.pairing.number_of_halfedges(); ++h) {
      m_result.report.number_of_border_edges += m_result.pairing.twin(h) == no_index ? 1 : 0;
    }
    compact();
    const std::size_t number_of_vertices = triangles.points.size();
    if (double(m_result.report.number_of_border_edges) > max_border_edges * double(number_of_vertices)) {
      throw Surface_error("the points do not sample a surface: what connects them has " +
                          std::to_string(m_result.report.number_of_border_edges) + " border edges at " +
                          std::to_string(number_of_vertices) + " points; sample the surface more densely");
    }
  }

  /// Removes vertices without faces, and pairs the halfedges again.
  void compact()
  {
    Indexed_triangles& triangles = m_result.triangles;
    const std::vector<Index> old_number = compact_numbers(triangles.faces, triangles.points.size());
    for (Index vertex = 0; vertex < old_number.size(); ++vertex) {
      triangles.points[vertex] = triangles.points[old_number[vertex]];
      m_result.point_of_vertex[vertex] = m_result.point_of_vertex[old_number[vertex]];
    }
    triangles.points.resize(old_number.size());
    m_result.point_of_vertex.resize(old_number.size());
    triangles.first_hole_filling_face = triangles.faces.size();
    pair();
  }

  void pair()
  {
    m_result.pairing = Halfedge_pairing(m_result.triangles.faces, m_result.triangles.points.size());
    CGAL_assertion(m_result.pairing.conflict() == no_index);
  }

  void join_fragments()
  {
    Fragment_joining joining(m_result.triangles, m_result.pairing);
    for (const Joined_gap& gap : joining()) {
      m_result.report.joined_gaps.push_back(repair(gap.center, gap.width));
    }
    pair();
  }

  Reconstruction_repair repair(const Vector_3& center, double length) const
  {
    const Vector_3 input = m_cloud.normalization.to_input(center);
    return {{input.x(), input.y(), input.z()}, length * m_cloud.normalization.unit};
  }

  /// Closes all holes and orients the surface.
  void close()
  {
    m_result.report.number_of_holes = bridge_borders(m_result.triangles, m_result.pairing);
    m_result.point_of_vertex.resize(m_result.triangles.points.size(), no_index);
    pair();
    Surface_components components(m_result.triangles, m_result.pairing);
    orient_outwards(m_result.triangles, m_result.pairing, components);
    m_number_of_components = components.number();
  }

  std::size_t genus() const
  {
    return genus_of_closed_surface(m_number_of_components, m_result.triangles.points.size(),
                                   m_result.triangles.faces.size());
  }

  /// Cuts small handles, round by round: loops of one round have no vertex in common.
  void remove_false_handles()
  {
    while (genus() > 0) {
      // What is cut must not depend on the numbering.
      renumber_canonically();
      const Triangulated_surface surface{Indexed_triangles(m_result.triangles)};
      const std::vector<Vertex_loop> loops = Handle_repair(surface)();
      if (loops.empty()) {
        return;
      }
      for (const Vertex_loop& loop : loops) {
        report_cut(loop);
      }
      cut_along_loops(m_result.triangles, surface, loops);
      pair();
      bridge_borders(m_result.triangles, m_result.pairing);
      m_result.point_of_vertex.resize(m_result.triangles.points.size(), no_index);
      pair();
    }
  }

  void renumber_canonically()
  {
    const Surface_components components(m_result.triangles, m_result.pairing);
    const Canonical_order order = canonical_order(m_result.triangles, m_result.pairing, components);
    renumber(m_result.triangles, order.vertices);
    pair();
    std::vector<Index> point_of_vertex;
    point_of_vertex.reserve(order.vertices.size());
    for (Index old_number : order.vertices) {
      point_of_vertex.push_back(m_result.point_of_vertex[old_number]);
    }
    m_result.point_of_vertex = std::move(point_of_vertex);
  }

  void report_cut(const Vertex_loop& loop)
  {
    const std::vector<Vector_3>& points = m_result.triangles.points;
    double length = 0;
    Vector_3 center = Vector_3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      length += (points[loop[(i + 1) % loop.size()]] - points[loop[i]]).norm();
      center += points[loop[i]] / double(loop.size());
    }
    m_result.report.cut_handles.push_back(repair(center, length));
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
  std::size_t m_number_of_components = 0;
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

#endif // CSCD_RECONSTRUCTION_RECONSTRUCT_SURFACE_IMPL_H
