// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulates points and closes the triangles to a surface.

#ifndef CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
#define CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H

#include <CSCD/Options.h>
#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Points/consolidate_points.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <optional>
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

/// Makes a closed surface of `cloud`, in its coordinates.
inline Reconstructed_surface closed_surface(const Point_cloud& cloud)
{
  Triangulated_cloud triangulated = Cloud_triangulation(cloud)();
  Reconstructed_surface result;
  result.triangles.points = std::move(triangulated.points);
  result.triangles.faces = std::move(triangulated.triangles);
  Reconstruction_report& report = result.report;
  report.number_of_points = cloud.input_point.size();
  report.number_of_duplicates = cloud.number_of_duplicates();
  report.number_of_thinned_points = cloud.number_of_thinned_points - cloud.number_of_outliers;
  report.number_of_outliers = cloud.number_of_outliers;
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
  report.number_of_unused_points = cloud.number_of_outliers + cloud.points.size() +
                                   std::size_t(std::count(point.begin(), point.end(), no_index)) - point.size();
  return result;
}

/// For every point of `cloud`, its vertex in `solid`, or that of the nearest point that has one.
/// \param solid the solid that was made of the closed surface
/// \param point_of_vertex that of the closed surface
inline std::vector<Index> vertices_of_points(const Triangulated_solid& solid, const Point_cloud& cloud,
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

/// Describes in the report of a solid how it was made of points.
inline void describe(Reconstruction_report&& made, Reconstruction& result)
{
  // With more border edges for each point, the surface is doubtful: of the 173 right ones of 208 clouds of surfaces,
  // one has more, scans of trees and parts of them have more than 0.3.
  constexpr double doubtful_border_edges = 0.28;
  // With more cuts for each point, the skeleton is doubtful: of 173 clouds whose skeleton is right one has more, of 35
  // others 14.
  constexpr double doubtful_cuts = 0.0015;
  const std::size_t number_of_points = made.number_of_sampled_points() - made.number_of_outliers;
  result.is_surface_doubtful = double(made.number_of_border_edges) > doubtful_border_edges * double(number_of_points);
  Skeletonization_report& report = result.report;
  report.warnings.clear(); // about the surface, which is not the input
  report.number_of_bridged_borders = made.number_of_holes;
  if (result.is_surface_doubtful) {
    report.warnings.emplace_back(
        "the points hardly sample the surface of a body: it has " + std::to_string(made.number_of_border_edges) +
        " border edges for " + std::to_string(number_of_points) +
        " points, and the skeleton may be wrong; if this is a scan of trees or of other thin things, "
        "extract_tree_skeleton() is made for it");
  }
  report.add_warning(made.number_of_duplicates, "point at the place of another: it belongs to the same node",
                     "points at the place of others: they belong to the same nodes");
  report.add_warning(made.number_of_outliers, "outlier, far from all other points: left out",
                     "outliers, far from all other points: left out");
  report.add_warning(made.number_of_unused_points, "point off the surface: it belongs to the node of the nearest",
                     "points off the surface: they belong to the nodes of the nearest");
  if (report.number_of_sheets > 0) {
    report.warnings.emplace_back("the points are those of a sheet, or of a body that is thinner than they are far "
                                 "apart: the skeleton is that of a sheet; sample a body more densely");
  }
  report.add_warning(made.number_of_holes, "hole of the reconstructed surface: closed by faces without weight",
                     "holes of the reconstructed surface: closed by faces without weight");
  report.add_warning(made.joined_gaps.size(), "gap between fragments of the reconstructed surface: bridged",
                     "gaps between fragments of the reconstructed surface: bridged");
  report.add_warning(made.cut_handles.size(), "handle too small for the spacing of the points: cut",
                     "handles too small for the spacing of the points: cut");
  if (double(made.cut_handles.size()) > doubtful_cuts * double(number_of_points)) {
    report.warnings.emplace_back(
        "so many handles were cut that the skeleton may be wrong: sample the body more densely");
  }
  report.reconstruction = std::move(made);
}

CSCD_INLINE Reconstruction reconstruct_surface(Point_cloud&& cloud, unsigned number_of_threads,
                                               std::optional<Triangulated_solid>& solid)
{
  const Point_cloud consolidated = consolidate_points(std::move(cloud));
  Reconstructed_surface surface = closed_surface(consolidated);
  solid.emplace(std::move(surface.triangles), std::move(surface.pairing),
                surface.is_sheet ? Border_treatment::open : Border_treatment::bridge, number_of_threads);
  Reconstruction result;
  result.normalization = consolidated.normalization.then(solid->normalization());
  result.vertex_of_point =
      reordered(vertices_of_points(*solid, consolidated, surface.point_of_vertex), consolidated.input_point);
  result.report = solid->report();
  describe(std::move(surface.report), result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
