// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells scans of trees and curves from points on a body before a surface is made.

#ifndef CSCD_POINTS_RECOGNIZE_TREE_SCAN_H
#define CSCD_POINTS_RECOGNIZE_TREE_SCAN_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/principal_axes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The forms of the points in balls around some points, which are spread evenly, as parts of those balls.
struct Cloud_forms
{
  double along_curves = 0; ///< long and thin
  double in_space = 0;     ///< as wide as high
  double steepness = 0;    ///< the mean square of the sine between the curves and the plane that they are nearest to
  double bend = 0;         ///< the same between the curves and the line that they are nearest to
  Vector3 normal;          ///< of that plane
};

/// The offsets of `points` from every so many of `centers`, which are among them by number, up to `radius` and in units
/// of it. Linear in what it returns and the number of points.
/// \param number of centers, about
inline std::vector<std::vector<Vector3>>
offsets_around(const std::vector<Vector3>& points, const std::vector<Index>& centers, std::size_t number, double radius)
{
  Point_grid grid(radius);
  for (std::size_t i = 0; i < centers.size(); i += std::max<std::size_t>(1, centers.size() / number)) {
    grid.insert(points[centers[i]]);
  }
  std::vector<std::vector<Vector3>> offsets(grid.size());
  for (const Vector3& point : points) {
    grid.for_each_near(point, [&](Index i, double) { offsets[i].push_back((point - grid.point(i)) / radius); });
  }
  return offsets;
}

/// Looks at balls of twice the radius that leaves about 7000 of `points`, or a quarter of them. Linear.
/// \pre the extent of the points is about 1
inline Cloud_forms forms_of(const std::vector<Vector3>& points)
{
  constexpr double number_of_balls = 7000;
  constexpr std::size_t probes = 1000;  // balls: parts of them are then known to about a hundredth
  constexpr std::size_t min_points = 8; // fewer show no form
  constexpr double thin_part = 0.2;     // of the second to the first principal variance
  constexpr double high_part = 0.25;    // of the third to the second
  const double number = std::min(number_of_balls, double(points.size()) / 4);
  const double radius = std::sqrt(packing_density * estimate_area(points) / number);
  Cloud_forms result;
  Moment_matrix directions{};
  double number_of_forms = 0;
  double number_of_curves = 0;
  for (const std::vector<Vector3>& ball : offsets_around(points, thin(points, radius), probes, 2 * radius)) {
    if (ball.size() < min_points) {
      continue;
    }
    const Principal_axes axes = axes_of(ball);
    const bool is_thin = axes.values[1] < thin_part * axes.values[2];
    number_of_forms += 1;
    if (is_thin) {
      number_of_curves += 1;
      directions += Moment_matrix::product(axes.vectors[2], axes.vectors[2]);
    }
    result.in_space += !is_thin && axes.values[0] > high_part * axes.values[1] ? 1 : 0;
  }
  if (number_of_forms > 0) {
    result.along_curves = number_of_curves / number_of_forms;
    result.in_space /= number_of_forms;
  }
  if (number_of_curves > 0) {
    const Principal_axes axes = principal_axes(directions);
    result.steepness = axes.values[0] / number_of_curves;
    result.bend = 1 - axes.values[2] / number_of_curves;
    result.normal = axes.vectors[0];
  }
  return result;
}

/// Whether points sample trees or other thin things: twigs look like curves, and leaves fill space. Of three scans of
/// trees, and of trees that are known, a tenth to a quarter of the balls look like curves and two fifths or more like
/// curves or space; of 20,000 points and more on bodies at most a thirtieth look like curves. If all do, it is a body
/// that was scanned line by line; if all are parallel to one plane, a body that was sliced.
inline bool is_scan_of_trees(const Cloud_forms& forms)
{
  constexpr double min_along_curves = 0.08; // between a thirtieth and a tenth
  constexpr double max_along_curves = 0.6;  // between a quarter and all
  constexpr double min_of_both = 0.3;       // below two fifths
  constexpr double min_steepness = 0.02;    // twigs in all directions have 0.33; slices, without noise, 0
  return forms.steepness > min_steepness && forms.along_curves > min_along_curves &&
         forms.along_curves < max_along_curves && forms.along_curves + forms.in_space > min_of_both;
}

/// Whether points lie along curves in several parallel planes, as of a sliced body: a body in one piece, as a tree, has
/// curves that lead from plane to plane. Linear.
/// \pre the extent of the points is about 1
inline bool lie_in_slices(const std::vector<Vector3>& points)
{
  constexpr double min_along_curves = 0.9;
  constexpr double max_steepness = 1e-3; // two degrees, for noise
  constexpr double min_bend = 0.1;       // 20 degrees: straight lines of any direction are in parallel planes
  constexpr double min_height = 0.05;    // of all slices: noise of a single one is lower
  const Cloud_forms forms = forms_of(points);
  if (forms.along_curves < min_along_curves || forms.steepness > max_steepness || forms.bend < min_bend) {
    return false;
  }
  const auto is_lower = [&](const Vector3& a, const Vector3& b) { return forms.normal.dot(a) < forms.normal.dot(b); };
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), is_lower);
  return forms.normal.dot(*highest - *lowest) > min_height;
}

/// Whether points are along curves that are far from each other, so that they sample no surface: around nearly all of
/// them, within some 25 times their distance on the curve, they are not wider than noise. Scanner lines that are ten
/// times as far apart as their points lie side by side there, and a tube is wider. Linear.
/// \param spacing mean distance of six neighbors, which is twice the distance along a curve
inline bool lie_along_curves(const std::vector<Vector3>& points, double spacing)
{
  constexpr double ball_radius = 12;       // in spacings
  constexpr double max_width = 0.75;       // standard deviation across, in spacings
  constexpr std::size_t probes = 300;      // balls: the part of them is then known to about a fiftieth
  constexpr std::size_t min_points = 8;    // fewer show no form
  constexpr double min_part = 0.9;         // of the balls
  constexpr std::size_t min_number = 1000; // fewer take little time, whatever their form
  if (points.size() < min_number || !(spacing > 0)) {
    return false;
  }
  const double radius = ball_radius * spacing;
  const double max_variance = max_width * max_width / (ball_radius * ball_radius);
  const std::vector<std::vector<Vector3>> balls = offsets_around(points, thin(points, radius), probes, radius);
  const auto is_curve = [&](const std::vector<Vector3>& ball) {
    return ball.size() >= min_points && axes_of(ball).values[1] < max_variance;
  };
  return double(std::count_if(balls.begin(), balls.end(), is_curve)) > min_part * double(balls.size());
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_RECOGNIZE_TREE_SCAN_H
