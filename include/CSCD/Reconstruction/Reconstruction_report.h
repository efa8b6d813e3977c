// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What was done to make a surface of points.

#ifndef CSCD_RECONSTRUCTION_RECONSTRUCTION_REPORT_H
#define CSCD_RECONSTRUCTION_RECONSTRUCTION_REPORT_H

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD {

/// A place where the reconstructed surface was cut or joined, in the coordinates of the input.
struct Reconstruction_repair
{
  std::array<double, 3> center{}; ///< of the loop that was cut, or of the gap that was bridged
  double length = 0;              ///< of the loop that was cut, or the width of the gap
};

/// Counts and measures of the reconstruction of a surface from points. Lengths are in the unit of the input.
struct Reconstruction_report
{
  std::size_t number_of_points = 0;        ///< points of the input
  std::size_t number_of_duplicates = 0;    ///< points that are at the place of another one
  std::size_t number_of_neighbors = 0;     ///< the k of the neighborhoods
  double spacing = 0;                      ///< median over the points of the mean distance to the nearest six
  double noise = 0;                        ///< deviation of the points from planes, relative to the spacing
  bool is_smoothed = false;                ///< whether the points were moved to the planes
  std::size_t number_of_outliers = 0;      ///< points far from all others: left out of the surface
  std::size_t number_of_unused_points = 0; ///< points that are no vertices: they belong to the node of the nearest
  std::size_t number_of_border_edges = 0;  ///< edges at holes of the surface
  std::size_t number_of_holes = 0;         ///< holes that were closed
  std::vector<Reconstruction_repair> cut_handles; ///< handles that are too small to be believed
  std::vector<Reconstruction_repair> joined_gaps; ///< gaps between the fragments of one body
};

} // namespace CSCD

#endif // CSCD_RECONSTRUCTION_RECONSTRUCTION_REPORT_H
