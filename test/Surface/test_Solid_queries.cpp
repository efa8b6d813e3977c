// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The answers about the body agree with its known shape.

#include "Surface/to_surface.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Surface/Solid_queries.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using CSCD::Index, CSCD::Triangulated_surface, CSCD::Vector3, CSCD::internal::Solid_queries, CSCD::test::to_surface;

Vector3 random_vector(std::mt19937_64& random, double size)
{
  const double x = CSCD::test::random_signed_unit(random);
  const double y = CSCD::test::random_signed_unit(random);
  return size * Vector3(x, y, CSCD::test::random_signed_unit(random));
}

/// Expects that inside and outside alternate along the segment. \return the distances of the crossings
template <class Is_inside>
std::vector<double> expect_alternation(const Solid_queries& queries, const Vector3& from, const Vector3& to,
                                       const Is_inside& is_inside)
{
  std::vector<double> distances;
  queries.crossings(from, to, distances);
  EXPECT_TRUE(std::is_sorted(distances.begin(), distances.end()));
  for (std::size_t i = 0; i <= distances.size(); ++i) {
    const double last = i == 0 ? 0 : distances[i - 1];
    const double next = i < distances.size() ? distances[i] : (to - from).norm();
    const Vector3 middle = from + (last + next) / 2 * (to - from).normalized();
    EXPECT_EQ(is_inside(middle), is_inside(from) == (i % 2 == 0)) << testing::PrintToString(middle);
  }
  return distances;
}

TEST(Solid_queries, finds_the_middle_behind_faces_edges_and_vertices)
{
  const Triangulated_surface surface = to_surface(CSCD::test::subdivided_cube(3));
  const Solid_queries queries(surface);
  const Vector3 center(0.5, 0.5, 0.5);
  for (int i = 0; i < 27; ++i) {
    const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
    const int number_of_axes = std::abs(x) + std::abs(y) + std::abs(z);
    // Faces are met in the interior of one of their triangles.
    const Vector3 shift(x == 0 ? 0.03 : 0, y == 0 ? 0.06 : 0, z == 0 ? 0.02 : 0);
    const Vector3 aside = number_of_axes == 1 ? shift : Vector3(0, 0, 0);
    for (const double distance : number_of_axes == 0 ? std::vector<double>() : std::vector<double>{1, 1e-3}) {
      const Vector3 point = center + aside + (0.5 + distance) * Vector3(x, y, z);
      const auto middle = queries.middle_behind(point);
      ASSERT_TRUE(middle) << testing::PrintToString(point);
      EXPECT_LT((*middle - center - aside).norm(), 1e-12) << testing::PrintToString(point);
    }
  }
}

TEST(Solid_queries, meets_edges_and_vertices_once)
{
  const Triangulated_surface surface = to_surface(CSCD::test::subdivided_cube(1));
  const Solid_queries queries(surface);
  for (const Vector3& target : surface.points()) {
    const Vector3 center = Vector3::Constant(0.5);
    const auto hit = queries.first_hit(center, target - center);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, (target - center).norm(), 1e-14);
    EXPECT_LE((hit->point - target).norm(), 1e-14 * std::min(hit->point.norm(), target.norm()));
  }
}

TEST(Solid_queries, counts_the_crossings_of_a_segment)
{
  const Triangulated_surface surface = to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 16), 0.1, 1));
  const Solid_queries queries(surface);
  std::mt19937_64 random(4);
  std::size_t most = 0;
  for (int i = 0; i < 500; ++i) {
    const Vector3 from = random_vector(random, 4);
    const Vector3 to = random_vector(random, 4);
    const std::vector<double> distances =
        expect_alternation(queries, from, to, [&](const Vector3& point) { return queries.is_inside(point); });
    most = std::max(most, distances.size() + 1);
    const auto hit = queries.first_hit(from, to - from);
    ASSERT_EQ(hit && hit->distance <= (to - from).norm(), !distances.empty());
    ASSERT_NEAR(distances.empty() ? 0 : hit->distance - distances.front(), 0, 1e-12);
  }
  EXPECT_GE(most, 4u) << "some segments pass through both sides of the ring";
  std::vector<double> distances{1};
  queries.crossings({3, 0, 0}, {3, 0, 0}, distances);
  EXPECT_TRUE(distances.empty());
}

TEST(Solid_queries, agrees_with_every_face_asked_in_turn)
{
  const Triangulated_surface surface = to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 12), 0.2, 1));
  const Solid_queries queries(surface);
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const Vector3 point = random_vector(random, 4);
    const double found = (queries.closest_point(point).point - point).norm();
    const Index any = Index(i) % surface.number_of_faces();
    EXPECT_EQ(found, (queries.closest_point(point, any).point - point).norm()); // for any hint
    // No point of a fine sample of the faces is nearer.
    for (Index f = 0; f < surface.number_of_faces(); ++f) {
      const Vector3& a = surface.point(surface.origin(3 * f));
      const Vector3& b = surface.point(surface.origin(3 * f + 1));
      const Vector3& c = surface.point(surface.origin(3 * f + 2));
      for (const Vector3& sample : {a, Vector3((a + b) / 2), Vector3((a + b + c) / 3)}) {
        ASSERT_LE(found, (sample - point).norm() + 1e-14);
      }
    }
  }
}

TEST(Solid_queries, takes_bodies_that_overlap_for_one)
{
  const CSCD::test::Shape cube = CSCD::test::subdivided_cube(1);
  const CSCD::test::Shape other = CSCD::test::translated(cube, {0.5, 0.25, 0.125});
  for (const bool is_reversed : {false, true}) {
    const CSCD::test::Shape both = CSCD::test::merged("", {cube, other});
    const Triangulated_surface surface = to_surface(is_reversed ? CSCD::test::reversed(both) : both);
    const Solid_queries queries(surface);
    const auto is_in_a_cube = [](const Vector3& point) {
      const Vector3 in_other = point - Vector3(0.5, 0.25, 0.125);
      return (point.minCoeff() > 0 && point.maxCoeff() < 1) || (in_other.minCoeff() > 0 && in_other.maxCoeff() < 1);
    };
    std::mt19937_64 random(6);
    std::size_t number_of_passages = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vector3 from = random_vector(random, 1) + Vector3(0.75, 0.6, 0.55);
      const Vector3 to = random_vector(random, 1) + Vector3(0.75, 0.6, 0.55);
      ASSERT_EQ(queries.is_inside(from), is_in_a_cube(from)) << testing::PrintToString(from);
      const std::vector<double> distances = expect_alternation(queries, from, to, is_in_a_cube);
      number_of_passages += distances.empty() && is_in_a_cube(from) ? 1 : 0;
    }
    EXPECT_GT(number_of_passages, 0u) << "segments within both";
  }
}

TEST(Triangulated_solid, queries_a_level_with_edges_enough_around_thin_limbs)
{
  // Eight edges are around the ring, four on the next level, and two on the first one of at most 60000 vertices.
  const CSCD::test::Shape_solid ring(CSCD::test::torus(1, 0.00022, 8));
  double sum = 0;
  for (int i = 0; i < 100; ++i) {
    const Vector3 center = ring.at(std::cos(i), std::sin(i), 0);
    sum += (ring->queries().closest_point(center).point - center).norm() * ring.unit();
  }
  EXPECT_GT(sum / 100, 0.55 * 0.00022);
}

} // namespace
