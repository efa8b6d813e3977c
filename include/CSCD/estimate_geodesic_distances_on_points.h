// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances on a point set: in one call, or prepared once and estimated from many sources.

#ifndef CSCD_ESTIMATE_GEODESIC_DISTANCES_ON_POINTS_H
#define CSCD_ESTIMATE_GEODESIC_DISTANCES_ON_POINTS_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Published/Prepared_distances.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// Geodesic distances on a surface that is given by points, by the heat method. No surface is reconstructed: the points
/// are joined by the triangles that are Delaunay in the tangent planes of their corners, and heat flows on the tufted
/// cover of these triangles (N. Sharp, K. Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020), which is made
/// intrinsically Delaunay. Where the surface is not sampled, the triangles leave holes; where two sheets are nearer to
/// each other than the points, they may be joined.
///
/// The points are prepared once; then every set of sources costs two pairs of triangular solves, and eight sets
/// together as much as three alone. doc/geodesics.md has figures of accuracy. Results do not depend on the order of the
/// points. The members that estimate are const and may be called by several threads at once.
/// \tparam PointRange a range over points or over elements that a point map maps to points, or a `CGAL::Point_set_3`
template <class PointRange>
class Point_set_distance_estimator
{
public:
  /// \name Types
  /// @{

  /// The identifier of a point: its index in a `CGAL::Point_set_3`, else its number in the order of iteration, as
  /// `std::size_t`.
  using Point_descriptor = CSCD::Point_descriptor<PointRange>;
  /// @}

  /// Prepares `points`, which are not referred to later; O(n^1.5), and usually nearly linear.
  /// \param points at least four points, not all on a line
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{point_map}
  ///     \cgalParamDescription{the points of the elements of `points`}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
  ///     \cgalParamDefault{`points.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{normal_map}
  ///     \cgalParamDescription{normals of the surface at the points, of any length and of either orientation}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
  ///     \cgalParamDefault{`points.normal_map()` for a `CGAL::Point_set_3` that has normals, else none}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// `time_step_factor` is as for a mesh.
  ///
  /// \throw Input_error naming the point and the remedy if a coordinate is not finite, or if the points do not sample a
  ///        surface: fewer than four different ones, all on a line, none of them joined
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Point_set_distance_estimator(const PointRange& points,
                                        const NamedParameters& np = parameters::default_values())
      : Point_set_distance_estimator(
            points, internal::collect_points_of(points, np),
            double(parameters::choose_parameter(parameters::get_parameter(np, internal_np::time_step_factor), 1.)))
  {
    internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t, CGAL::internal_np::normal_t,
                                     internal_np::time_step_factor_t>();
  }

  /// Writes the distance of every point from the nearest one of `sources` to `distances`: 0 for sources and duplicates
  /// of them, infinity for points that no path joins to a source, outliers among them.
  /// \param sources a range of descriptors of points
  /// \param distances a model of `WritablePropertyMap` with the descriptor of a point as key and a value assignable
  ///        from `double`
  /// \pre the sources are descriptors of points
  template <class SourceRange, class PointDistanceMap>
  void estimate(const SourceRange& sources, PointDistanceMap distances) const
  {
    m_distances.estimate_each({collect_sources(sources)},
                              [&](const std::vector<double>& field) { write(field, distances); });
  }

  /// Writes the distances from each of `source_sets` by itself to the one of `distance_maps` with the same number:
  /// exactly the values that one call of `estimate()` for each of them writes, in about a third of the time.
  /// \param source_sets a range of ranges of descriptors of points
  /// \param distance_maps a range of maps
  /// \pre there are as many maps as sets
  template <class SourceSetRange, class DistanceMapRange>
  void estimate_each(const SourceSetRange& source_sets, const DistanceMapRange& distance_maps) const
  {
    std::vector<std::vector<internal::Distance_source>> collected;
    for (const auto& sources : source_sets) {
      collected.push_back(collect_sources(sources));
    }
    auto map = std::begin(distance_maps);
    m_distances.estimate_each(collected, [&](const std::vector<double>& field) {
      CGAL_precondition(map != std::end(distance_maps));
      write(field, *map++);
    });
  }

private:
  Point_set_distance_estimator(const PointRange& points, Point_cloud&& cloud, double time_step_factor)
      : m_unit(cloud.normalization.unit), m_distances(cloud, time_step_factor), m_vertex(std::move(cloud.input_point)),
        m_numbering(points)
  {
    CGAL_precondition(time_step_factor > 0);
  }

  template <class SourceRange>
  std::vector<internal::Distance_source> collect_sources(const SourceRange& sources) const
  {
    std::vector<internal::Distance_source> result;
    for (const auto& source : sources) {
      const Index number = m_numbering.number(source);
      CGAL_precondition(number != no_index);
      result.push_back({m_vertex[number], no_index, {}});
    }
    return result;
  }

  template <class PointDistanceMap>
  void write(const std::vector<double>& field, PointDistanceMap distances) const
  {
    for (Index i = 0; i < m_vertex.size(); ++i) {
      put(distances, m_numbering.descriptors[i], m_unit * std::max(field[m_vertex[i]], 0.));
    }
  }

  double m_unit;
  internal::Prepared_distances m_distances;
  std::vector<Index> m_vertex; // of the complex, for every point in the order of iteration
  internal::Point_numbering<PointRange> m_numbering;
};

/// estimates the geodesic distance of every point of a set from the nearest one of some sources, along the surface that
/// the points sample.
///
/// See `Point_set_distance_estimator` for the accuracy and the cost. Use that class for distances from several sets of
/// sources: nearly all the time of this function goes into preparing the points.
///
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \tparam Sources the descriptor of a point, or a range of them: its index in a `CGAL::Point_set_3`, for other ranges
///         its number in the order of iteration
/// \tparam PointDistanceMap a model of `WritablePropertyMap` with the descriptor of a point as key and a value
///         assignable from `double`
/// \param points at least four points, not all on a line
/// \param sources the points at distance 0
/// \param distances gets 0 for sources, infinity for points that no path joins to a source; if the function throws, it
///        is left as it was
/// \param np an optional sequence of named parameters: `point_map`, `normal_map` and `time_step_factor`, as
///        `Point_set_distance_estimator` has them
/// \throw Input_error if a coordinate is not finite, or the points do not sample a surface; the message names the point
///        and the remedy
/// \pre the sources are descriptors of points
template <class PointRange, class Sources, class PointDistanceMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void estimate_geodesic_distances(const PointRange& points, const Sources& sources, PointDistanceMap distances,
                                 const NamedParameters& np = parameters::default_values())
{
  using Estimator = Point_set_distance_estimator<PointRange>;
  using Descriptor = typename Estimator::Point_descriptor;
  const Estimator estimator(points, np);
  if constexpr (std::is_convertible_v<const Sources&, Descriptor>) {
    estimator.estimate(std::array<Descriptor, 1>{Descriptor(sources)}, distances);
  } else {
    estimator.estimate(sources, distances);
  }
}

} // namespace CSCD

#endif // CSCD_ESTIMATE_GEODESIC_DISTANCES_ON_POINTS_H
