// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in flat arrays, in an order that does not depend on that of the input.

#ifndef CSCD_POINTS_POINT_CLOUD_H
#define CSCD_POINTS_POINT_CLOUD_H

#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// For the few places that multiply vectors by matrices.
inline Eigen::Vector3d to_eigen(const Vector3& v)
{
  return {v.x(), v.y(), v.z()};
}
inline Vector3 from_eigen(const Eigen::Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}

} // namespace CSCD::internal

namespace CSCD {

/// The similarity that moves the centroid of points to the origin, turns their principal axes to the coordinate axes,
/// each towards where the third moment is positive, and makes the mean squared distance from the centroid 1. Its result
/// does not change, up to rounding and except for clouds with a symmetry, when the points are moved, turned or scaled.
class Canonical_pose
{
public:
  Canonical_pose() = default;

  /// Finds the pose of `points`; linear.
  /// \pre the points are not all equal, and their extent is about 1
  explicit Canonical_pose(const std::vector<Vector3>& points);

  /// The place of `point` in the pose.
  Vector3 operator()(const Vector3& point) const
  {
    return internal::from_eigen(m_scale * (m_rotation * internal::to_eigen(point - m_centroid)));
  }
  /// The places of `points` in the pose.
  std::vector<Vector3> places_of(const std::vector<Vector3>& points) const
  {
    std::vector<Vector3> result(points.size());
    std::transform(points.begin(), points.end(), result.begin(), *this);
    return result;
  }
  /// `direction` in the pose.
  Vector3 turn(const Vector3& direction) const
  {
    return internal::from_eigen(m_rotation * internal::to_eigen(direction));
  }
  /// The direction that is `direction` in the pose.
  Vector3 turn_back(const Vector3& direction) const
  {
    return internal::from_eigen(m_rotation.transpose() * internal::to_eigen(direction));
  }
  /// Lengths in the pose, relative to those of the points.
  double scale() const { return m_scale; }

private:
  Vector3 m_centroid = Vector3::Zero();
  Eigen::Matrix3d m_rotation = Eigen::Matrix3d::Identity();
  double m_scale = 1;
};

/// With more points than this the halfedges of the surface could no longer be indexed.
inline constexpr std::size_t maximum_number_of_points = std::size_t(1) << 26;

/// A surface around a body needs at least this many points.
inline constexpr std::size_t minimum_number_of_points = 4;

/// Points at different places in the cube [-1, 1]^3, in an order that does not depend on that of the input.
struct Point_cloud
{
  /// The points, all different.
  std::vector<Vector3> points;
  std::vector<Vector3> normals;   ///< of unit length, zero where unknown; empty if the input has none
  std::vector<Index> input_point; ///< for every point of the input, the point that represents it
  /// From the coordinates of the input to those of the points.
  Normalization normalization;
  Canonical_pose pose; ///< of the points
  /// Points of the input that points at other places represent.
  std::size_t number_of_thinned_points = 0;
  /// Those of them that are far from all others, or spread in space: they belong to the nearest of the others.
  std::size_t number_of_outliers = 0;
  bool is_averaged = false; ///< whether noise was averaged away: then the points are not at the places of the input

  /// The number of points of the input that are at the place of an earlier one.
  std::size_t number_of_duplicates() const { return input_point.size() - points.size() - number_of_thinned_points; }
};

/// Merges equal points, normalizes the rest and puts them into their canonical order; O(n log n). All of them may be at
/// one place.
/// \param points of the input, in its coordinates
/// \param normals one for each point, of any length, zero or not finite where unknown; or none
/// \throw Input_error naming the point, by its number, that has a coordinate that is not finite; or if `points` is empty
///        or too large
Point_cloud make_point_cloud(std::vector<Vector3>&& points, std::vector<Vector3>&& normals);

/// Refuses clouds that cannot have a surface.
/// \throw Input_error if there are too few different points, or all are on a line or at one place
void check_extent(const Point_cloud& cloud);

namespace internal {

/// Writes `points` to the empty `cloud`, in the order of a Morton curve in their canonical pose, along which points
/// that are near each other are near in memory: neither the order of the input nor its pose matters. Equal points are
/// merged, and their normals added. O(n log n).
void put_in_order(const std::vector<Vector3>& points, const std::vector<Vector3>& normals, Point_cloud& cloud);

} // namespace internal
} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Points/Point_cloud_impl.h>
#endif

#endif // CSCD_POINTS_POINT_CLOUD_H
