// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of the surface depend on its shape alone: not on the numbers of the input, nor on its pose.

#include "Surface/to_indexed_triangles.h"
#include "support/Similarity.h"
#include "support/shapes.h"
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Vector_3;
using CSCD::internal::Canonical_order;
using CSCD::internal::Surface_components;
using CSCD::test::Shape;

struct Ordered
{
  explicit Ordered(const Shape& shape) : triangles(CSCD::test::to_indexed_triangles(shape))
  {
    const Halfedge_pairing pairing(triangles.faces, triangles.points.size());
    order = CSCD::internal::canonical_order(triangles, pairing, Surface_components(triangles));
    CSCD::renumber(triangles, order.vertices);
  }

  Indexed_triangles triangles;
  Canonical_order order;
};

/// Bodies without any symmetry.
std::vector<Shape> irregular_shapes()
{
  return {CSCD::test::noisy(CSCD::test::sphere(3), 0.2, 1), CSCD::test::noisy(CSCD::test::torus(3, 1, 16), 0.2, 2),
          CSCD::test::merged(
              "two", {CSCD::test::noisy(CSCD::test::sphere(2), 0.2, 3),
                      CSCD::test::noisy(CSCD::test::translated(CSCD::test::capsule(4, 0.7, 12), {5, 1, 0}), 0.2, 4)})};
}

TEST(canonical_order, is_a_permutation_component_by_component)
{
  const Ordered ordered(
      CSCD::test::merged("two", {CSCD::test::cube(), CSCD::test::translated(CSCD::test::sphere(1), {9, 0, 0})}));
  std::vector<Index> sorted = ordered.order.vertices;
  std::sort(sorted.begin(), sorted.end());
  for (Index i = 0; i < sorted.size(); ++i) {
    ASSERT_EQ(sorted[i], i);
  }
  ASSERT_EQ(ordered.order.component_begin, (std::vector<Index>{0, 42, 50})) << "the larger component comes first";
  for (const auto& face : ordered.triangles.faces) {
    EXPECT_EQ(face[0] < 42, *std::max_element(face.begin(), face.end()) < 42);
  }
}

TEST(canonical_order, begins_at_the_farthest_vertex_and_its_ring)
{
  const Ordered ordered(CSCD::test::ellipsoid({5, 1, 1.1}, 3));
  EXPECT_NEAR(std::abs(ordered.triangles.points[0].x()), ordered.triangles.points[0].norm(), 0.1);
  std::vector<bool> is_neighbor(ordered.triangles.points.size(), false);
  std::size_t degree = 0;
  for (const auto& face : ordered.triangles.faces) {
    if (face[0] == 0) {
      is_neighbor[face[1]] = is_neighbor[face[2]] = true;
      ++degree;
    }
  }
  EXPECT_EQ(std::count(is_neighbor.begin() + 1, is_neighbor.begin() + 1 + std::ptrdiff_t(degree), true),
            std::ptrdiff_t(degree));
}

TEST(canonical_order, does_not_depend_on_the_numbers_of_the_input)
{
  std::vector<Shape> shapes = irregular_shapes();
  // Symmetric ones too: ties are decided by position, not by number.
  shapes.push_back(CSCD::test::cube());
  shapes.push_back(CSCD::test::sphere(2));
  shapes.push_back(CSCD::test::chain_of_rings(3, 12));
  for (const Shape& shape : shapes) {
    const Ordered expected(shape);
    for (std::size_t seed : {1u, 2u, 3u}) {
      const auto renumbered = CSCD::test::renumbered(shape, seed);
      const Ordered ordered(renumbered.shape);
      ASSERT_EQ(ordered.triangles.points, expected.triangles.points) << shape.name;
      ASSERT_EQ(ordered.triangles.faces, expected.triangles.faces) << shape.name;
      for (std::size_t i = 0; i < expected.order.vertices.size(); ++i) {
        ASSERT_EQ(ordered.order.vertices[i], renumbered.new_number[expected.order.vertices[i]]) << shape.name;
      }
    }
  }
}

TEST(canonical_order, goes_around_each_vertex_from_the_one_that_found_it)
{
  const Ordered ordered(CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.2, 5));
  const Halfedge_pairing pairing(ordered.triangles.faces, ordered.triangles.points.size());
  Index next = 1;
  for (Index vertex = 0; vertex < ordered.triangles.points.size(); ++vertex) {
    std::vector<Index> ring;
    for (const Index h : pairing.outgoing()[vertex]) {
      ring.push_back(ordered.triangles.faces[h / 3][(h + 1) % 3]);
    }
    // The parent is the neighbor of the smallest number; the root begins with vertex 1.
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    for (const Index neighbor : ring) {
      EXPECT_LE(neighbor, next);
      next = std::max(next, neighbor + 1);
    }
  }
  EXPECT_EQ(next, ordered.triangles.points.size());
}

TEST(canonical_order, does_not_depend_on_the_pose)
{
  const CSCD::test::Similarity similarity{7.3, CSCD::test::unit({1, 2, -0.5}), 1.1, {10, -3, 4}};
  for (const Shape& shape : irregular_shapes()) {
    const Ordered expected(shape);
    const Ordered ordered(CSCD::test::moved(shape, similarity));
    EXPECT_EQ(ordered.order.vertices, expected.order.vertices) << shape.name;
    EXPECT_EQ(ordered.triangles.faces, expected.triangles.faces) << shape.name;
  }
}

TEST(renumber, sorts_faces_and_keeps_bridging_ones_last)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::cube());
  triangles.first_hole_filling_face = 9;
  CSCD::renumber(triangles, {7, 6, 5, 4, 3, 2, 1, 0});
  EXPECT_TRUE(std::is_sorted(triangles.faces.begin(), triangles.faces.begin() + 9));
  EXPECT_TRUE(std::is_sorted(triangles.faces.begin() + 9, triangles.faces.end()));
  for (const auto& face : triangles.faces) {
    EXPECT_LT(face[0], std::min(face[1], face[2]));
  }
  EXPECT_EQ(triangles.points[0], Vector_3(1, 1, 1));
  const CSCD::internal::Surface_components components(triangles);
  EXPECT_NEAR(components.measures[0].volume, 1, 1e-14) << "faces keep their orientation";
}

} // namespace
