// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generated shapes with about a given number of vertices.

#ifndef CSCD_BENCHMARK_SUPPORT_GENERATED_SHAPES_H
#define CSCD_BENCHMARK_SUPPORT_GENERATED_SHAPES_H

#include "limb_shapes.h"
#include "shape_operations.h"
#include "swept_shapes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CSCD::benchmark {

/// The number of edges around a tube that has so many vertices on every `area` squared radii of its surface.
inline std::size_t edges_around(std::int64_t number_of_vertices, double area)
{
  const double edge_length = std::sqrt(area / double(number_of_vertices));
  return std::size_t(std::lround(2 * test::pi / edge_length));
}

inline test::Shape make_torus(std::int64_t number_of_vertices)
{
  const double area = 4 * test::pi * test::pi * 3;
  return test::torus(3, 1, edges_around(number_of_vertices, area));
}

inline test::Shape make_knot(std::int64_t number_of_vertices)
{
  constexpr double radius = 0.4;
  constexpr double length = 32; // of the knot's curve
  return test::trefoil_knot(radius, edges_around(number_of_vertices, 2 * test::pi * length / radius));
}

/// Five limbs; its sizes are those of repeated subdivision.
inline test::Shape make_star(std::int64_t number_of_vertices)
{
  test::Shape shape = test::star(5, 3, 0.35, 0.22);
  while (2 * std::int64_t(shape.points.size()) < number_of_vertices) {
    shape = test::midpoint_subdivided(shape);
  }
  return shape;
}

/// A shape by name, at any size.
struct Sized_shape
{
  const char* name;
  test::Shape (*make)(std::int64_t number_of_vertices);
};

inline constexpr Sized_shape generated_shapes[] = {{"torus", make_torus}, {"knot", make_knot}, {"star", make_star}};

} // namespace CSCD::benchmark

#endif // CSCD_BENCHMARK_SUPPORT_GENERATED_SHAPES_H
