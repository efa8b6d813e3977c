// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures a skeleton against a mesh or points.

#include "Measure/body_measures.h"
#include "Measure/reconstruction.h"
#include "Measure/skeleton_tools.h"
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Surface/refine_large_faces.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {
namespace {

/// Moves the center of the bounding box of `points` to the origin and scales its diagonal to 1; linear.
/// \pre `points` is not empty and all coordinates are finite
/// \throw Input_error if all points are equal, or their extent is out of the range that can be computed with
Normalization normalize_diagonal(std::vector<Vector3>& points)
{
  const Normalization to_cube = normalize_extent(points);
  const Normalization to_diagonal{Vector3::Zero(),
                                  2 * Bounding_box(points).max().norm()}; // the box is centered already
  normalize(points, to_diagonal);
  return to_cube.then(to_diagonal);
}

/// Gives the nodes that `is_known` leaves out the radii of the harmonic function on the edges, weighted by the
/// reciprocals of their lengths, that has the known radii: along a branch it is linear in length. Where nothing is
/// known in a connected part, radii are `default_radius`. \throw Input_error if there are too many cycles
void interpolate_radii(const Skeleton& skeleton, std::vector<char> is_known, double default_radius,
                       std::vector<double>& radii)
{
  Disjoint_sets parts(radii.size(), skeleton.edges);
  std::vector<char> has_known(radii.size(), 0);
  for (Index v = 0; v < radii.size(); ++v) {
    has_known[parts.find(v)] = has_known[parts.find(v)] != 0 || is_known[v] != 0 ? 1 : 0;
  }
  std::vector<int> place(radii.size(), -1); // of unknown nodes, in the system of equations
  std::vector<Index> nodes;
  for (Index v = 0; v < radii.size(); ++v) {
    if (has_known[parts.find(v)] == 0) {
      radii[v] = default_radius;
    } else if (is_known[v] == 0) {
      place[v] = int(nodes.size());
      nodes.push_back(v);
    }
  }
  constexpr std::size_t max_number_of_cycles = 1 << 11; // factors have at most the square of it more entries
  if (skeleton.edges.size() > skeleton.number_of_nodes() + max_number_of_cycles) {
    throw Input_error("the skeleton has more than 2048 cycles, too many to estimate its radii: simplify it first");
  }
  if (nodes.empty()) {
    return;
  }
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(Eigen::Index(nodes.size()));
  for (int i = 0; i < int(nodes.size()); ++i) {
    const Index v = nodes[std::size_t(i)];
    for (const Index w : neighbors[v]) {
      if (w == v) {
        continue;
      }
      constexpr double min_length = 1e-9; // in the coordinates of the skeleton: equal nodes have equal radii
      const double weight = 1 / std::max(skeleton.length({w, v}), min_length);
      entries.emplace_back(i, i, weight);
      if (place[w] >= 0) {
        entries.emplace_back(i, place[w], -weight);
      } else {
        right[i] += weight * radii[w];
      }
    }
  }
  Eigen::SparseMatrix<double> laplacian(right.size(), right.size());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(right);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    radii[nodes[i]] = std::max(solution[Eigen::Index(i)], 0.);
  }
}

} // namespace

std::vector<double> estimate_radii(const std::vector<Vector3>& points, const Skeleton& skeleton)
{
  CGAL_precondition(!points.empty() && skeleton.number_of_nodes() > 0);
  const Segment_tree tree(skeleton);
  std::vector<double> radii(skeleton.number_of_nodes(), 0.);
  std::vector<double> weight(skeleton.number_of_nodes(), 0.);
  double total = 0;
  for (const Vector3& point : points) {
    const Segment_point nearest = tree.nearest(point);
    const double t = nearest.parameter;
    const auto& [source, target] = tree.segments()[nearest.segment];
    radii[source] += (1 - t) * nearest.distance;
    weight[source] += 1 - t;
    radii[target] += t * nearest.distance;
    weight[target] += t;
    total += nearest.distance;
  }
  constexpr double min_weight = 1e-9; // in points
  std::vector<char> is_known(radii.size(), 0);
  for (std::size_t v = 0; v < radii.size(); ++v) {
    is_known[v] = weight[v] > min_weight ? 1 : 0;
    radii[v] = is_known[v] != 0 ? radii[v] / weight[v] : 0;
  }
  interpolate_radii(skeleton, std::move(is_known), total / double(points.size()), radii);
  return radii;
}

namespace {

/// The surface that a skeleton is measured against, a mesh or points; the diagonal of the bounding box is 1.
class Measured_surface
{
public:
  /// Near linear.
  /// \throw Input_error if a mesh has no extent, or if points are missing, not finite, or all equal
  explicit Measured_surface(Checked_triangles&& input)
  {
    if (!input.triangles.faces.empty()) {
      bound_body(std::move(input.triangles), std::move(input.pairing));
      return;
    }
    points = std::move(input.triangles.points);
    if (points.empty()) {
      throw Input_error("the input has no points to measure the skeleton against: check how it was read");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].allFinite()) {
        throw Input_error("point " + std::to_string(i) +
                          " has a coordinate that is not finite: correct it or remove the point");
      }
    }
    normalization = normalize_diagonal(points);
    m_tree.emplace(points);
  }

  Measured_surface(const Measured_surface&) = delete; // the queries refer to the surface
  Measured_surface& operator=(const Measured_surface&) = delete;
  ~Measured_surface() = default;

  /// The distance of a point; neighboring points are answered faster one after the other.
  double distance(const Vector3& point)
  {
    if (queries) {
      const Surface_point nearest = queries->closest_point(point, m_near);
      m_near = nearest.face;
      return (nearest.point - point).norm();
    }
    return (points[m_tree->nearest(point)] - point).norm();
  }

  Normalization normalization;
  std::vector<Vector3> points;          ///< of a mesh, the vertices that have a face, neighbors near each other
  std::size_t number_of_components = 0; ///< of a mesh, as all that follow
  std::size_t number_of_borders = 0;    ///< before they were bridged
  Triangulated_surface surface;         ///< closed
  std::optional<Solid_queries> queries; ///< none for points

private:
  /// Bridges the borders of a mesh, so that there is a body, and turns components that face inwards.
  void bound_body(Indexed_triangles&& triangles, Halfedge_pairing&& pairing)
  {
    normalization = normalize_diagonal(triangles.points);
    std::size_t number_of_points = triangles.points.size();
    number_of_borders = bridge_borders(triangles, pairing);
    if (pairing.has_border()) {
      pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
    }
    Surface_components components(triangles);
    number_of_points -= fill_cavities(triangles, pairing, components, number_of_points).vertices.size();
    if (orient_outwards(triangles, components) > 0) {
      pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
    }
    split_two_face_components(triangles, pairing, components);
    number_of_components = components.number();
    // Vertices with near numbers should be near in space, for the queries' sake.
    const std::vector<Index> order = canonical_order(triangles, pairing, components);
    points.reserve(number_of_points);
    for (const Index vertex : order) {
      if (vertex < number_of_points) {
        points.push_back(triangles.points[vertex]);
      }
    }
    renumber(triangles, order);
    surface = Triangulated_surface(std::move(triangles));
    CGAL_postcondition(!surface.has_defect());
    queries.emplace(surface);
  }

  std::optional<Point_tree> m_tree; ///< none for a mesh
  Index m_near = no_index;          ///< the face of the last answer
};

/// Measures how much the branches turn: the sum of the turning angles at nodes of two edges, over the length of the
/// edges that touch such nodes, half for each end, in local radii.
void measure_turning(const Skeleton& skeleton, Skeleton_counts& counts)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  double sum = 0;
  double length = 0; // in radii
  for (std::size_t v = 0; v < neighbors.size(); ++v) {
    if (neighbors[v].size() != 2) {
      continue;
    }
    const Vector3 before = skeleton.points[v] - skeleton.points[neighbors[v][0]];
    const Vector3 after = skeleton.points[neighbors[v][1]] - skeleton.points[v];
    const double angle = std::atan2(before.cross(after).norm(), before.dot(after)); // 0 if two of the points are equal
    counts.max_turning = std::fmax(counts.max_turning, angle);
    if (skeleton.radii[v] > 0) {
      sum += angle;
      length += (before.norm() + after.norm()) / 2 / skeleton.radii[v];
    }
  }
  if (length > 0) {
    counts.mean_turning = sum / length;
  }
}

/// Measures from the reconstruction to the input, at the centers of faces, weighted by their areas. Of many faces some
/// are chosen: one of each stretch of the numbering, at a place that follows the golden ratio, so that the sequence of
/// the faces of a cell does not matter.
void measure_reverse(const Triangulated_surface& surface, Measured_surface& measured, Reconstruction_error& error)
{
  constexpr std::size_t enough_faces = 50000; // for a mean that is right to one percent
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
    const Vector3 center = (surface.point(surface.origin(3 * f)) + surface.point(surface.target(3 * f)) +
                            surface.point(surface.opposite_vertex(3 * f))) /
                           3;
    const double area = surface.face_vector(f).norm() / 2;
    const double distance = measured.distance(center);
    total_area += area;
    sum += area * distance;
    error.reverse_maximum = std::max(error.reverse_maximum, distance);
  }
  error.reverse_mean = sum / total_area;
}

/// Measures the distances between the points of the input and the faces of `reconstruction`, both ways.
/// O((p + f) log f) for p points and f faces.
Reconstruction_error measure_reconstruction(Field_surface&& reconstruction, Measured_surface& measured)
{
  Reconstruction_error error;
  error.unresolved_fraction = reconstruction.unresolved_fraction;
  error.cell_size = reconstruction.cell_size;
  error.number_of_faces = reconstruction.triangles.faces.size();
  if (error.number_of_faces == 0) {
    return error;
  }
  const Triangulated_surface surface(std::move(reconstruction.triangles));
  CGAL_assertion(!surface.has_defect());
  const Solid_queries queries(surface);
  double sum = 0;
  double sum_of_squares = 0;
  error.maximum = 0;
  Index near = no_index;
  for (const Vector3& point : measured.points) {
    const Surface_point nearest = queries.closest_point(point, near);
    near = nearest.face;
    const double square = (nearest.point - point).squaredNorm();
    sum += std::sqrt(square);
    sum_of_squares += square;
    error.maximum = std::max(error.maximum, std::sqrt(square));
  }
  error.mean = sum / double(measured.points.size());
  error.mean_square = sum_of_squares / double(measured.points.size());
  measure_reverse(surface, measured, error);
  return error;
}

/// Nodes farther than this from the center of the bounding box, and radii greater than this, in its diagonals, cannot
/// belong to the surface.
constexpr double max_length = 2;

/// Maps the nodes to the coordinates of a surface. \throw Input_error if one is not finite or far from the surface
void place_nodes(const Normalization& normalization, Skeleton& skeleton)
{
  if (skeleton.number_of_nodes() == 0) {
    throw Input_error("the skeleton has no nodes: there is nothing to measure");
  }
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    check_finite(skeleton, v);
    skeleton.points[v] = normalization.from_input(skeleton.points[v]);
    if (!(skeleton.points[v].norm() <= max_length)) {
      fail_at_node(v, "is far from the surface: check that both have the same unit and place");
    }
  }
}

/// Maps the radii. \throw Input_error if they are missing, 0, or one is negative, not finite or too large
void place_radii(const Normalization& normalization, Skeleton& skeleton)
{
  if (!skeleton.has_radii()) {
    throw Input_error("the skeleton has no radii: estimate them, by --radii estimated or without use_skeleton_radii");
  }
  double sum = 0;
  for (std::size_t v = 0; v < skeleton.radii.size(); ++v) {
    double& radius = skeleton.radii[v];
    radius /= normalization.unit;
    if (!(radius >= 0 && radius <= max_length)) {
      fail_at_node(v, "has a radius that is negative, not finite or too large for the surface: let radii be "
                      "estimated");
    }
    sum += radius;
  }
  if (!(sum > 0)) {
    throw Input_error("all radii of the skeleton are 0: let them be estimated");
  }
}

/// Checks that there will be an answer within minutes.
void check_size(const Skeleton& skeleton, std::size_t resolution)
{
  constexpr std::size_t max_size = std::size_t(1) << 18; // fields are sums over all edges
  constexpr std::size_t max_resolution = 10000;          // cells along the diagonal of the bounding box
  if (skeleton.number_of_nodes() + skeleton.edges.size() > max_size) {
    throw Input_error("the skeleton has more than 2^18 nodes and edges: resample it with a greater spacing first");
  }
  if (resolution == 0 || resolution > max_resolution) {
    throw Input_error("the resolution is not in [1, 10000]: 200 will do in most cases");
  }
}

} // namespace

Skeleton_measures evaluate_skeleton(Checked_triangles&& input, Skeleton&& skeleton,
                                    const Evaluation_parameters& parameters)
{
  Measured_surface measured(std::move(input));
  check_size(skeleton, parameters.resolution);
  place_nodes(measured.normalization, skeleton);
  if (parameters.uses_skeleton_radii) {
    place_radii(measured.normalization, skeleton);
  } else {
    skeleton.radii = estimate_radii(measured.points, skeleton);
  }
  Skeleton_measures result;
  result.number_of_points = measured.points.size();
  result.diagonal = measured.normalization.unit;
  result.counts = count_skeleton(skeleton);
  measure_turning(skeleton, result.counts);
  const double cell_size = 1 / double(parameters.resolution);
  result.convolution =
      measure_reconstruction(triangulate_field(Convolution_field(skeleton), skeleton, cell_size), measured);
  const Round_cone_field field(skeleton);
  result.round_cones = measure_reconstruction(triangulate_field(field, skeleton, cell_size), measured);
  double sum = 0;
  for (const Vector3& point : measured.points) {
    sum += std::abs(field(point));
  }
  result.mean_distance_from_round_cones = sum / double(measured.points.size());
  if (measured.queries) {
    result.position = measure_position(*measured.queries, skeleton);
    result.position.number_of_surface_components = measured.number_of_components;
    result.position.genus = genus_of_closed_surface(
        measured.number_of_components, measured.surface.number_of_vertices(), measured.surface.number_of_faces());
    result.position.number_of_borders = measured.number_of_borders;
    result.limbs = measure_limbs(measured.surface, *measured.queries, skeleton);
    for (Surface_limb& limb : result.limbs.limbs) {
      limb.tip = measured.normalization.to_input(limb.tip);
    }
  }
  return result;
}

} // namespace CSCD::internal
