// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns and scales points so that their coordinates depend on the shape alone.

#ifndef CSCD_POINT_CLOUD_CANONICAL_POSE_H
#define CSCD_POINT_CLOUD_CANONICAL_POSE_H

#include <CSCD/internal/Vector_3.h>

#include <Eigen/Eigenvalues>

#include <cmath>
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

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_CANONICAL_POSE_H
