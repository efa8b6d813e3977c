// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton beside the surface that it is measured against, in common coordinates.

#ifndef CSCD_MEASURE_SKELETON_EVALUATION_H
#define CSCD_MEASURE_SKELETON_EVALUATION_H

#include <CSCD/Measure/Convolution_field.h>
#include <CSCD/Measure/Measured_body.h>
#include <CSCD/Measure/Position_measurement.h>
#include <CSCD/Measure/Round_cone_field.h>
#include <CSCD/Measure/Segment_tree.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/count_skeleton.h>
#include <CSCD/Measure/estimate_radii.h>
#include <CSCD/Measure/measure_reconstruction.h>
#include <CSCD/Measure/normalize_diagonal.h>
#include <CSCD/Measure/triangulate_field.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Traits/Normalization.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Vector_3.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// How a surface is made of a skeleton with radii.
enum class Reconstruction_method
{
  convolution, ///< convolution with the inverse quartic kernel, see `doc/measures.md`
  round_cones  ///< union of the convex hulls of the two balls of each edge
};

namespace internal {

/// The points of a cloud, and how far a point is from them.
class Measured_cloud
{
public:
  /// \throw Input_error if there are no points, or not finite ones, or all are equal
  explicit Measured_cloud(std::vector<Vector_3> points) : m_points(std::move(points)), m_tree({})
  {
    if (m_points.empty()) {
      throw Input_error("there are no points to measure the skeleton against: check how the input was read");
    }
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      if (!m_points[i].allFinite()) {
        throw Input_error("point " + std::to_string(i) +
                          " has a coordinate that is not finite: correct it or remove the point");
      }
    }
    m_normalization = normalize_diagonal(m_points);
    std::vector<Segment_tree::Segment> segments;
    segments.reserve(m_points.size());
    for (const Vector_3& point : m_points) {
      segments.push_back({point, point});
    }
    m_tree = Segment_tree(std::move(segments));
  }

  const Normalization& normalization() const { return m_normalization; }
  const std::vector<Vector_3>& points() const { return m_points; }
  double distance(const Vector_3& point) const { return m_tree.nearest(point).distance; }

private:
  std::vector<Vector_3> m_points;
  Normalization m_normalization;
  Segment_tree m_tree;
};

/// The distance of `point` from the input.
/// \param near what the last call left; neighbouring points are answered faster one after the other
inline double distance_to(const Measured_cloud& cloud, const Vector_3& point, Index& /* near */)
{
  return cloud.distance(point);
}

inline double distance_to(const Measured_body& body, const Vector_3& point, Index& near)
{
  const Surface_point nearest = body.queries().closest_point(point, near);
  near = nearest.face;
  return (nearest.point - point).norm();
}

/// Where radii come from, and how fine the reconstructed surfaces are.
struct Evaluation_parameters
{
  bool uses_skeleton_radii = false;
  std::size_t resolution = 200; ///< cells of the lattice along the diagonal of the bounding box
};

/// A skeleton in the coordinates of a `Measured_body` or a `Measured_cloud`, with radii.
template <class Measured>
class Skeleton_evaluation
{
public:
  /// \param measured is referred to
  /// \throw Input_error if the skeleton has no nodes, a node that is not finite or far from the surface, or if its own
  ///        radii are asked for and it has none
  Skeleton_evaluation(const Measured& measured, Indexed_skeleton skeleton, const Evaluation_parameters& parameters)
      : m_measured(measured), m_skeleton(std::move(skeleton)), m_resolution(parameters.resolution)
  {
    if (m_resolution == 0 || m_resolution > maximum_resolution) {
      throw Input_error("the resolution is not in [1, 10000]: 200 will do in most cases");
    }
    place_nodes();
    if (parameters.uses_skeleton_radii) {
      place_radii();
    } else {
      m_skeleton.radii = estimate_radii(m_measured.points(), m_skeleton);
    }
  }

  const Indexed_skeleton& skeleton() const { return m_skeleton; }

  /// The surface that the skeleton describes, in common coordinates.
  Field_surface reconstruct(Reconstruction_method method) const
  {
    const double cell_size = 1 / double(m_resolution);
    return method == Reconstruction_method::convolution
               ? triangulate_field(Convolution_field(m_skeleton), m_skeleton, cell_size)
               : triangulate_field(Round_cone_field(m_skeleton), m_skeleton, cell_size);
  }

  /// All measures but those of the position.
  Skeleton_measures measure() const
  {
    Index near = no_index;
    const auto distance = [this, &near](const Vector_3& point) { return distance_to(m_measured, point, near); };
    Skeleton_measures result;
    result.number_of_points = m_measured.points().size();
    result.diagonal = m_measured.normalization().unit;
    result.counts = count_skeleton(m_skeleton, m_skeleton.radii);
    result.convolution =
        measure_reconstruction(reconstruct(Reconstruction_method::convolution), m_measured.points(), distance);
    result.round_cones =
        measure_reconstruction(reconstruct(Reconstruction_method::round_cones), m_measured.points(), distance);
    const Round_cone_field field(m_skeleton);
    double sum = 0;
    for (const Vector_3& point : m_measured.points()) {
      sum += std::abs(field(point));
    }
    result.mean_distance_from_round_cones = sum / double(m_measured.points().size());
    return result;
  }

private:
  static constexpr std::size_t maximum_resolution = 10000;
  /// Nodes farther than this from the centre of the bounding box, and radii greater than this, in its diagonals, cannot
  /// belong to the surface.
  static constexpr double largest_length = 2;

  void place_nodes()
  {
    if (m_skeleton.number_of_nodes() == 0) {
      throw Input_error("the skeleton has no nodes: there is nothing to measure");
    }
    for (std::size_t v = 0; v < m_skeleton.number_of_nodes(); ++v) {
      Vector_3& point = m_skeleton.points[v];
      if (!point.allFinite()) {
        throw Input_error("node " + std::to_string(v) +
                          " of the skeleton has a coordinate that is not finite: "
                          "correct it or remove the node");
      }
      point = m_measured.normalization().from_input(point);
      if (!(point.norm() <= largest_length)) {
        throw Input_error("node " + std::to_string(v) +
                          " of the skeleton is far from the surface: check that both have the same unit and place");
      }
    }
  }

  void place_radii()
  {
    if (!m_skeleton.has_radii()) {
      throw Input_error("the skeleton has no radii of its own: let them be estimated");
    }
    double sum = 0;
    for (std::size_t v = 0; v < m_skeleton.radii.size(); ++v) {
      double& radius = m_skeleton.radii[v];
      radius /= m_measured.normalization().unit;
      if (!(radius >= 0 && radius <= largest_length)) {
        throw Input_error("node " + std::to_string(v) +
                          " of the skeleton has a radius that is negative, not finite or "
                          "too large for the surface: let radii be estimated");
      }
      sum += radius;
    }
    if (!(sum > 0)) {
      throw Input_error("all radii of the skeleton are 0: let them be estimated");
    }
  }

  const Measured& m_measured;
  Indexed_skeleton m_skeleton;
  std::size_t m_resolution;
};

} // namespace internal
} // namespace CSCD

#endif // CSCD_MEASURE_SKELETON_EVALUATION_H
