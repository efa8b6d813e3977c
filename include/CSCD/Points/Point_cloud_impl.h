// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Point_cloud.h.

#ifndef CSCD_POINTS_POINT_CLOUD_IMPL_H
#define CSCD_POINTS_POINT_CLOUD_IMPL_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

CSCD_INLINE void sort_canonically(Point_cloud& cloud)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  cloud.pose = Canonical_pose(cloud.points);
  // Side by side, since the sort reads the points all the time.
  using Numbered_point = std::pair<Kernel::Point_3, Index>;
  std::vector<Numbered_point> order;
  order.reserve(cloud.points.size());
  for (Index i = 0; i < cloud.points.size(); ++i) {
    order.emplace_back(make_point<Kernel::Point_3>(cloud.pose(cloud.points[i])), i);
  }
  using Map = CGAL::First_of_pair_property_map<Numbered_point>;
  CGAL::hilbert_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_3<Kernel, Map>());
  std::vector<Index> number(order.size());
  std::vector<Index> old_number(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    old_number[i] = order[i].second;
    number[old_number[i]] = i;
  }
  for (Index& point : cloud.input_point) {
    point = number[point];
  }
  cloud.points = reordered(cloud.points, old_number);
  cloud.normals = reordered(cloud.normals, old_number);
}

CSCD_INLINE void merge_and_sort(std::vector<Vector3>&& points, std::vector<Vector3>&& normals, Point_cloud& cloud)
{
  std::vector<std::pair<Vector3, Index>> numbered; // with their points, which are read all the time
  numbered.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    numbered.emplace_back(points[i], i);
  }
  std::sort(numbered.begin(), numbered.end(),
            [](const auto& a, const auto& b) { return is_lexicographically_less(a.first, b.first); });
  cloud.points.reserve(points.size());
  cloud.input_point.resize(points.size());
  for (const auto& [point, i] : numbered) {
    if (cloud.points.empty() || cloud.points.back() != point) {
      cloud.points.push_back(point);
      if (!normals.empty()) {
        cloud.normals.push_back(Vector3::Zero());
      }
    }
    cloud.input_point[i] = Index(cloud.points.size() - 1);
    if (!normals.empty()) {
      cloud.normals.back() += normals[i];
    }
  }
  for (Vector3& normal : cloud.normals) {
    normal.normalize();
  }
}

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE Canonical_pose::Canonical_pose(const std::vector<Vector3>& points)
{
  const double size = double(points.size());
  for (const Vector3& point : points) {
    m_centroid += point / size;
  }
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vector3& point : points) {
    const Eigen::Vector3d offset = internal::to_eigen(point - m_centroid);
    moments += offset * offset.transpose() / size;
  }
  // The iterative solver is exact to rounding, unlike the direct one.
  m_rotation = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().transpose();
  m_scale = 1 / std::sqrt(moments.trace());
  Vector3 third_moments = Vector3::Zero();
  for (const Vector3& point : points) {
    const Vector3 place = (*this)(point);
    third_moments +=
        {place.x() * place.x() * place.x(), place.y() * place.y() * place.y(), place.z() * place.z() * place.z()};
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

CSCD_INLINE void check_extent(const Point_cloud& cloud)
{
  const std::vector<Vector3>& points = cloud.points;
  if (points.size() == 1) {
    throw Input_error("all points are at the same place: a surface needs points around a body; check how the input was "
                      "written");
  }
  // Relative to the extent: farther off the line than rounding alone can be.
  constexpr double min_thickness = 1e-9;
  if (points.size() < minimum_number_of_points) {
    throw Input_error("the point set has " + std::to_string(points.size()) +
                      " different points: a surface needs at least " + std::to_string(minimum_number_of_points) +
                      "; check how the input was written");
  }
  const auto farthest_from = [&points](const Vector3& p) {
    return *std::max_element(points.begin(), points.end(), [&p](const Vector3& a, const Vector3& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    });
  };
  const Vector3 first = farthest_from(points.front());
  const Vector3 axis = (farthest_from(first) - first).normalized();
  const bool is_line = std::all_of(points.begin(), points.end(),
                                   [&](const Vector3& p) { return (p - first).cross(axis).norm() <= min_thickness; });
  if (is_line) {
    throw Input_error("all points are on one line: a surface needs points around a body; check how the input was "
                      "written");
  }
}

CSCD_INLINE Point_cloud make_point_cloud(std::vector<Vector3>&& points, std::vector<Vector3>&& normals)
{
  if (points.empty()) {
    throw Input_error("the point set is empty: there is nothing to skeletonize");
  }
  if (points.size() > maximum_number_of_points) {
    throw Input_error("the point set has more than 2^26 points: thin it out first, for instance by "
                      "CGAL::grid_simplify_point_set");
  }
  Point_cloud cloud;
  if (std::all_of(points.begin(), points.end(), [&](const Vector3& p) { return p == points.front(); })) {
    cloud.normalization = {points.front(), 1};
    std::fill(points.begin(), points.end(), Vector3::Zero());
    internal::merge_and_sort(std::move(points), std::move(normals), cloud);
    return cloud;
  }
  cloud.normalization = normalize_extent(points);
  internal::merge_and_sort(std::move(points), std::move(normals), cloud);
  internal::sort_canonically(cloud);
  return cloud;
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_CLOUD_IMPL_H
