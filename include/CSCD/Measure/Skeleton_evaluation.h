// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Evaluates a skeleton against its body.

#ifndef CSCD_MEASURE_SKELETON_EVALUATION_H
#define CSCD_MEASURE_SKELETON_EVALUATION_H

#include <CSCD/Measure/Isosurface_tracker.h>
#include <CSCD/Measure/Measured_body.h>
#include <CSCD/Measure/Position_measurement.h>
#include <CSCD/Measure/Segment_bvh.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/estimate_radii.h>
#include <CSCD/Measure/reconstruction_fields.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/double.h>
#include <CGAL/float.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Measures from the reconstruction to the input, at the centres of faces, weighted by their areas. Of many faces some
/// are chosen: one of each stretch of the numbering, at a place that goes with the golden ratio, so that the pattern in
/// which a cell's faces follow each other has no say.
template <class Distance>
void measure_reverse(const Triangulated_surface& surface, const Distance& distance_to_input,
                     Reconstruction_error& error)
{
  constexpr std::size_t enough_faces = 25000; // for a mean that is right to one percent
  const std::size_t number_of_faces = surface.number_of_faces();
  const std::size_t number_of_samples = std::min(number_of_faces, enough_faces);
  const double stretch = double(number_of_faces) / double(number_of_samples);
  double total_area = 0;
  double sum = 0;
  error.reverse_maximum = 0;
  double place = 0;
  for (std::size_t i = 0; i < number_of_samples; ++i) {
    const auto f = Index(std::min<double>((double(i) + place) * stretch, double(number_of_faces - 1)));
    place += boost::math::double_constants::phi;
    place -= std::floor(place);
    const Vector_3 center = (surface.point(surface.origin(3 * f)) + surface.point(surface.target(3 * f)) +
                             surface.point(surface.opposite_vertex(3 * f))) /
                            3;
    const double area = surface.face_vector(f).norm() / 2;
    const double distance = distance_to_input(center);
    total_area += area;
    sum += area * distance;
    error.reverse_maximum = std::max(error.reverse_maximum, distance);
  }
  error.reverse_mean = sum / total_area;
}

/// Measures the distances between `points`, those of the input, and the faces of `reconstruction`, both ways.
/// O((p + f) log f) for p points and f faces.
/// \param distance_to_input gives the distance of a point from the input
template <class Distance>
Reconstruction_error measure_reconstruction(Field_surface&& reconstruction, const std::vector<Vector_3>& points,
                                            const Distance& distance_to_input)
{
  Reconstruction_error error;
  error.unresolved_fraction = reconstruction.unresolved_fraction;
  error.cell_size = reconstruction.cell_size;
  error.number_of_faces = reconstruction.triangles.faces.size();
  if (error.number_of_faces == 0) {
    return error;
  }
  const Triangulated_surface surface(std::move(reconstruction.triangles));
  CGAL_assertion(!surface.defect());
  const Solid_queries queries(surface);
  double sum = 0;
  double sum_of_squares = 0;
  error.maximum = 0;
  Index near = no_index;
  for (const Vector_3& point : points) {
    const Surface_point nearest = queries.closest_point(point, near);
    near = nearest.face;
    const double square = (nearest.point - point).squaredNorm();
    sum += std::sqrt(square);
    sum_of_squares += square;
    error.maximum = std::max(error.maximum, std::sqrt(square));
  }
  error.mean = sum / double(points.size());
  error.mean_square = sum_of_squares / double(points.size());
  measure_reverse(surface, distance_to_input, error);
  return error;
}

} // namespace CSCD::internal

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
    std::vector<Segment_bvh::Segment> segments;
    segments.reserve(m_points.size());
    for (const Vector_3& point : m_points) {
      segments.push_back({point, point});
    }
    m_tree = Segment_bvh(std::move(segments));
  }

  const Normalization& normalization() const { return m_normalization; }
  const std::vector<Vector_3>& points() const { return m_points; }
  double distance(const Vector_3& point) const { return m_tree.nearest(point).distance; }

private:
  std::vector<Vector_3> m_points;
  Normalization m_normalization;
  Segment_bvh m_tree;
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
  static constexpr double max_length = 2;

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
      if (!(point.norm() <= max_length)) {
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
      if (!(radius >= 0 && radius <= max_length)) {
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

namespace CSCD::internal {

/// Refuses at compile time named parameters that do not apply to a surface of this type, nor are among `MoreTags`.
template <class Surface, class NamedParameters, class... MoreTags>
constexpr void check_evaluation_parameters()
{
  if constexpr (is_triangle_mesh_v<Surface>) {
    check_triangle_mesh<Surface>();
    check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t, internal_np::resolution_t,
                           internal_np::use_skeleton_radii_t, MoreTags...>();
  } else {
    check_named_parameters<NamedParameters, CGAL::internal_np::point_t, internal_np::resolution_t,
                           internal_np::use_skeleton_radii_t, MoreTags...>();
  }
}

template <class NamedParameters>
Evaluation_parameters evaluation_parameters(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Evaluation_parameters result;
  result.uses_skeleton_radii =
      choose_parameter(get_parameter(np, internal_np::use_skeleton_radii), result.uses_skeleton_radii);
  result.resolution = std::size_t(choose_parameter(get_parameter(np, internal_np::resolution), result.resolution));
  return result;
}

/// Prepares a mesh or a range of points for measuring.
template <class Surface, class NamedParameters>
auto measured_input(const Surface& surface, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  if constexpr (is_triangle_mesh_v<Surface>) {
    if constexpr (is_default_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>::value) {
      return std::make_unique<const Measured_body>(surface, get(CGAL::vertex_point, surface));
    } else {
      return std::make_unique<const Measured_body>(surface, get_parameter(np, CGAL::internal_np::vertex_point));
    }
  } else {
    const auto to_vector = [](const auto& point) {
      return Vector_3(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
    };
    std::vector<Vector_3> points;
    for (const auto& element : surface) {
      if constexpr (is_default_parameter<NamedParameters, CGAL::internal_np::point_t>::value) {
        points.push_back(to_vector(element));
      } else {
        points.push_back(to_vector(get(get_parameter(np, CGAL::internal_np::point_map), element)));
      }
    }
    return std::make_unique<const Measured_cloud>(std::move(points));
  }
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_SKELETON_EVALUATION_H
