// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversions for the few places that multiply vectors by Eigen's matrices.

#ifndef CSCD_INTERNAL_EIGEN_VECTOR_H
#define CSCD_INTERNAL_EIGEN_VECTOR_H

#include <CSCD/Vector_3.h>

#include <Eigen/Core>

namespace CSCD::internal {

inline Eigen::Vector3d to_eigen(const Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}
inline Vector_3 from_eigen(const Eigen::Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_EIGEN_VECTOR_H
