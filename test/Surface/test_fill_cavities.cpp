// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The components that bound cavities, and the rest without them.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Halfedge_pairing, CSCD::Index, CSCD::Indexed_triangles, CSCD::internal::Surface_components,
    CSCD::test::reversed, CSCD::test::scaled, CSCD::test::Shape, CSCD::test::sphere, CSCD::test::translated;

/// One character for each component of `parts`, which are joined in this order: 1 for a cavity.
std::string cavities_of(const std::vector<Shape>& parts)
{
  const Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::merged("parts", parts));
  const Surface_components components(triangles);
  std::string result;
  for (const char is_cavity : CSCD::internal::Cavity_search(triangles, components)()) {
    result += is_cavity != 0 ? '1' : '0';
  }
  return result;
}

TEST(Cavity_search, finds_what_faces_inwards_within_a_body)
{
  const Shape body = scaled(sphere(3), 10);
  EXPECT_EQ(cavities_of({body, reversed(scaled(sphere(3), 9.9))}), "01") << "a thin wall";
  EXPECT_EQ(cavities_of({reversed(sphere(2)), body, reversed(translated(sphere(2), {5, 0, 0}))}), "101") << "bubbles";
  EXPECT_EQ(cavities_of({reversed(translated(sphere(3), {9.5, 0, 0})), body}), "00") << "through the surface";
  EXPECT_EQ(cavities_of({body, reversed(translated(sphere(2), {20, 0, 0}))}), "00") << "beside";
  EXPECT_EQ(cavities_of({body, sphere(2)}), "00") << "a body of its own";
  EXPECT_EQ(cavities_of({reversed(body)}), "0");
  EXPECT_EQ(cavities_of({reversed(body), reversed(sphere(2))}), "00");
}

TEST(Cavity_search, finds_the_void_around_another_body)
{
  const Shape body = scaled(sphere(3), 10);
  const Shape bubble = reversed(translated(sphere(2), {8.5, 0, 0}));
  EXPECT_EQ(cavities_of({body, reversed(scaled(sphere(3), 6)), sphere(2), bubble}), "0101");
}

TEST(fill_cavities, leaves_the_body_as_it_is)
{
  const Shape body = scaled(sphere(3), 10);
  const Shape bubble = reversed(sphere(2));
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::merged("body", {bubble, body}));
  const Indexed_triangles before = triangles;
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Surface_components components(triangles);
  const CSCD::internal::Filled_cavities filled =
      CSCD::internal::fill_cavities(triangles, pairing, components, triangles.points.size());
  EXPECT_EQ(filled.number, 1U);
  EXPECT_EQ(components.number(), 1U);
  EXPECT_EQ(triangles.faces.size(), body.triangles.size());
  EXPECT_EQ(triangles.first_hole_filling_face, triangles.faces.size());
  std::vector<Index> numbers(bubble.points.size());
  std::iota(numbers.begin(), numbers.end(), Index(0));
  EXPECT_EQ(filled.vertices, numbers);
  ASSERT_EQ(filled.old_number.size(), triangles.points.size());
  for (std::size_t i = 0; i < triangles.points.size(); ++i) {
    EXPECT_EQ(triangles.points[i], before.points[filled.old_number[i]]);
  }
  EXPECT_FALSE(CSCD::Triangulated_surface(std::move(triangles), std::move(pairing)).has_defect());
}

} // namespace
