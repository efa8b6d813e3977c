// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface through points, as the skeletonization sees it.

#ifndef CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H
#define CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H

#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Traits/Surface_adapter.h>

#include <boost/property_map/property_map.hpp>

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
    internal::Reconstruction made = internal::reconstruct_surface(
        internal::collect_points(points, point_map, normal_map), number_of_threads, this->m_surface);
    this->m_normalization = made.normalization;
    this->m_report = std::move(made.report);
    this->describe(internal::descriptors_of(points), made.vertex_of_point);
    m_is_surface_doubtful = made.is_surface_doubtful;
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
  bool m_is_surface_doubtful = false;
};

} // namespace CSCD

#endif // CSCD_TRAITS_RECONSTRUCTED_SURFACE_TRAITS_H
