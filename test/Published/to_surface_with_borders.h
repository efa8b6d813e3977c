// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test shape as a triangulation with its borders, without any change of numbers or coordinates.

#ifndef CSCD_TEST_PUBLISHED_TO_SURFACE_WITH_BORDERS_H
#define CSCD_TEST_PUBLISHED_TO_SURFACE_WITH_BORDERS_H

#include "Surface/to_indexed_triangles.h"
#include "support/Shape.h"
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::test {

inline CSCD::Triangulated_surface to_surface_with_borders(const Shape& shape)
{
  CSCD::Indexed_triangles triangles = to_indexed_triangles(shape);
  CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  return {std::move(triangles), std::move(pairing)};
}

/// A flat rectangle of `columns` by `rows` squares of side `side`, each cut in two; the lower left corner is the
/// origin.
inline Shape flat_grid(std::size_t columns, std::size_t rows, double side)
{
  Shape shape;
  shape.name = "flat grid";
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      shape.points.push_back({side * double(i), side * double(j), 0});
    }
  }
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t a = j * (columns + 1) + i;
      const std::size_t b = a + columns + 1;
      shape.triangles.push_back({a, a + 1, b + 1});
      shape.triangles.push_back({a, b + 1, b});
    }
  }
  shape.number_of_border_cycles = 1;
  return shape;
}

/// The values of `function` at the vertices of `shape`.
template <class Function>
std::vector<double> sampled(const Shape& shape, const Function& function)
{
  std::vector<double> values;
  for (const Triple& p : shape.points) {
    values.push_back(function(p));
  }
  return values;
}

} // namespace CSCD::test

#endif // CSCD_TEST_PUBLISHED_TO_SURFACE_WITH_BORDERS_H
