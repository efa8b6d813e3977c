// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sheets with known middle lines, and garments.

#ifndef CSCD_TEST_SUPPORT_SHEET_SHAPES_H
#define CSCD_TEST_SUPPORT_SHEET_SHAPES_H

#include "support/Shape.h"
#include "support/implicit_surface.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/swept_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::test {

/// A sheet, half of its width, the distance of points from its middle line, and where that ends.
struct Sheet_shape
{
  Shape shape;
  double half_width = 0;
  std::function<double(const Triple&)> distance_from_middle;
  std::size_t betti_number = 0;
  std::vector<Triple> ends{};
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
          width / 2,
          [](const Triple& p) { return std::hypot(p[1], p[2]); },
          0,
          {{0, 0, 0}, {length, 0, 0}}};
}

/// A part of a pipe of radius 1 around the x axis, of `angle` around its highest line.
inline Sheet_shape pipe_sheet(double length, double angle)
{
  return {internal::grid_sheet("pipe", std::size_t(8 * length), std::size_t(8 * angle), false,
                               [=](double u, double v) {
                                 const double a = angle * (v - 0.5);
                                 return Triple{length * u, std::sin(a), std::cos(a)};
                               }),
          angle / 2,
          [](const Triple& p) { return std::hypot(p[1], p[2] - 1); },
          0,
          {{0, 0, 1}, {length, 0, 1}}};
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
          2,
          [=](const Triple& p) { return std::hypot(p[1], p[2] - height(p[0])); },
          0,
          {{0, 0, 0}, {10, 0, 0}}};
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
          0,
          {place(0, 0), place(1, 0)}};
}

/// Three flat strips of `length`, 2 wide, that meet at the origin at equal angles.
inline Sheet_shape y_sheet(double length)
{
  constexpr std::size_t across = 8; // squares in half of the width
  const auto along = std::size_t(std::lround(across * length));
  Sheet_shape sheet;
  Shape& shape = sheet.shape;
  shape.name = "Y";
  shape.number_of_border_cycles = 1;
  std::map<std::pair<long, long>, std::size_t> vertices; // by rounded position: neighboring strips agree on theirs
  for (std::size_t arm = 0; arm < 3; ++arm) {
    const double turn = 2 * pi * double(arm) / 3;
    const auto vertex = [&](std::size_t i, std::size_t j, double side) {
      const double y = side * double(j) / double(across);
      const double begin = std::fabs(y) / std::sqrt(3.);
      const double x = begin + (length - begin) * double(i) / double(along);
      const Triple p{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn), 0};
      const auto added = vertices.insert({{std::lround(1e6 * p[0]), std::lround(1e6 * p[1])}, shape.points.size()});
      if (added.second) {
        shape.points.push_back(p);
      }
      return added.first->second;
    };
    for (const double side : {-1., 1.}) {
      for (std::size_t i = 0; i < along; ++i) {
        for (std::size_t j = 0; j < across; ++j) {
          Triangle lower{vertex(i, j, side), vertex(i + 1, j, side), vertex(i, j + 1, side)};
          Triangle upper{vertex(i + 1, j, side), vertex(i + 1, j + 1, side), vertex(i, j + 1, side)};
          if (side < 0) {
            std::swap(lower[0], lower[1]);
            std::swap(upper[0], upper[1]);
          }
          shape.triangles.insert(shape.triangles.end(), {lower, upper});
        }
      }
    }
    sheet.ends.push_back({length * std::cos(turn), length * std::sin(turn), 0});
  }
  sheet.half_width = 1;
  sheet.distance_from_middle = [ends = sheet.ends](const Triple& p) {
    double least = norm(p);
    for (const Triple& end : ends) {
      least = std::min(least, distance({{0, 0, 0}, end}, p));
    }
    return least;
  };
  return sheet;
}

namespace internal {

/// The rounded union of `limbs`, half as deep as wide, that ends at the box between `lower` and `upper`.
inline Shape garment(const std::string& name, const std::vector<Limb>& limbs, const Triple& lower, const Triple& upper)
{
  Shape shape = implicit_surface(
      [&](const Triple& p) {
        return distance_from_limbs(limbs, {p[0], 2 * p[1], p[2]});
      },
      lower, upper, 0.2);
  shape.name = name;
  return shape;
}

} // namespace internal

/// A shirt that is open at its hem, its neck and both sleeves: a body.
inline Shape t_shirt()
{
  Shape shape = internal::garment("T-shirt",
                                  {{{0, 0, -2}, {0, 0, 3.7}, 2.4, 2.4},
                                   {{0, 0, 3}, {0, 0, 9}, 1, 1},
                                   {{0, 0, 4.9}, {6, 0, 3.4}, 1, 1},
                                   {{0, 0, 4.9}, {-6, 0, 3.4}, 1, 1}},
                                  {-4.5, -2, 0}, {4.5, 2, 6.9});
  shape.number_of_border_cycles = 4;
  shape.number_of_tips = 4;
  return shape;
}

/// A vest that is open in front and has armholes: a sheet with three wide borders.
inline Shape open_vest()
{
  Shape shape = internal::garment("vest", {{{0, 0, -2}, {0, 0, 3.7}, 2.4, 2.4}}, {-4, -2, 0}, {4, 2, 7});
  std::vector<bool> is_removed;
  for (const Triangle& triangle : shape.triangles) {
    const Triple center = 1 / 3. * (shape.points[triangle[0]] + shape.points[triangle[1]] + shape.points[triangle[2]]);
    const bool is_front = std::fabs(center[0]) < 0.3 && center[1] < 0;
    const bool is_neck = norm(center - Triple{0, 0, 6.1}) < 1.2;
    const bool is_armhole = norm(Triple{std::fabs(center[0]), center[1], center[2]} - Triple{2.3, 0, 4}) < 1.3;
    is_removed.push_back(is_front || is_neck || is_armhole);
  }
  remove_triangles(shape, is_removed);
  shape.number_of_border_cycles = 3;
  return shape;
}

/// The back of a hand: a sheet with five fingers and a wrist.
inline Shape hand_cut_open()
{
  Shape shape = hand(0.12);
  std::vector<bool> is_removed;
  for (const Triangle& triangle : shape.triangles) {
    is_removed.push_back(shape.points[triangle[0]][2] + shape.points[triangle[1]][2] + shape.points[triangle[2]][2] <
                         0);
  }
  remove_triangles(shape, is_removed);
  shape.name = "hand, cut open";
  shape.number_of_border_cycles = 1;
  return shape;
}

/// The largest distance of points on `edges` between `points` from the middle line of `sheet`, relative to half of its
/// width.
inline double max_distance_from_middle(const Sheet_shape& sheet, const std::vector<Triple>& points,
                                       const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  constexpr int parts = 10; // of an edge
  double result = 0;
  for (const auto& [a, b] : edges) {
    for (int i = 0; i <= parts; ++i) {
      const double along = double(i) / parts;
      const Triple point = (1 - along) * points[a] + along * points[b];
      result = std::max(result, sheet.distance_from_middle(point) / sheet.half_width);
    }
  }
  return result;
}

/// The largest distance of an end of the middle line of `sheet` from the nearest of `points`, relative to half of its
/// width; 0 where it has no ends.
inline double max_distance_from_ends(const Sheet_shape& sheet, const std::vector<Triple>& points)
{
  double result = 0;
  for (const Triple& end : sheet.ends) {
    const auto distance = [&end](const Triple& p) { return norm(p - end); };
    const auto nearest = std::min_element(points.begin(), points.end(),
                                          [&](const Triple& a, const Triple& b) { return distance(a) < distance(b); });
    result = std::max(result, distance(*nearest) / sheet.half_width);
  }
  return result;
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
          curved_sheet(),
          y_sheet(6)};
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SHEET_SHAPES_H
