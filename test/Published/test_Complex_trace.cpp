// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges that curves around tubes cross: they cut, on manifolds and others.

#include "Points/to_point_complex.h"
#include "Surface/edge_ways.h"
#include "Surface/joined_shell.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Curve_trace.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Vector_3;
using CSCD::internal::Complex_trace;
using CSCD::internal::Projected_point;
using CSCD::test::pi;
using CSCD::test::Tube_end;

/// A curve around the x axis that sways along it; the positive direction of x is on its left.
std::vector<Projected_point> curve_around_tube(const Point_complex& complex, double x, double sway,
                                               std::size_t number_of_points)
{
  std::vector<Projected_point> curve;
  for (std::size_t i = 0; i < number_of_points; ++i) {
    const double angle = 2 * pi * double(i) / double(number_of_points);
    const Vector_3 normal(0, std::cos(angle), std::sin(angle));
    const Vector_3 point = normal + Vector_3((x + sway * std::sin(2 * angle)), 0, 0);
    curve.push_back({point, normal, CSCD::test::nearest_vertex(complex, point)});
  }
  return curve;
}

/// Expects that `crossings` cut a tube, near a curve at `x`, with the larger part of the x axis on the left.
void expect_cut(const Point_complex& complex, const std::vector<Edge_crossing>& crossings, double x, double width)
{
  ASSERT_GE(crossings.size(), 3u);
  EXPECT_TRUE(CSCD::test::separates(complex, crossings, CSCD::test::anywhere));
  std::set<Index> edges;
  for (const Edge_crossing& crossing : crossings) {
    EXPECT_TRUE(edges.insert(complex.edge(crossing.halfedge)).second) << "every edge once";
    EXPECT_GT(crossing.position, 0);
    EXPECT_LT(crossing.position, 1);
    EXPECT_NEAR(CSCD::internal::crossing_point(complex, crossing).x(), x, width);
    EXPECT_LT(complex.point(complex.origin(crossing.halfedge)).x(), x + width);
    EXPECT_GT(complex.point(complex.target(crossing.halfedge)).x(), x - width);
  }
}

/// How often the crossings go around the x axis, in order.
double turns(const Point_complex& complex, const std::vector<Edge_crossing>& crossings)
{
  double sum = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Vector_3 a = CSCD::internal::crossing_point(complex, crossings[i]);
    const Vector_3 b = CSCD::internal::crossing_point(complex, crossings[(i + 1) % crossings.size()]);
    sum += std::atan2(a.y() * b.z() - a.z() * b.y(), a.y() * b.y() + a.z() * b.z());
  }
  return sum / (2 * pi);
}

TEST(Complex_trace, cuts_tubes_where_the_curve_is)
{
  const CSCD::test::Shape tube = CSCD::test::tube(10, 1, 24, Tube_end::flat);
  for (const Point_complex& complex :
       {CSCD::test::to_point_complex(tube), CSCD::test::to_point_complex(CSCD::test::noisy(tube, 0.2, 1)),
        CSCD::test::to_point_complex(CSCD::test::sampled(tube, 2000, 1))}) {
    Complex_trace trace(complex);
    for (const std::size_t number_of_points : {16u, 30u, 200u}) {
      for (const double sway : {0., 0.4}) {
        SCOPED_TRACE(number_of_points);
        std::vector<Edge_crossing> crossings;
        ASSERT_TRUE(trace(curve_around_tube(complex, 5.03, sway, number_of_points), crossings));
        expect_cut(complex, crossings, 5.03, sway + 2 * complex.mean_edge_length());
        EXPECT_NEAR(turns(complex, crossings), 1, 1e-9);
      }
    }
  }
}

TEST(Complex_trace, crosses_the_same_edges_the_other_way)
{
  const Point_complex complex =
      CSCD::test::to_point_complex(CSCD::test::sampled(CSCD::test::tube(10, 1, 24, Tube_end::flat), 2000, 1));
  std::vector<Projected_point> curve = curve_around_tube(complex, 5, 0.3, 50);
  Complex_trace trace(complex);
  std::vector<Edge_crossing> crossings;
  ASSERT_TRUE(trace(curve, crossings));
  std::reverse(curve.begin(), curve.end());
  std::vector<Edge_crossing> mirrored;
  ASSERT_TRUE(trace(curve, mirrored));
  ASSERT_EQ(mirrored.size(), crossings.size());
  std::set<std::pair<Index, long>> found;
  for (const Edge_crossing& crossing : crossings) {
    found.insert({crossing.halfedge, std::lround(1e6 * crossing.position)});
  }
  for (const Edge_crossing& crossing : mirrored) {
    EXPECT_EQ(found.count({complex.twin(crossing.halfedge), std::lround(1e6 * (1 - crossing.position))}), 1u);
  }
  EXPECT_NEAR(turns(complex, mirrored), -1, 1e-9);
}

TEST(Complex_trace, cuts_what_is_no_manifold)
{
  // Every pair of faces also has the other diagonal: all edges have four triangles or more, which meet in space.
  const CSCD::test::Shape tube = CSCD::test::noisy(CSCD::test::tube(10, 1, 16, Tube_end::flat), 0.2, 1);
  const Point_complex manifold = CSCD::test::to_point_complex(tube);
  std::set<std::array<Index, 3>> triangles; // each from its smallest vertex
  const auto add = [&triangles](std::array<Index, 3> triangle) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.insert(triangle);
  };
  std::vector<Index> apex(manifold.number_of_halfedges());
  for (Index face = 0; face < manifold.number_of_faces(); ++face) {
    const std::array<Index, 3> vertices = manifold.face_vertices(face);
    add(vertices);
    for (std::size_t i = 0; i < 3; ++i) {
      apex[manifold.face_halfedges(face)[i]] = vertices[(i + 2) % 3];
    }
  }
  for (Index h = 0; h < manifold.number_of_halfedges(); ++h) {
    add({manifold.origin(h), apex[manifold.twin(h)], apex[h]});
  }
  std::vector<Vector_3> normals;
  for (Index vertex = 0; vertex < manifold.number_of_vertices(); ++vertex) {
    normals.push_back(manifold.normal(vertex));
  }
  const Point_complex complex(std::vector<Vector_3>(manifold.points()), std::move(normals),
                              {triangles.begin(), triangles.end()});
  ASSERT_GT(complex.number_of_halfedges(), 19 * manifold.number_of_halfedges() / 10);
  Complex_trace trace(complex);
  for (double x = 2; x < 8; x += 0.37) {
    std::vector<Edge_crossing> crossings;
    ASSERT_TRUE(trace(curve_around_tube(complex, x, 0.3, 40), crossings));
    expect_cut(complex, crossings, x, 0.3 + 3 * manifold.mean_edge_length());
  }
}

TEST(Complex_trace, keeps_to_its_sheet)
{
  // A pipe with a wall that is thinner than its points are apart.
  const CSCD::test::Shape outer = CSCD::test::tube(10, 1, 24, Tube_end::flat);
  const CSCD::test::Shape inner = CSCD::test::moved(outer, [](const CSCD::test::Triple& p) {
    return CSCD::test::Triple{p[0], 0.9 * p[1], 0.9 * p[2]};
  });
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::joined_shell(outer, inner, 8));
  const std::size_t size = complex.number_of_vertices() / 2;
  std::vector<Edge_crossing> crossings;
  ASSERT_TRUE(Complex_trace(complex)(curve_around_tube(complex, 5.03, 0.2, 40), crossings));
  for (const Edge_crossing& crossing : crossings) {
    EXPECT_TRUE(complex.origin(crossing.halfedge) < size || complex.target(crossing.halfedge) < size);
  }
  EXPECT_TRUE(CSCD::test::separates(complex, crossings, [&](Index vertex) { return vertex < size; }));
}

TEST(Complex_trace, cuts_through_vertices_with_wrong_normals)
{
  const Point_complex right = CSCD::test::to_point_complex(CSCD::test::tube(10, 1, 24, Tube_end::flat));
  std::vector<Vector_3> normals;
  std::vector<std::array<Index, 3>> triangles;
  for (Index vertex = 0; vertex < right.number_of_vertices(); ++vertex) {
    normals.push_back((vertex % 10 == 0 ? -1. : 1.) * right.normal(vertex));
  }
  for (Index face = 0; face < right.number_of_faces(); ++face) {
    triangles.push_back(right.face_vertices(face));
  }
  const Point_complex complex(std::vector<Vector_3>(right.points()), std::move(normals), triangles);
  Complex_trace trace(complex);
  for (double x = 2; x < 8; x += 0.37) {
    std::vector<Edge_crossing> crossings;
    ASSERT_TRUE(trace(curve_around_tube(complex, x, 0.3, 40), crossings));
    expect_cut(complex, crossings, x, 0.3 + 2 * complex.mean_edge_length());
  }
}

/// The crossings of a curve around a sampled tube from which a strip is missing. \return whether they go around
bool trace_around_gap(double width, std::vector<Edge_crossing>& crossings)
{
  // Points of a mesh, with triangles across the gap left out.
  CSCD::test::Shape tube = CSCD::test::tube(10, 1, 48, Tube_end::flat);
  std::vector<bool> is_removed;
  for (const CSCD::test::Triangle& t : tube.triangles) {
    is_removed.push_back(std::all_of(t.begin(), t.end(), [&](std::size_t vertex) {
      const CSCD::test::Triple& p = tube.points[vertex];
      return p[2] > 0 && std::abs(p[1]) < width / 2 && std::abs(p[0] - 5) < 2;
    }));
  }
  CSCD::test::remove_triangles(tube, is_removed);
  const Point_complex complex = CSCD::test::to_point_complex(tube);
  Complex_trace trace(complex);
  const bool goes_around = trace(curve_around_tube(complex, 5.03, 0, 60), crossings);
  EXPECT_TRUE(CSCD::test::separates(complex, crossings,
                                    [&](Index vertex) { return std::abs(complex.point(vertex).x() - 5) < 1; }));
  return goes_around;
}

TEST(Complex_trace, leads_over_narrow_holes_only)
{
  std::vector<Edge_crossing> crossings;
  EXPECT_TRUE(trace_around_gap(0, crossings));
  const std::size_t number = crossings.size();
  EXPECT_TRUE(trace_around_gap(0.8, crossings));
  EXPECT_LT(crossings.size(), number);
  EXPECT_FALSE(trace_around_gap(1.6, crossings));
}

TEST(Complex_trace, refuses_what_crosses_nothing)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::cube());
  const Index vertex = 0;
  const std::vector<Projected_point> point(3, {complex.point(vertex), complex.normal(vertex), vertex});
  Complex_trace trace(complex);
  std::vector<Edge_crossing> crossings;
  EXPECT_FALSE(trace(point, crossings));
}

} // namespace
