// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vector type and the index type of the flat arrays.

#ifndef CSCD_VECTOR_3_H
#define CSCD_VECTOR_3_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <limits>

namespace CSCD {

/// Points and vectors of the normalized surface.
using Vector_3 = Eigen::Vector3d;

/// Index of a vertex, halfedge, face, separator or piece.
using Index = std::uint32_t;

/// The index of nothing.
inline constexpr Index no_index = std::numeric_limits<Index>::max();

} // namespace CSCD

#endif // CSCD_VECTOR_3_H
