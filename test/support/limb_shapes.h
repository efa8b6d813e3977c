// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes with limbs: the rounded union of tapered capsules, whose axes are the true centreline.

#ifndef CSCD_TEST_SUPPORT_LIMB_SHAPES_H
#define CSCD_TEST_SUPPORT_LIMB_SHAPES_H

#include "Shape.h"
#include "implicit_surface.h"
#include "swept_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CSCD::test {

/// A limb: its axis, and its radius at both ends.
using Limb = Centreline_segment;

/// Negative in the union of `limbs`, with fillets where they meet; outside about the distance from it.
inline double distance_from_limbs(const std::vector<Limb>& limbs, const Triple& p)
{
  const double fillet = 0.3; // relative to the radius of the thinner limb
  double value = std::numeric_limits<double>::max();
  for (const Limb& limb : limbs) {
    const double radius = radius_near(limb, p);
    const double other = distance(limb, p) - radius;
    const double overlap = std::fmax(0.0, fillet * radius - std::fabs(value - other));
    value = std::fmin(value, other) - overlap * overlap / (4 * fillet * radius);
  }
  return value;
}

/// The union of `limbs`, with fillets where they meet; triangles about `cell_size` wide.
/// The caller sets the known topology.
inline Shape limb_shape(const std::string& name, const std::vector<Limb>& limbs, double cell_size)
{
  const auto function = [&](const Triple& p) { return distance_from_limbs(limbs, p); };
  Triple lower{1e9, 1e9, 1e9};
  Triple upper{-1e9, -1e9, -1e9};
  for (const Limb& limb : limbs) {
    const double margin = 1.2 * std::fmax(limb.source_radius, limb.target_radius) + 2 * cell_size;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min({lower[axis], limb.source[axis] - margin, limb.target[axis] - margin});
      upper[axis] = std::max({upper[axis], limb.source[axis] + margin, limb.target[axis] + margin});
    }
  }
  Shape shape = implicit_surface(function, lower, upper, cell_size);
  shape.name = name;
  shape.centreline = limbs;
  return shape;
}

/// `number_of_limbs` equal limbs from the origin, evenly around the z axis.
inline Shape star(std::size_t number_of_limbs, double length, double radius, double cell_size)
{
  std::vector<Limb> limbs;
  for (std::size_t i = 0; i < number_of_limbs; ++i) {
    // An irrational start keeps the limbs off the axes of the grid.
    const double angle = 0.2 + 2 * pi * static_cast<double>(i) / static_cast<double>(number_of_limbs);
    limbs.push_back({{0, 0, 0}, {length * std::cos(angle), length * std::sin(angle), 0}, radius, radius});
  }
  Shape shape = limb_shape("star of " + std::to_string(number_of_limbs), limbs, cell_size);
  shape.number_of_tips = number_of_limbs;
  shape.number_of_junctions = 1;
  return shape;
}

/// Three limbs: the smallest branched shape.
inline Shape y_tube(double cell_size)
{
  Shape shape = star(3, 3, 0.4, cell_size);
  shape.name = "Y-tube";
  return shape;
}

/// Six limbs along the axes.
inline Shape jack(double cell_size)
{
  std::vector<Limb> limbs;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double length : {-3.0, 3.0}) {
      Triple end{0, 0, 0};
      end[axis] = length;
      limbs.push_back({{0, 0, 0}, end, 0.4, 0.4});
    }
  }
  Shape shape = limb_shape("jack", limbs, cell_size);
  shape.number_of_tips = 6;
  shape.number_of_junctions = 1;
  return shape;
}

/// A bar with `number_of_teeth` teeth: many junctions in a row.
inline Shape comb(std::size_t number_of_teeth, double cell_size)
{
  const double spacing = 1.2;
  const double last = spacing * static_cast<double>(number_of_teeth - 1);
  std::vector<Limb> limbs{{{-spacing, 0, 0}, {last + spacing, 0, 0}, 0.3, 0.3}};
  for (std::size_t i = 0; i < number_of_teeth; ++i) {
    const double x = spacing * static_cast<double>(i);
    limbs.push_back({{x, 0, 0}, {x, 3, 0}, 0.2, 0.2});
  }
  Shape shape = limb_shape("comb", limbs, cell_size);
  shape.number_of_tips = number_of_teeth + 2;
  return shape;
}

/// A palm with a wrist and five fingers.
inline Shape hand(double cell_size)
{
  std::vector<Limb> limbs{{{0, -3, 0}, {0, 0, 0}, 0.7, 1}};
  for (const double angle : {-0.9, -0.35, 0.0, 0.35, 0.7}) {
    const Triple direction{std::sin(angle), std::cos(angle), 0};
    limbs.push_back({0.3 * direction, 3.6 * direction, 0.35, 0.22});
  }
  Shape shape = limb_shape("hand", limbs, cell_size);
  shape.number_of_tips = 6;
  return shape;
}

/// A trunk that forks in two again and again, limbs getting thinner: 2^(levels - 1) twigs.
inline Shape tree(std::size_t levels, double cell_size)
{
  struct Bud
  {
    Triple foot;
    double angle;
    double length;
    double radius;
  };
  std::vector<Limb> limbs;
  std::vector<Bud> buds{{{0, 0, 0}, pi / 2, 4, 0.5}};
  for (std::size_t level = 0; level < levels; ++level) {
    std::vector<Bud> next;
    for (const Bud& bud : buds) {
      const double z = level % 2 == 0 ? 0.0 : 0.3;
      const Triple end = bud.foot + bud.length * Triple{std::cos(bud.angle), std::sin(bud.angle), z};
      limbs.push_back({bud.foot, end, bud.radius, 0.8 * bud.radius});
      for (const double turn : {-0.6, 0.6}) {
        next.push_back({end, bud.angle + turn, 0.75 * bud.length, 0.7 * bud.radius});
      }
    }
    buds = next;
  }
  Shape shape = limb_shape("tree", limbs, cell_size);
  shape.number_of_tips = 1 + (std::size_t(1) << (levels - 1));
  shape.number_of_junctions = (std::size_t(1) << (levels - 1)) - 1;
  return shape;
}

/// A row of `number_of_holes` square rings sharing their sides: a surface of that genus. With two: a double torus.
inline Shape ladder(std::size_t number_of_holes, double cell_size)
{
  const double side = 2;
  const double radius = 0.35;
  std::vector<Limb> limbs;
  for (std::size_t i = 0; i <= number_of_holes; ++i) {
    const double x = side * static_cast<double>(i);
    limbs.push_back({{x, 0, 0}, {x, side, 0}, radius, radius});
    if (i < number_of_holes) {
      limbs.push_back({{x, 0, 0}, {x + side, 0, 0}, radius, radius});
      limbs.push_back({{x, side, 0}, {x + side, side, 0}, radius, radius});
    }
  }
  Shape shape = limb_shape("ladder of genus " + std::to_string(number_of_holes), limbs, cell_size);
  shape.genus = number_of_holes;
  shape.number_of_tips = 0;
  shape.number_of_junctions = 2 * (number_of_holes - 1);
  return shape;
}

inline Shape double_torus(double cell_size)
{
  Shape shape = ladder(2, cell_size);
  shape.name = "double torus";
  return shape;
}

/// A cup with a handle at x = 1: a wall of thickness 0.2 around the z axis, of radius 1 and height 2.
inline Shape cup(double cell_size)
{
  const auto function = [](const Triple& p) {
    const double radius = std::hypot(p[0], p[1]);
    const double body = std::fmax(radius - 1, std::fabs(p[2] - 1) - 1);
    const double hollow = std::fmax(radius - 0.8, 0.25 - p[2]);
    const double ring = std::hypot(std::hypot(p[0] - 1, p[2] - 1) - 0.5, p[1]) - 0.15;
    return std::fmin(std::fmax(body, -hollow), std::fmax(ring, 0.9 - p[0]));
  };
  const double margin = 2 * cell_size;
  Shape shape = implicit_surface(function, {-1 - margin, -1 - margin, -margin}, {1.65 + margin, 1 + margin, 2 + margin},
                                 cell_size);
  shape.name = "cup";
  shape.genus = 1;
  return shape;
}

/// A ball with a thin tail: sizes that differ by an order of magnitude.
inline Shape ball_with_tail(double cell_size)
{
  Shape shape = limb_shape("ball with tail", {{{0, 0, 0}, {0.1, 0, 0}, 1.5, 1.5}, {{1.4, 0, 0}, {6, 0, 0}, 0.15, 0.15}},
                           cell_size);
  shape.centreline.clear();
  return shape;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_LIMB_SHAPES_H
