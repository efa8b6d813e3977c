// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Point_cloud.h.

#ifndef CSCD_POINTS_POINT_CLOUD_IMPL_H
#define CSCD_POINTS_POINT_CLOUD_IMPL_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// `number`, of 21 binary digits, with two zeros before each of them.
inline std::uint64_t spread_digits(std::uint64_t number)
{
  number = (number | number << 32U) & 0x001f00000000ffffU;
  number = (number | number << 16U) & 0x001f0000ff0000ffU;
  number = (number | number << 8U) & 0x100f00f00f00f00fU;
  number = (number | number << 4U) & 0x10c30c30c30c30c3U;
  return (number | number << 2U) & 0x1249249249249249U;
}

CSCD_INLINE void put_in_order(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                              Point_cloud& cloud)
{
  constexpr double max_cell = (1 << 21) - 1; // along the longest side: 63 binary digits in all
  cloud.pose = Canonical_pose(points);
  const std::vector<Vector3> posed = cloud.pose.places_of(points);
  const Bounding_box box(posed);
  const double cells = max_cell / (box.max() - box.min()).maxCoeff();
  std::vector<std::pair<std::uint64_t, Index>> order; // by the codes of cells
  order.reserve(points.size());
  for (Index i = 0; i < posed.size(); ++i) {
    const Vector3 cell = cells * (posed[i] - box.min());
    const auto spread = [&cell](std::size_t axis) { return spread_digits(std::uint64_t(cell[axis])); };
    order.emplace_back(spread(2) << 2U | spread(1) << 1U | spread(0), i); // the longest axis first
  }
  std::sort(order.begin(), order.end(), [&points](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : is_lexicographically_less(points[a.second], points[b.second]);
  });
  cloud.points.reserve(points.size());
  cloud.input_point.resize(points.size());
  for (const auto& [code, i] : order) {
    if (cloud.points.empty() || cloud.points.back() != points[i]) {
      cloud.points.push_back(points[i]);
      if (!normals.empty()) {
        cloud.normals.push_back(Vector3::Zero());
      }
    }
    cloud.input_point[i] = Index(cloud.points.size() - 1);
    if (!normals.empty()) {
      cloud.normals.back() += normals[i];
    }
  }
  if (std::all_of(cloud.normals.begin(), cloud.normals.end(), [](const Vector3& n) { return n == Vector3::Zero(); })) {
    cloud.normals.clear(); // some programs write columns that they do not fill
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
  // All terms, which are less than 64, are rounded such that their sums are exact: whatever their order.
  const double shift = std::ldexp(96., std::ilogb(size));
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (const Vector3& point : points) {
    sum += (internal::to_eigen(point).array() + shift) - shift;
  }
  m_centroid = internal::from_eigen(sum / size);
  Eigen::Array33d moments = Eigen::Array33d::Zero();
  for (const Vector3& point : points) {
    const Eigen::Vector3d offset = internal::to_eigen(point - m_centroid);
    moments += ((offset * offset.transpose()).array() + shift) - shift;
  }
  // The iterative solver is exact to rounding, unlike the direct one.
  m_rotation = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments.matrix()).eigenvectors().transpose();
  Eigen::Array3d third_moments = Eigen::Array3d::Zero();
  for (const Vector3& point : points) {
    const Eigen::Array3d place = m_rotation * internal::to_eigen(point - m_centroid);
    third_moments += (place * place * place + shift) - shift;
  }
  m_scale = std::sqrt(size / moments.matrix().trace());
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
  const auto bad = std::find_if(points.begin(), points.end(), [](const Vector3& p) { return !p.allFinite(); });
  if (bad != points.end()) {
    throw Input_error("point " + std::to_string(bad - points.begin()) +
                      " has a coordinate that is not finite: correct it or remove the point");
  }
  if (points.empty()) {
    throw Input_error("the point set is empty: there is nothing to skeletonize");
  }
  if (points.size() > maximum_number_of_points) {
    throw Input_error("the point set has more than 2^26 points: thin it out first, for instance by "
                      "CGAL::grid_simplify_point_set");
  }
  for (Vector3& normal : normals) {
    normal = normal.allFinite() ? normal.stableNormalized() : Vector3::Zero();
  }
  Point_cloud cloud;
  if (std::all_of(points.begin(), points.end(), [&](const Vector3& p) { return p == points.front(); })) {
    cloud.normalization = {points.front(), 1};
    cloud.points = {Vector3::Zero()};
    cloud.normals.resize(std::min<std::size_t>(normals.size(), 1), Vector3::Zero());
    cloud.input_point.resize(points.size(), 0);
    return cloud;
  }
  cloud.normalization = normalize_extent(points);
  internal::put_in_order(points, normals, cloud);
  return cloud;
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_CLOUD_IMPL_H
