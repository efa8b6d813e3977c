// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface through points, as the skeletonization sees it.

#ifndef CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H
#define CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/consolidate_points.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Traits/Surface_adapter.h>
#include <CSCD/Vector3.h>

#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>

namespace CSCD {

/// The adapter of a point set to a `Triangulated_solid`; a model of `SkeletonizationTraits` and the default for points.
///
/// A closed surface is made of the points: they are triangulated in their tangent planes, fragments are joined, holes
/// closed, and handles removed that are too small for the sampling to prove them. Every point of the input belongs to
/// one vertex of this surface: its own, that of an equal point, or the nearest, if it is not a vertex.
/// \tparam PointRange a range over elements of any type, or a `CGAL::Point_set_3`
/// \tparam PointMap a readable map from these elements to points with coordinates `x()`, `y()`, `z()`, constructible
///         from three coordinates
template <class PointRange, class PointMap = decltype(internal::default_point_map(std::declval<const PointRange&>()))>
class Reconstructed_surface_traits
    : public Surface_adapter<Triangulated_solid, typename boost::property_traits<PointMap>::value_type,
                             Point_descriptor<PointRange>>
{
public:
  /// Makes a surface of `points`, which are not referred to later; O(n log n).
  /// \param points the points
  /// \param point_map maps the elements of `points` to points
  /// \param normal_map a readable map from the elements of `points` to vectors with coordinates `x()`, `y()`, `z()`,
  ///        of any length and of either orientation: surfaces are not made across them; none by default
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  /// \throw Input_error naming the point and the remedy if a coordinate is not finite, or if no surface can be made of
  ///        the points: fewer than four different ones, all on a line, none of them connected
  template <class NormalMap = internal::No_normals>
  Reconstructed_surface_traits(const PointRange& points, const PointMap& point_map,
                               const NormalMap& normal_map = NormalMap(), unsigned number_of_threads = 1)
  {
    const auto start = std::chrono::steady_clock::now();
    const auto [cloud, number_of_outliers] =
        internal::consolidate_points(internal::collect_points(points, point_map, normal_map));
    internal::Reconstructed_surface reconstructed = internal::reconstruct_surface(cloud);
    reconstructed.report.number_of_outliers += number_of_outliers;
    reconstructed.report.number_of_unused_points += number_of_outliers;
    reconstructed.report.number_of_thinned_points -= number_of_outliers;
    const Triangulated_solid& solid = this->m_surface.emplace(
        std::move(reconstructed.triangles), std::move(reconstructed.pairing),
        reconstructed.is_sheet ? Border_treatment::open : Border_treatment::bridge, number_of_threads);
    this->m_normalization = cloud.normalization.then(solid.normalization());
    this->m_descriptors = internal::points_of_vertices(
        points, cloud, internal::vertices_of_points(solid, cloud, reconstructed.point_of_vertex),
        solid.triangulation().number_of_vertices());
    this->m_report = solid.report();
    describe(reconstructed.report);
    this->m_report.seconds[std::size_t(Skeletonization_stage::compile_surface)] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// The same, with the point map of a `CGAL::Point_set_3`; of other ranges the elements are the points.
  explicit Reconstructed_surface_traits(const PointRange& points)
      : Reconstructed_surface_traits(points, internal::default_point_map(points))
  {
  }
  /// A temporary range is refused: the descriptors would refer to it.
  explicit Reconstructed_surface_traits(PointRange&&) = delete;
  Reconstructed_surface_traits(PointRange&&, const PointMap&) = delete;

  /// Whether the points hardly sample the surface of a body, by the number of border edges of their triangles. Scans of
  /// trees are an example; `extract_tree_skeleton()` is for them.
  bool is_surface_doubtful() const { return m_is_surface_doubtful; }

private:
  /// With more border edges for each point, the surface is doubtful: of the 173 right ones of 208 clouds of surfaces,
  /// one has more, scans of trees and parts of them have more than 0.3.
  static constexpr double doubtful_border_edges = 0.28;
  /// With more cuts for each point, the skeleton is doubtful: of 173 clouds whose skeleton is right one has more, of 35
  /// others 14.
  static constexpr double doubtful_cuts = 0.0015;

  void describe(const Reconstruction_report& made)
  {
    const std::size_t number_of_points = made.number_of_sampled_points() - made.number_of_outliers;
    m_is_surface_doubtful = double(made.number_of_border_edges) > doubtful_border_edges * double(number_of_points);
    Skeletonization_report& report = this->m_report;
    report.warnings.clear(); // about the surface, which is not the input
    report.number_of_input_vertices = this->m_descriptors.number_of_values();
    report.number_of_bridged_borders = made.number_of_holes;
    report.reconstruction = made;
    if (m_is_surface_doubtful) {
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
  }

  bool m_is_surface_doubtful = false;
};

} // namespace CSCD

#endif // CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H
