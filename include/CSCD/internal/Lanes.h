// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of several problems side by side.

#ifndef CSCD_INTERNAL_LANES_H
#define CSCD_INTERNAL_LANES_H

#include <Eigen/Core>

#include <cstddef>

namespace CSCD::internal {

/// One number of each of `size` problems that are solved together, a power of two: 8 of them fill a cache line.
template <std::size_t size>
struct alignas(size * sizeof(double)) Lanes
{
  using Array = Eigen::Array<double, int(size), 1>;

  auto array() { return Eigen::Map<Array, Eigen::Aligned>(values); }
  auto array() const { return Eigen::Map<const Array, Eigen::Aligned>(values); }

  double& operator[](std::size_t lane) { return values[lane]; }
  double operator[](std::size_t lane) const { return values[lane]; }

  double values[size];
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_LANES_H
