// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sheets with known middle lines.

#ifndef CSCD_TEST_SUPPORT_SHEET_SHAPES_H
#define CSCD_TEST_SUPPORT_SHEET_SHAPES_H

#include "support/Shape.h"
#include "support/swept_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CSCD::test {

/// A sheet, half of its width, and the distance of points from its middle line.
struct Sheet_shape
{
  Shape shape;
  double half_width = 0;
  std::function<double(const Triple&)> distance_from_middle;
  std::size_t betti_number = 0;
};

namespace internal {

/// The sheet of `point(u, v)` for u and v from 0 to 1: a grid of `along` by `across` squares, joined at its ends if
/// `is_ring`.
template <class Function>
Shape grid_sheet(const std::string& name, std::size_t along, std::size_t across, bool is_ring, const Function& point)
{
  Shape shape;
  shape.name = name;
  const std::size_t rows = is_ring ? along : along + 1;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j <= across; ++j) {
      shape.points.push_back(point(double(i) / double(along), double(j) / double(across)));
    }
  }
  const auto vertex = [&](std::size_t i, std::size_t j) { return i % rows * (across + 1) + j; };
  for (std::size_t i = 0; i < along; ++i) {
    for (std::size_t j = 0; j < across; ++j) {
      shape.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      shape.triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  shape.number_of_border_cycles = is_ring ? 2 : 1;
  return shape;
}

} // namespace internal

/// A flat strip along the x axis.
inline Sheet_shape strip_sheet(double length, double width)
{
  const auto squares = [](double extent) { return std::size_t(std::lround(8 * extent)); };
  return {internal::grid_sheet("strip", squares(length), squares(width), false,
                               [=](double u, double v) {
                                 return Triple{length * u, width * (v - 0.5), 0};
                               }),
          width / 2, [](const Triple& p) { return std::hypot(p[1], p[2]); }, 0};
}

/// A part of a pipe of radius 1 around the x axis, of `angle` around its highest line.
inline Sheet_shape pipe_sheet(double length, double angle)
{
  return {internal::grid_sheet("pipe", std::size_t(8 * length), std::size_t(8 * angle), false,
                               [=](double u, double v) {
                                 const double a = angle * (v - 0.5);
                                 return Triple{length * u, std::sin(a), std::cos(a)};
                               }),
          angle / 2, [](const Triple& p) { return std::hypot(p[1], p[2] - 1); }, 0};
}

/// A part of a torus of radii 3 and 1 around the z axis, of `angle` around its outermost line.
inline Sheet_shape torus_sheet(double angle)
{
  return {internal::grid_sheet("torus", 120, std::size_t(8 * angle), true,
                               [=](double u, double v) {
                                 const double a = angle * (v - 0.5);
                                 const double r = 3 + std::cos(a);
                                 return Triple{r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), std::sin(a)};
                               }),
          angle / 2, [](const Triple& p) { return std::hypot(std::hypot(p[0], p[1]) - 4, p[2]); }, 1};
}

/// A bent leaf with pointed ends, 10 long and 4 wide.
inline Sheet_shape leaf_sheet()
{
  const auto height = [](double x) { return 0.6 * std::sin(pi * x / 10); };
  return {internal::grid_sheet("leaf", 80, 24, false,
                               [=](double u, double v) {
                                 const double width = 0.1 + 3.9 * std::pow(std::sin(pi * u), 0.7);
                                 return Triple{10 * u, width * (v - 0.5), height(10 * u)};
                               }),
          2, [=](const Triple& p) { return std::hypot(p[1], p[2] - height(p[0])); }, 0};
}

/// Three quarters of a flat ring of radius 3, 1.5 wide, that rises and twists along its length: it has no symmetry.
inline Sheet_shape curved_sheet()
{
  const auto place = [](double u, double across) {
    const double a = 1.5 * pi * u;
    const double r = 3 + across;
    return Triple{r * std::cos(a), r * std::sin(a), 2 * u * u + 0.2 * across * u};
  };
  return {internal::grid_sheet("curved", 96, 12, false, [=](double u, double v) { return place(u, 1.5 * (v - 0.5)); }),
          0.75,
          [=](const Triple& p) {
            double least = norm(p - place(0, 0));
            for (int i = 1; i <= 1000; ++i) {
              least = std::min(least, norm(p - place(i / 1000., 0)));
            }
            return least;
          },
          0};
}

/// Sheets whose middle line is known.
inline std::vector<Sheet_shape> sheets_with_known_middle()
{
  return {strip_sheet(10, 2),
          pipe_sheet(10, pi),
          pipe_sheet(12, 1.4 * pi),
          pipe_sheet(16, 1.86 * pi),
          torus_sheet(pi),
          torus_sheet(1.86 * pi),
          leaf_sheet(),
          curved_sheet()};
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SHEET_SHAPES_H
