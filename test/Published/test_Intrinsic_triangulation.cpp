// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flips keep the surface, and every edge can be traced, whatever was flipped.

#include "Surface/expect_consistent.h"
#include "Surface/to_indexed_triangles.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::test::Intrinsic_surface;
using CSCD::test::Invariants;
using CSCD::test::Shape;

/// Tries `number` flips of edges drawn from `seed`. \return how many were done
std::size_t flip_randomly(Intrinsic_surface& triangulation, std::size_t number, std::size_t seed)
{
  std::mt19937_64 random(seed);
  std::size_t number_of_flips = 0;
  for (std::size_t i = 0; i < number; ++i) {
    const Index h = Index(random() % triangulation.number_of_halfedges());
    if (triangulation.is_flippable(h)) {
      triangulation.flip(h);
      ++number_of_flips;
    }
  }
  return number_of_flips;
}

void expect_delaunay(const Intrinsic_surface& triangulation)
{
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    ASSERT_TRUE(triangulation.is_delaunay(h)) << "halfedge " << h;
  }
}

TEST(Intrinsic_triangulation, keeps_the_surface_whatever_is_flipped)
{
  for (const Shape& shape :
       {CSCD::test::tetrahedron(), CSCD::test::cube(), CSCD::test::sphere(2), CSCD::test::torus(3, 1, 12),
        CSCD::test::noisy(CSCD::test::sphere(3), 0.3, 1), CSCD::test::double_cone(7),
        CSCD::test::anisotropic_tube(10, 1, 40, 5), CSCD::test::chain_of_rings(2, 8)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Intrinsic_surface triangulation(surface);
    const Invariants invariants(triangulation);
    expect_consistent(triangulation, invariants, 1e-12);
    ASSERT_GT(flip_randomly(triangulation, 2 * surface.number_of_halfedges(), 1), 0u);
    expect_consistent(triangulation, invariants, 1e-6);
    ASSERT_GT(triangulation.make_delaunay(), 0u);
    expect_consistent(triangulation, invariants, 1e-6);
    expect_delaunay(triangulation);
  }
}

/// `shape` with its borders bridged.
Triangulated_surface to_bridged_surface(const Shape& shape)
{
  auto triangles = CSCD::test::to_indexed_triangles(shape);
  const auto pairing = CSCD::check_manifold(triangles, [](Index vertex) { return vertex; });
  CSCD::internal::bridge_borders(triangles, pairing);
  return Triangulated_surface(std::move(triangles));
}

long euler_number(const Intrinsic_surface& triangulation)
{
  long number_of_edges = 0;
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    number_of_edges += triangulation.edge(h) == h;
  }
  return long(triangulation.number_of_vertices()) - number_of_edges + long(triangulation.number_of_faces());
}

std::vector<double> border_lengths(const Intrinsic_surface& triangulation)
{
  std::vector<double> lengths;
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    if (triangulation.is_border(h)) {
      lengths.push_back(triangulation.length(h));
    }
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(Intrinsic_triangulation, keeps_borders)
{
  for (const Shape& shape :
       {CSCD::test::flat_disc(4, 9), CSCD::test::tube(4, 1, 8, CSCD::test::Tube_end::open),
        CSCD::test::with_small_holes(CSCD::test::sphere(2), 4, 1), CSCD::test::slit_tube(6, 1, 12)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = to_bridged_surface(shape);
    ASSERT_LT(surface.first_hole_filling_face(), surface.number_of_faces());
    Intrinsic_surface triangulation(surface, surface.first_hole_filling_face());
    const Invariants invariants(triangulation);
    const std::vector<double> borders = border_lengths(triangulation);
    const long euler = euler_number(triangulation);
    EXPECT_EQ(euler, long(2 - 2 * shape.genus) - long(shape.number_of_border_cycles));
    ASSERT_GT(flip_randomly(triangulation, 2 * surface.number_of_halfedges(), 2), 0u);
    expect_consistent(triangulation, invariants, 1e-6);
    triangulation.make_delaunay();
    expect_consistent(triangulation, invariants, 1e-6);
    expect_delaunay(triangulation);
    EXPECT_EQ(euler_number(triangulation), euler);
    EXPECT_EQ(border_lengths(triangulation), borders);
  }
}

TEST(Intrinsic_triangulation, has_straight_edges_in_the_plane)
{
  const Shape shape = CSCD::test::flat_disc(6, 16);
  const Triangulated_surface surface = to_bridged_surface(shape);
  Intrinsic_surface triangulation(surface, surface.first_hole_filling_face());
  for (int round = 0; round < 2; ++round) {
    for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
      const Vector_3 edge = surface.point(triangulation.target(h)) - surface.point(triangulation.origin(h));
      ASSERT_NEAR(triangulation.length(h), edge.norm(), 1e-9);
      for (const Vector_3& point : CSCD::test::traced_points(triangulation, h)) {
        ASSERT_LT((point - surface.point(triangulation.origin(h))).cross(edge).norm(), 1e-7 * edge.squaredNorm());
      }
    }
    flip_randomly(triangulation, 20 * surface.number_of_halfedges(), 3);
  }
}

TEST(Intrinsic_triangulation, leaves_cocircular_vertices_alone)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::subdivided_cube(3));
  Intrinsic_surface triangulation(surface);
  EXPECT_EQ(triangulation.make_delaunay(), 0u);
}

TEST(Intrinsic_triangulation, has_edges_with_equal_ends)
{
  // Two copies of a triangle, glued along all sides: each of the three flips makes a self-edge.
  Shape pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0.45, 0.8, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  const Triangulated_surface surface = CSCD::test::to_surface(pillow);
  Intrinsic_surface triangulation(surface);
  const Invariants invariants(triangulation);
  ASSERT_TRUE(triangulation.is_flippable(0));
  triangulation.flip(0);
  const Index loop = Intrinsic_surface::previous(0);
  EXPECT_EQ(triangulation.origin(loop), triangulation.target(loop));
  EXPECT_FALSE(triangulation.is_flippable(0)) << "both its faces are one";
  expect_consistent(triangulation, invariants, 1e-9);
  flip_randomly(triangulation, 100, 4);
  expect_consistent(triangulation, invariants, 1e-6);
  triangulation.make_delaunay();
  expect_consistent(triangulation, invariants, 1e-6);
  expect_delaunay(triangulation);
}

TEST(Intrinsic_triangulation, mollifies_degenerate_faces)
{
  Shape shape = CSCD::test::sphere(2);
  const double length = CSCD::test::mean_edge_length(shape);
  shape.points[shape.triangles[0][0]] = shape.points[shape.triangles[0][1]]; // edges and faces of no extent
  const auto [a, b, c] = shape.triangles[100];
  shape.points[a] =
      CSCD::test::operator*(0.5, CSCD::test::operator+(shape.points[b], shape.points[c])); // a face that is a line
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  Intrinsic_surface triangulation(surface);
  EXPECT_GT(triangulation.added_length(), 0);
  EXPECT_LT(triangulation.added_length(), 2e-5 * length);
  for (Index f = 0; f < triangulation.number_of_faces(); ++f) {
    ASSERT_GT(CSCD::test::face_area(triangulation, f), 0);
  }
  const Invariants invariants(triangulation);
  triangulation.make_delaunay();
  expect_delaunay(triangulation);
  expect_consistent(triangulation, invariants, 1e-6);
  const Triangulated_surface sound = CSCD::test::to_surface(CSCD::test::sphere(2));
  EXPECT_EQ(Intrinsic_surface(sound).added_length(), 0);
}

/// A flat torus of one vertex and two faces, spanned by the vectors a and b; its edges are a, b, and a + b.
struct Flat_torus
{
  using Vector_2 = Eigen::Vector2d;

  static Index next(Index halfedge) { return Triangulated_surface::next(halfedge); }
  static Index previous(Index halfedge) { return Triangulated_surface::previous(halfedge); }
  static Index face(Index halfedge) { return Triangulated_surface::face(halfedge); }
  static Index number_of_vertices() { return 1; }
  static Index number_of_faces() { return 2; }
  static Index number_of_halfedges() { return 6; }
  static Index origin(Index) { return 0; }
  // Faces a, b, -(a + b) and a + b, -a, -b.
  static Index twin(Index halfedge) { return std::array<Index, 6>{4, 5, 3, 2, 0, 1}[halfedge]; }
  double length(Index halfedge) const
  {
    const std::array<Vector_2, 3> edges{a, b, a + b};
    return edges[std::array<Index, 6>{0, 1, 2, 2, 0, 1}[halfedge]].norm();
  }

  Vector_2 a{1, 0.1};
  Vector_2 b{0.3, 0.8};
};

TEST(Intrinsic_triangulation, counts_the_crossings_of_lines_on_a_torus_of_one_vertex)
{
  const Flat_torus torus;
  CSCD::internal::Intrinsic_triangulation<Flat_torus> triangulation(torus);
  std::mt19937_64 random(5);
  for (int i = 0; i < 40; ++i) {
    const Index h = Index(random() % 6);
    if (triangulation.is_flippable(h)) {
      triangulation.flip(h);
    }
  }
  CSCD::internal::Edge_trace trace;
  for (Index h = 0; h < 6; ++h) {
    // Each edge is p a + q b for coprime p and q, and crosses r a + s b in |ps - qr| points, of which one is the
    // vertex.
    std::size_t number_of_matches = 0;
    const long most = 60;
    for (long p = 0; p <= most; ++p) {
      for (long q = -most; q <= most; ++q) {
        const bool is_same_length =
            std::fabs((double(p) * torus.a + double(q) * torus.b).norm() - triangulation.length(h)) < 1e-9;
        if (std::gcd(p, q) != 1 || !is_same_length || (p == 0 && q < 0)) {
          continue;
        }
        ++number_of_matches;
        const auto crossings = [](long determinant) { return std::max(0L, std::labs(determinant) - 1); };
        EXPECT_EQ(long(triangulation.number_of_crossings(h)), crossings(q) + crossings(p) + crossings(p - q));
      }
    }
    EXPECT_EQ(number_of_matches, 1u);
    triangulation.trace(h, trace);
    EXPECT_EQ(trace.crossings().size(), triangulation.number_of_crossings(h));
  }
  EXPECT_NEAR(CSCD::test::vertex_angles(triangulation)[0], 2 * CSCD::test::pi, 1e-9);
  triangulation.make_delaunay();
  // Needles of area A and length L lose L^4 / A^2 of the digits: (60^2)^2 * 1e-16, in each of a few flips.
  EXPECT_NEAR(triangulation.length(0) + triangulation.length(1) + triangulation.length(2),
              torus.a.norm() + torus.b.norm() + (torus.a - torus.b).norm(), 1e-7);
}

} // namespace
