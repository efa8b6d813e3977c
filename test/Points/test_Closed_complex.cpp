// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is connected in a complex of points: without holes, and without bridges between sheets.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Closed_complex;
using CSCD::test::Shape;

/// The faces of `shape` but for every one at a multiple of `period`; all for 0.
Point_complex complex_of(const Shape& shape, std::size_t period)
{
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  std::vector<std::array<Index, 3>> faces;
  for (Index face = 0; face < surface.number_of_faces(); ++face) {
    if (period == 0 || face % period != 0) {
      faces.push_back({surface.origin(3 * face), surface.origin(3 * face + 1), surface.origin(3 * face + 2)});
    }
  }
  std::vector<Vector_3> normals;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    normals.push_back(surface.vertex_normal(vertex));
  }
  return {std::vector<Vector_3>(surface.points()), std::move(normals), faces};
}

/// Twice the number of components less twice the genus.
std::ptrdiff_t euler_number(const Triangulated_surface& surface)
{
  return std::ptrdiff_t(surface.number_of_vertices()) - std::ptrdiff_t(surface.number_of_faces() / 2);
}

TEST(Closed_complex, has_no_holes)
{
  for (const std::size_t period : {0u, 7u, 30u}) {
    EXPECT_EQ(euler_number(Closed_complex(complex_of(CSCD::test::sphere(3), period)).surface()), 2);
    EXPECT_EQ(euler_number(Closed_complex(complex_of(CSCD::test::torus(3, 1, 24), period)).surface()), 0);
  }
}

TEST(Closed_complex, has_no_handles_of_a_few_edges)
{
  EXPECT_EQ(euler_number(Closed_complex(complex_of(CSCD::test::torus(6, 1, 4), 0)).surface()), 2);
}

/// Halves of a torus, which is cut in the middle of one, where this is thin.
TEST(Closed_complex, has_connected_regions)
{
  for (const Shape& shape : {CSCD::test::torus(6, 1, 4), CSCD::test::torus(3, 1, 24)}) {
    const Point_complex complex = complex_of(shape, 30);
    const Closed_complex closed(complex);
    const std::vector<Index> regions =
        closed.regions([&](Index vertex) { return Index(complex.point(vertex).x() > 0 ? 1 : 0); });
    const Triangulated_surface& surface = closed.surface();
    ASSERT_EQ(regions.size(), surface.number_of_vertices());
    EXPECT_EQ(std::set<Index>(regions.begin(), regions.end()), (std::set<Index>{0, 1}));
    CSCD::internal::Disjoint_sets parts(surface.number_of_vertices());
    std::size_t number_of_parts = surface.number_of_vertices();
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      const bool is_within = regions[surface.origin(h)] == regions[surface.target(h)];
      number_of_parts -= is_within && parts.join(surface.origin(h), surface.target(h)) ? 1 : 0;
    }
    EXPECT_EQ(number_of_parts, 2u);
  }
}

} // namespace
