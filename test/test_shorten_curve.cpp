// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesics in one call, on meshes of CGAL.

#include "archetypes/Point_archetype.h"
#include "archetypes/Triangle_mesh_archetype.h"
#include "support/convert_shape.h"
#include "support/message_of.h"
#include "support/shapes.h"
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/shorten_curve.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace {

using CSCD::Shortening_outcome, CSCD::test::pi;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

double length(const std::vector<Point>& points, bool is_closed)
{
  double sum = 0;
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < points.size(); ++i) {
    sum += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
  }
  return sum;
}

TEST(shorten_curve, makes_a_straight_line_on_an_unrolled_open_tube)
{
  constexpr unsigned around = 12;
  // In any unit, far from the origin, and with a vertex that has no face.
  for (const double unit : {1., 1e-6, 1e6}) {
    SCOPED_TRACE(unit);
    CSCD::test::Shape shape = CSCD::test::tube(6, 1, around, CSCD::test::Tube_end::open);
    shape = CSCD::test::scaled(CSCD::test::translated(shape, {10, 20, 30}), unit);
    Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
    mesh.add_vertex(Point(0, 0, 0));
    std::vector<Vertex> curve;
    for (unsigned k = 0; k <= 4; ++k) {
      curve.emplace_back(2 * around + k);
    }
    for (unsigned ring = 3; ring <= 8; ++ring) {
      curve.emplace_back(ring * around + 4);
    }
    std::vector<Point> points;
    EXPECT_EQ(CSCD::shorten_curve(mesh, curve, false, std::back_inserter(points)), Shortening_outcome::straight);
    EXPECT_EQ(points.front(), mesh.point(curve.front()));
    EXPECT_EQ(points.back(), mesh.point(curve.back()));
    const double across = 4 * 2 * unit * std::sin(pi / around);
    const double along = mesh.point(curve.back()).x() - mesh.point(curve.front()).x();
    EXPECT_NEAR(length(points, false), std::hypot(across, along), 1e-8 * unit);
  }
}

TEST(shorten_curve, finds_a_ring_of_a_tube_and_a_point_of_a_sphere)
{
  constexpr unsigned around = 12;
  const Mesh tube = CSCD::test::to_mesh<Mesh>(CSCD::test::tube(6, 1, around, CSCD::test::Tube_end::open));
  std::vector<Vertex> loop;
  for (unsigned k = 0; k < around; ++k) {
    loop.emplace_back(4 * around + k);
  }
  loop.back() = Vertex(5 * around + around - 1);
  loop.insert(loop.end(), {Vertex(5 * around)});
  std::vector<Point> points;
  EXPECT_EQ(CSCD::shorten_curve(tube, loop, true, std::back_inserter(points)), Shortening_outcome::straight);
  EXPECT_NEAR(length(points, true), around * 2 * std::sin(pi / around), 1e-9);
  const Mesh sphere = CSCD::test::to_mesh<Mesh>(CSCD::test::sphere(2));
  const auto face = *sphere.faces_begin();
  std::vector<Vertex> corners;
  for (const Vertex vertex : sphere.vertices_around_face(sphere.halfedge(face))) {
    corners.push_back(vertex);
  }
  points.clear();
  EXPECT_EQ(CSCD::shorten_curve(sphere, corners, true, std::back_inserter(points)), Shortening_outcome::collapsed);
  EXPECT_TRUE(points.empty());
}

TEST(shorten_curve, refuses_curves_that_are_not_along_edges)
{
  const Mesh tube = CSCD::test::to_mesh<Mesh>(CSCD::test::tube(6, 1, 12, CSCD::test::Tube_end::open));
  std::vector<Point> points;
  const auto message = [&](const std::vector<Vertex>& curve) {
    return CSCD::test::message_of([&] { CSCD::shorten_curve(tube, curve, false, std::back_inserter(points)); });
  };
  EXPECT_TRUE(CSCD::test::names(message({Vertex(0), Vertex(1), Vertex(30)}), "vertex 1 of the curve"));
  // Only an edge of the faces that bridge a border.
  EXPECT_TRUE(CSCD::test::names(message({Vertex(0), Vertex(2)}), "vertex 0 of the curve"));
  EXPECT_TRUE(points.empty());
}

TEST(shorten_curve, asks_for_no_vertex_point_map_beside_the_one_that_is_given)
{
  const CSCD::test::Shape shape = CSCD::test::tube(6, 1, 12, CSCD::test::Tube_end::open);
  const CSCD::test::Triangle_mesh_archetype mesh(shape);
  std::vector<CSCD::test::Triangle_mesh_archetype::Vertex> curve;
  for (std::size_t k = 0; k < 4; ++k) {
    curve.emplace_back(24 + k);
  }
  std::vector<CSCD::test::Point_archetype> points;
  const auto outcome =
      CSCD::shorten_curve(mesh, curve, false, std::back_inserter(points),
                          CSCD::parameters::vertex_point_map(CSCD::test::Vertex_point_map_archetype(mesh)));
  EXPECT_EQ(outcome, Shortening_outcome::straight);
  EXPECT_EQ(points.size(), 4u) << "it runs along a ring already";
}

TEST(Curve_shortening, shortens_several_curves_of_one_mesh)
{
  const Mesh tube = CSCD::test::to_mesh<Mesh>(CSCD::test::tube(6, 1, 12, CSCD::test::Tube_end::open));
  CSCD::Curve_shortening<Mesh> shortening(tube);
  for (const unsigned ring : {2u, 4u, 2u}) {
    const std::vector<Vertex> curve{Vertex(12 * ring), Vertex(12 * ring + 1), Vertex(12 * ring + 2)};
    std::vector<Point> together;
    std::vector<Point> alone;
    EXPECT_EQ(shortening.shorten<Point>(curve, false, std::back_inserter(together)), Shortening_outcome::straight);
    EXPECT_EQ(CSCD::shorten_curve(tube, curve, false, std::back_inserter(alone)), Shortening_outcome::straight);
    EXPECT_EQ(together, alone);
  }
}

} // namespace
