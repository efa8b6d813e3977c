// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the fronts around a vertex run: where they are, and in which direction.

#ifndef CSCD_CUT_LOCUS_FRONT_SECTOR_H
#define CSCD_CUT_LOCUS_FRONT_SECTOR_H

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

namespace CSCD::internal {

/// A face around a vertex, or a neighbor: where it lies, and its gradient, both in the frame of the vertex.
struct Front_sector
{
  std::complex<double> direction; ///< from the vertex to there, of length 1
  std::complex<double> gradient;  ///< of length 1
};

/// What is around one vertex, counterclockwise.
using Front_sectors = boost::container::small_vector<Front_sector, 16>;

inline double dot(const std::complex<double>& a, const std::complex<double>& b)
{
  return a.real() * b.real() + a.imag() * b.imag();
}

inline bool are_converging(const Front_sector& a, const Front_sector& b)
{
  return dot(a.gradient - b.gradient, a.direction - b.direction) < 0;
}

/// The greatest angle in [0, pi] between the gradients of two sectors that run towards each other. O(d^2) for d sectors
/// up to a constant, beyond which an even sample of them is taken.
inline double greatest_convergence(const Front_sectors& sectors)
{
  // Sectors that are compared pair by pair.
  constexpr std::size_t most_sectors = 32;
  const std::size_t stride = (sectors.size() + most_sectors - 1) / most_sectors;
  double least_cosine = 1;
  for (std::size_t i = 0; i < sectors.size(); i += stride) {
    for (std::size_t j = i + stride; j < sectors.size(); j += stride) {
      const double cosine = dot(sectors[i].gradient, sectors[j].gradient);
      if (cosine < least_cosine && are_converging(sectors[i], sectors[j])) {
        least_cosine = cosine;
      }
    }
  }
  return std::acos(std::clamp(least_cosine, -1., 1.));
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_FRONT_SECTOR_H
