// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells scans of trees from points on a body before a surface is made.

#ifndef CSCD_RECONSTRUCTION_RECOGNIZE_TREE_SCAN_H
#define CSCD_RECONSTRUCTION_RECOGNIZE_TREE_SCAN_H

#include <CSCD/Reconstruction/Point_grid.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/principal_axes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

namespace CSCD::internal {

/// Some 50,000 of `points`, or all if they are fewer: those whose coordinates have a certain remainder, so that the
/// choice does not depend on their order. Linear.
inline std::vector<Vector_3> sample_of(const std::vector<Vector_3>& points)
{
  constexpr std::size_t size = 50000;
  const std::size_t divisor = std::max<std::size_t>(1, points.size() / size);
  const auto key = [](const Vector_3& point) {
    std::uint64_t result = 0;
    for (const double coordinate : point) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      // The finalizer of SplitMix64.
      result = (result ^ bits) + 0x9e3779b97f4a7c15U;
      result = (result ^ (result >> 30U)) * 0xbf58476d1ce4e5b9U;
      result = (result ^ (result >> 27U)) * 0x94d049bb133111ebU;
      result ^= result >> 31U;
    }
    return result;
  };
  std::vector<Vector_3> result;
  std::copy_if(points.begin(), points.end(), std::back_inserter(result),
               [&](const Vector_3& point) { return key(point) % divisor == 0; });
  return result;
}

/// What the points of balls around some points, which are spread evenly, look like, as parts of those balls.
struct Cloud_forms
{
  double along_curves = 0; ///< long and thin
  double in_space = 0;     ///< as wide as high
};

/// Looks at balls of twice the radius by which about 7000 of `points` would remain, or a quarter of them. Linear.
/// \pre the extent of the points is about 1
inline Cloud_forms forms_of(const std::vector<Vector_3>& points)
{
  constexpr double number_of_balls = 7000;
  constexpr std::size_t probes = 1000;
  constexpr std::size_t min_points = 8; // fewer show no form
  constexpr double thin_part = 0.2;     // of the second to the first principal variance
  constexpr double high_part = 0.25;    // of the third to the second
  const double number = std::min(number_of_balls, double(points.size()) / 4);
  const double radius = std::sqrt(packing_density * estimate_area(points) / number);
  const std::vector<Index> balls = thin(points, radius);
  Point_grid grid(2 * radius);
  for (std::size_t i = 0; i < balls.size(); i += std::max<std::size_t>(1, balls.size() / probes)) {
    grid.insert(points[balls[i]]);
  }
  std::vector<std::vector<Vector_3>> offsets(grid.size());
  for (const Vector_3& point : points) {
    grid.for_each_near(point, [&](Index i, double) { offsets[i].push_back((point - grid.point(i)) / radius); });
  }
  Cloud_forms result;
  double number_of_forms = 0;
  for (const std::vector<Vector_3>& ball : offsets) {
    if (ball.size() < min_points) {
      continue;
    }
    Vector_3 mean = Vector_3::Zero();
    Moment_matrix moments{};
    for (const Vector_3& offset : ball) {
      mean += offset / double(ball.size());
      moments += Moment_matrix::product(offset, offset) / double(ball.size());
    }
    const std::array<double, 3> variances = principal_axes(moments - Moment_matrix::product(mean, mean)).values;
    const bool is_thin = variances[1] < thin_part * variances[2];
    number_of_forms += 1;
    result.along_curves += is_thin ? 1 : 0;
    result.in_space += !is_thin && variances[0] > high_part * variances[1] ? 1 : 0;
  }
  return number_of_forms > 0 ? Cloud_forms{result.along_curves / number_of_forms, result.in_space / number_of_forms}
                             : result;
}

/// Whether points sample trees or other thin things: twigs look like curves, and leaves fill space. Of three scans of
/// trees, and of trees that are known, a tenth to a quarter of the balls look like curves and two fifths or more like
/// curves or space; of 20,000 points and more on bodies at most a thirtieth look like curves. If all do, it is a body
/// that was scanned line by line.
inline bool is_scan_of_trees(const Cloud_forms& forms)
{
  constexpr double min_along_curves = 0.08;
  constexpr double max_along_curves = 0.6;
  constexpr double min_of_both = 0.3;
  return forms.along_curves > min_along_curves && forms.along_curves < max_along_curves &&
         forms.along_curves + forms.in_space > min_of_both;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_RECOGNIZE_TREE_SCAN_H
