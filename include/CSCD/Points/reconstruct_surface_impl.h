// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulates points and closes the triangles to a surface.

#ifndef CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
#define CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

[[noreturn]] inline void refuse(const Point_cloud& cloud, const std::string& reason)
{
  const std::string what = "the points do not sample a surface: ";
  if (lie_in_slices(cloud.points)) {
    throw Input_error(what + "they lie along curves in parallel planes, which are too far apart; add planes between");
  }
  throw Surface_error(what + reason);
}

/// Refuses triangles that are not those of a surface.
inline void check_border(const Point_cloud& cloud, const Reconstructed_surface& surface)
{
  constexpr double max_border_edges = 0.6; // for each vertex: curves have about one
  constexpr double min_used_part = 0.5;    // of the points: most of those along a curve have no triangle
  const std::size_t number_of_vertices = surface.triangles.points.size();
  const std::size_t number_of_edges = surface.report.number_of_border_edges;
  if (double(number_of_vertices) <= min_used_part * double(cloud.points.size()) ||
      double(number_of_edges) > max_border_edges * double(number_of_vertices)) {
    refuse(cloud, "the triangles between them have " + std::to_string(number_of_vertices) + " vertices for " +
                      std::to_string(cloud.points.size()) + " points, and " + std::to_string(number_of_edges) +
                      " border edges; sample the surface more densely");
  }
}

CSCD_INLINE Reconstructed_surface reconstruct_surface(const Point_cloud& cloud)
{
  Triangulated_cloud triangulated = Cloud_triangulation(cloud)();
  Reconstructed_surface result;
  result.triangles.points = std::move(triangulated.points);
  result.triangles.faces = std::move(triangulated.triangles);
  Reconstruction_report& report = result.report;
  report.number_of_points = cloud.input_point.size();
  report.number_of_duplicates = cloud.number_of_duplicates();
  report.number_of_thinned_points = cloud.number_of_thinned_points;
  report.is_averaged = cloud.is_averaged;
  report.number_of_neighbors = quadric_neighbors;
  report.spacing = triangulated.spacing * cloud.normalization.unit;
  report.noise = triangulated.noise;
  report.is_smoothed = triangulated.is_smoothed;
  Surface_completion complete(result, cloud.normalization);
  complete.prepare();
  if (lie_along_curves(cloud.points, triangulated.spacing)) {
    refuse(cloud, "they lie along curves; sample the surface more densely between them");
  }
  check_border(cloud, result);
  complete();
  complete.open_sheet(triangulated.spacing);
  const std::vector<Index>& point = result.point_of_vertex;
  report.number_of_unused_points =
      cloud.points.size() + std::size_t(std::count(point.begin(), point.end(), no_index)) - point.size();
  return result;
}

CSCD_INLINE std::vector<Index> vertices_of_points(const Triangulated_solid& solid, const Point_cloud& cloud,
                                                  const std::vector<Index>& point_of_vertex)
{
  std::vector<Index> result(cloud.points.size(), no_index);
  for (Index vertex = 0; vertex < solid.triangulation().number_of_vertices(); ++vertex) {
    for (const Index input : solid.input_vertices(vertex)) {
      if (point_of_vertex[input] != no_index) {
        result[point_of_vertex[input]] = vertex;
      }
    }
  }
  assign_to_nearest(cloud.points, result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
