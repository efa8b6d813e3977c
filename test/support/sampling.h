// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point clouds of shapes.

#ifndef CSCD_TEST_SUPPORT_SAMPLING_H
#define CSCD_TEST_SUPPORT_SAMPLING_H

#include "Shape.h"
#include "shape_operations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace CSCD::test {

/// A number in [0, 1) drawn from `random`; the same on every platform.
inline double random_unit(std::mt19937_64& random)
{
  return (random_signed_unit(random) + 1) / 2;
}

inline double area(const Shape& shape, const Triangle& t)
{
  return norm(cross(shape.points[t[1]] - shape.points[t[0]], shape.points[t[2]] - shape.points[t[0]])) / 2;
}

/// `number` points on the surface of `shape`, uniform by area.
inline std::vector<Triple> sampled(const Shape& shape, std::size_t number, unsigned seed)
{
  std::vector<double> sums;
  double sum = 0;
  for (const Triangle& t : shape.triangles) {
    sum += area(shape, t);
    sums.push_back(sum);
  }
  std::mt19937_64 random(seed);
  std::vector<Triple> result;
  while (result.size() < number) {
    const auto found = std::upper_bound(sums.begin(), sums.end() - 1, random_unit(random) * sum);
    const Triangle& t = shape.triangles[static_cast<std::size_t>(found - sums.begin())];
    double u = random_unit(random);
    double v = random_unit(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    result.push_back((1 - u - v) * shape.points[t[0]] + u * shape.points[t[1]] + v * shape.points[t[2]]);
  }
  return result;
}

/// The mean distance to the nearest point in a uniform sample of `number` points of `shape`.
inline double mean_spacing(const Shape& shape, std::size_t number)
{
  double sum = 0;
  for (const Triangle& t : shape.triangles) {
    sum += area(shape, t);
  }
  return std::sqrt(sum / static_cast<double>(number)) / 2;
}

/// `points`, each coordinate shaken by a normally distributed number of standard deviation `deviation`.
inline std::vector<Triple> shaken(std::vector<Triple> points, double deviation, unsigned seed)
{
  constexpr int number_of_summands = 12; // uniform numbers of variance 1/3 that add up to a nearly normal one
  std::mt19937_64 random(seed);
  for (Triple& p : points) {
    for (double& coordinate : p) {
      double sum = 0;
      for (int i = 0; i < number_of_summands; ++i) {
        sum += random_signed_unit(random);
      }
      coordinate += deviation * sum / 2;
    }
  }
  return points;
}

/// `points` without those nearer than `radius` to `center`.
inline std::vector<Triple> without_ball(std::vector<Triple> points, const Triple& center, double radius)
{
  points.erase(std::remove_if(points.begin(), points.end(), [&](const Triple& p) { return norm(p - center) < radius; }),
               points.end());
  return points;
}

/// `triples` as points of another type.
template <class Point>
std::vector<Point> to_points(const std::vector<Triple>& triples)
{
  std::vector<Point> result;
  result.reserve(triples.size());
  for (const Triple& p : triples) {
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SAMPLING_H
