// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in flat arrays, in an order that does not depend on that of the input.

#ifndef CSCD_SURFACE_POINT_CLOUD_H
#define CSCD_SURFACE_POINT_CLOUD_H

#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/double.h>
#include <CGAL/float.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/number_utils.h>

#include <Eigen/Eigenvalues>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The similarity that puts the centroid of points to the origin, turns their principal axes to those of the
/// coordinates, each towards where the third moment is positive, and makes the mean squared distance from the
/// centroid 1. What it yields does not change, up to rounding and but for clouds with a symmetry, when the points are
/// moved, turned or scaled.
class Canonical_pose
{
public:
  Canonical_pose() = default;

  /// Finds the pose of `points`; linear.
  /// \pre the points are not all equal, and their extent is about 1
  explicit Canonical_pose(const std::vector<Vector_3>& points)
  {
    const double size = double(points.size());
    for (const Vector_3& point : points) {
      m_centroid += point / size;
    }
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Vector_3& point : points) {
      moments += (point - m_centroid) * (point - m_centroid).transpose() / size;
    }
    // The iterative solver is exact to rounding, unlike the direct one.
    m_rotation = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().transpose();
    m_scale = 1 / std::sqrt(moments.trace());
    Vector_3 third_moments = Vector_3::Zero();
    for (const Vector_3& point : points) {
      third_moments += (*this)(point).array().cube().matrix();
    }
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      if (third_moments[axis] < 0) {
        m_rotation.row(axis) *= -1;
      }
    }
    if (m_rotation.determinant() < 0) {
      m_rotation.row(2) *= -1; // a turn, not a reflection
    }
  }

  Vector_3 operator()(const Vector_3& point) const { return m_scale * (m_rotation * (point - m_centroid)); }
  Vector_3 turn(const Vector_3& direction) const { return m_rotation * direction; }
  Vector_3 turn_back(const Vector_3& direction) const { return m_rotation.transpose() * direction; }
  double scale() const { return m_scale; }

private:
  Vector_3 m_centroid = Vector_3::Zero();
  Eigen::Matrix3d m_rotation = Eigen::Matrix3d::Identity();
  double m_scale = 1;
};

/// A vector with coordinates in [-1, 1] that depends on the number of the point alone.
inline Vector_3 pseudo_random_vector(Index point)
{
  std::minstd_rand random(point + 1);
  random.discard(2); // the first numbers of neighboring seeds are alike
  Vector_3 result = Vector_3::Zero();
  for (double& coordinate : result) {
    coordinate = 2 * double(random()) / double(std::minstd_rand::max()) - 1;
  }
  return result;
}

/// With more points than this the halfedges of the surface could no longer be indexed.
inline constexpr std::size_t maximum_number_of_points = std::size_t(1) << 26;

/// A surface around a body needs at least this many points.
inline constexpr std::size_t minimum_number_of_points = 4;

/// Points at different places in the cube [-1, 1]^3, in an order that does not depend on that of the input.
struct Point_cloud
{
  std::vector<Vector_3> points;
  std::vector<Vector_3> normals;  ///< of unit length, zero where unknown; empty if the input has none
  std::vector<Index> input_point; ///< for every point of the input, the point that stands for it
  Normalization normalization;
  Canonical_pose pose; ///< of the points

  std::size_t number_of_duplicates() const { return input_point.size() - points.size(); }
};

/// Stands for a map to normals where there are none.
struct No_normals
{
};

/// The coordinates of a point or vector of any type.
template <class Triple>
Vector_3 to_vector_3(const Triple& triple)
{
  return {CGAL::to_double(triple.x()), CGAL::to_double(triple.y()), CGAL::to_double(triple.z())};
}

/// Sorts a cloud of different points in their canonical pose: so the numbers do not depend on the pose. Along a space
/// filling curve, for points that are near each other to be near in memory.
inline void sort_canonically(Point_cloud& cloud)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  cloud.pose = Canonical_pose(cloud.points);
  std::vector<Kernel::Point_3> posed;
  posed.reserve(cloud.points.size());
  for (const Vector_3& point : cloud.points) {
    const Vector_3 in_pose = cloud.pose(point);
    posed.emplace_back(in_pose.x(), in_pose.y(), in_pose.z());
  }
  std::vector<Index> order(cloud.points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(), [&posed](Index i, Index j) { return posed[i] < posed[j]; });
  const auto point_map = boost::make_iterator_property_map(posed.cbegin(), boost::typed_identity_property_map<Index>());
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, std::decay_t<decltype(point_map)>>(point_map));
  std::vector<Index> number(order.size());
  std::vector<Vector_3> points;
  std::vector<Vector_3> normals;
  for (Index i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    points.push_back(cloud.points[order[i]]);
    if (!cloud.normals.empty()) {
      normals.push_back(cloud.normals[order[i]]);
    }
  }
  for (Index& point : cloud.input_point) {
    point = number[point];
  }
  cloud.points = std::move(points);
  cloud.normals = std::move(normals);
}

/// Merges points of equal coordinates and sorts the rest lexicographically; normals of merged points are added.
inline void merge_and_sort(std::vector<Vector_3>&& points, std::vector<Vector_3>&& normals, Point_cloud& cloud)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto key = [&points](Index i) { return std::make_pair(points[i].data(), points[i].data() + 3); };
  std::sort(order.begin(), order.end(), [&key](Index i, Index j) {
    const auto [a, a_end] = key(i);
    const auto [b, b_end] = key(j);
    return std::lexicographical_compare(a, a_end, b, b_end);
  });
  cloud.points.reserve(points.size());
  cloud.input_point.resize(points.size());
  for (Index i : order) {
    if (cloud.points.empty() || cloud.points.back() != points[i]) {
      cloud.points.push_back(points[i]);
      if (!normals.empty()) {
        cloud.normals.push_back(Vector_3::Zero());
      }
    }
    cloud.input_point[i] = Index(cloud.points.size() - 1);
    if (!normals.empty()) {
      cloud.normals.back() += normals[i];
    }
  }
  for (Vector_3& normal : cloud.normals) {
    normal.normalize();
  }
}

/// Refuses clouds that cannot have a surface: too few points, or all of them on a line.
/// \pre the extent of the points is about 1
inline void check_extent(const std::vector<Vector_3>& points)
{
  // Relative to the extent: farther off the line than rounding alone can be.
  constexpr double min_thickness = 1e-9;
  if (points.size() < minimum_number_of_points) {
    throw Input_error("the point set has " + std::to_string(points.size()) +
                      " different points: a surface needs at least " + std::to_string(minimum_number_of_points) +
                      "; check how the input was written");
  }
  const auto farthest_from = [&points](const Vector_3& p) {
    return *std::max_element(points.begin(), points.end(), [&p](const Vector_3& a, const Vector_3& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    });
  };
  const Vector_3 first = farthest_from(points.front());
  const Vector_3 axis = (farthest_from(first) - first).normalized();
  const bool is_line = std::all_of(points.begin(), points.end(), [&](const Vector_3& p) {
    return (p - first).cross(axis).norm() <= min_thickness;
  });
  if (is_line) {
    throw Input_error("all points are on one line: a surface needs points around a body; check how the input was "
                      "written");
  }
}

/// Reads `points` into flat arrays; O(n log n). All of them may be at one place.
/// \param point_map, normal_map readable maps from the elements of `points` to what has coordinates `x()`, `y()`,
///        `z()`, the second perhaps `No_normals`
/// \throw Input_error naming the point, by its number in the order of iteration, that has a coordinate that is not
///        finite; or if there are none or too many
template <class PointRange, class PointMap, class NormalMap>
Point_cloud collect_any_points(const PointRange& range, const PointMap& point_map,
                               [[maybe_unused]] const NormalMap& normal_map)
{
  std::vector<Vector_3> points;
  std::vector<Vector_3> normals;
  for (const auto& element : range) {
    points.push_back(to_vector_3(get(point_map, element)));
    if (!points.back().allFinite()) {
      throw Input_error("point " + std::to_string(points.size() - 1) +
                        " has a coordinate that is not finite: correct it or remove the point");
    }
    if constexpr (!std::is_same_v<NormalMap, No_normals>) {
      const Vector_3 normal = to_vector_3(get(normal_map, element));
      normals.push_back(normal.allFinite() ? Vector_3(normal.stableNormalized()) : Vector_3(Vector_3::Zero()));
    }
  }
  if (points.empty()) {
    throw Input_error("the point set is empty: there is nothing to skeletonize");
  }
  if (points.size() > maximum_number_of_points) {
    throw Input_error("the point set has more than 2^26 points: thin it out first, for instance by "
                      "CGAL::grid_simplify_point_set");
  }
  Point_cloud cloud;
  if (std::all_of(points.begin(), points.end(), [&](const Vector_3& p) { return p == points.front(); })) {
    cloud.normalization = {points.front(), 1};
    std::fill(points.begin(), points.end(), Vector_3::Zero());
    merge_and_sort(std::move(points), std::move(normals), cloud);
    return cloud;
  }
  cloud.normalization = normalize_extent(points);
  merge_and_sort(std::move(points), std::move(normals), cloud);
  sort_canonically(cloud);
  return cloud;
}

/// The same for points that a surface can be made of.
/// \throw Input_error also if there are too few different points, or all are on a line, or at one place
template <class PointRange, class PointMap, class NormalMap>
Point_cloud collect_points(const PointRange& range, const PointMap& point_map, const NormalMap& normal_map)
{
  Point_cloud cloud = collect_any_points(range, point_map, normal_map);
  if (cloud.points.size() == 1) {
    throw Input_error("all points are at the same place: a surface needs points around a body; check how the input was "
                      "written");
  }
  check_extent(cloud.points);
  return cloud;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_POINT_CLOUD_H
