// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of handle loops, tunnel loops and constrictions, on shapes where these are known.

#include "Application/Loop_classes.h"
#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/simple_shapes.h"
#include "support/swept_shapes.h"
#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <boost/dynamic_bitset.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace {

using CSCD::Loop_kind, CSCD::test::pi;
using Loop_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Mesh_loop = CSCD::Surface_loop<Loop_mesh::Point>;
using Polygon = std::vector<CSCD::Vector3>;

std::vector<Mesh_loop> loops_of(const CSCD::test::Shape& shape, unsigned seed = 0)
{
  return CSCD::find_surface_loops(CSCD::test::to_mesh<Loop_mesh>(shape), CSCD::parameters::random_seed(seed));
}

std::vector<Mesh_loop> of_kind(const std::vector<Mesh_loop>& loops, Loop_kind kind)
{
  std::vector<Mesh_loop> result;
  std::copy_if(loops.begin(), loops.end(), std::back_inserter(result),
               [kind](const Mesh_loop& loop) { return loop.kind == kind; });
  return result;
}

CSCD::Vector3 to_vector(const Loop_mesh::Point& point)
{
  return {point.x(), point.y(), point.z()};
}

Polygon to_polygon(const Mesh_loop& loop)
{
  Polygon result;
  result.reserve(loop.points.size());
  for (const auto& point : loop.points) {
    result.push_back(to_vector(point));
  }
  return result;
}

/// The loop a little outside of the surface, or inside by a negative distance.
Polygon pushed_outwards(const Mesh_loop& loop, const CSCD::test::Shape& shape, double distance)
{
  Polygon normals(shape.points.size(), CSCD::Vector3::Zero());
  const auto at = [&](std::size_t v) {
    return CSCD::Vector3(shape.points[v][0], shape.points[v][1], shape.points[v][2]);
  };
  for (const auto& [a, b, c] : shape.triangles) {
    const CSCD::Vector3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    for (const std::size_t v : {a, b, c}) {
      normals[v] += normal;
    }
  }
  Polygon result;
  result.reserve(loop.points.size());
  for (const CSCD::Vector3& point : to_polygon(loop)) {
    std::size_t nearest = 0;
    for (std::size_t v = 0; v < shape.points.size(); ++v) {
      if ((at(v) - point).squaredNorm() < (at(nearest) - point).squaredNorm()) {
        nearest = v;
      }
    }
    result.push_back(point + distance * normals[nearest].normalized());
  }
  return result;
}

/// The linking number of two closed polygons: a sum of solid angles for the pairs of their sides (Gauss).
long linking_number(const Polygon& first, const Polygon& second)
{
  double sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      const CSCD::Vector3 a = first[i] - second[j];
      const CSCD::Vector3 b = first[i] - second[(j + 1) % second.size()];
      const CSCD::Vector3 c = first[(i + 1) % first.size()] - second[(j + 1) % second.size()];
      const CSCD::Vector3 d = first[(i + 1) % first.size()] - second[j];
      // Signed areas of two spherical triangles (van Oosterom and Strackee).
      const auto area = [](const CSCD::Vector3& p, const CSCD::Vector3& q, const CSCD::Vector3& r) {
        const double pn = p.norm();
        const double qn = q.norm();
        const double rn = r.norm();
        return 2 * std::atan2(p.dot(q.cross(r)), pn * qn * rn + p.dot(q) * rn + p.dot(r) * qn + q.dot(r) * pn);
      };
      sum += area(a, b, c) + area(a, c, d);
    }
  }
  return std::lround(sum / (4 * pi));
}

/// Handle loops must be linked with tunnel loops inside the body, in all classes, and with nothing outside of it.
void expect_dual_bases(const CSCD::test::Shape& shape, std::size_t genus)
{
  SCOPED_TRACE(shape.name);
  const std::vector<Mesh_loop> loops = loops_of(shape);
  const std::vector<Mesh_loop> handles = of_kind(loops, Loop_kind::handle);
  const std::vector<Mesh_loop> tunnels = of_kind(loops, Loop_kind::tunnel);
  ASSERT_EQ(genus, handles.size());
  ASSERT_EQ(genus, tunnels.size());
  const double push = 0.02;
  CSCD::internal::Independent_bits rows;
  for (const Mesh_loop& handle : handles) {
    const Polygon curve = to_polygon(handle);
    boost::dynamic_bitset<> row(genus);
    for (std::size_t i = 0; i < genus; ++i) {
      row[i] = linking_number(curve, pushed_outwards(tunnels[i], shape, -push)) % 2 != 0;
      EXPECT_EQ(0, linking_number(curve, pushed_outwards(tunnels[i], shape, push)) % 2);
    }
    EXPECT_TRUE(rows.insert(row));
  }
}

/// A body of revolution about the x axis around the origin, closed by half spheres, of a radius of at most 1.
template <class Radius>
CSCD::test::Shape body_of_revolution(double length, const Radius& radius, std::size_t around)
{
  const std::size_t n = CSCD::test::rings_for(length, 1, around);
  const auto points = CSCD::test::sampled_segment({-length / 2, 0, 0}, {length / 2, 0, 0}, n);
  std::vector<double> radii;
  radii.reserve(n);
  for (const auto& point : points) {
    radii.push_back(radius(point[0]));
  }
  return CSCD::test::swept_shape("body of revolution", points, radii, around, CSCD::test::Tube_end::round);
}

/// One that is about 8 long and 2 wide, and `neck_radius` wide in the middle.
CSCD::test::Shape body_with_neck(double neck_radius, std::size_t around)
{
  return body_of_revolution(
      8, [&](double x) { return 1 - (1 - neck_radius) * std::exp(-2 * x * x); }, around);
}

TEST(Find_surface_loops, torus_has_one_handle_and_one_tunnel_of_known_length)
{
  for (const double minor_radius : {0.3, 1., 1.5}) {
    const std::vector<Mesh_loop> loops = loops_of(CSCD::test::torus(3, minor_radius, 40));
    ASSERT_EQ(2U, loops.size());
    EXPECT_EQ(Loop_kind::handle, loops[0].kind);
    EXPECT_NEAR(loops[0].length, 2 * pi * minor_radius, 0.02 * loops[0].length);
    EXPECT_EQ(Loop_kind::tunnel, loops[1].kind);
    EXPECT_NEAR(loops[1].length, 2 * pi * (3 - minor_radius), 0.02 * loops[1].length);
    for (const Mesh_loop& loop : loops) {
      EXPECT_EQ(0, loop.depth);
      const Polygon polygon = to_polygon(loop);
      double length = 0;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        length += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
        const double from_circle = std::hypot(std::hypot(polygon[i].x(), polygon[i].y()) - 3, polygon[i].z());
        EXPECT_NEAR(minor_radius, from_circle, 0.02 * minor_radius);
      }
      EXPECT_NEAR(length, loop.length, 1e-9);
    }
  }
}

TEST(Find_surface_loops, handles_and_tunnels_are_dual_bases)
{
  expect_dual_bases(CSCD::test::torus(2, 0.7, 30), 1);
  for (const std::size_t genus : {1U, 2U, 4U}) {
    expect_dual_bases(CSCD::test::ladder(genus, 0.2), genus);
  }
}

TEST(Find_surface_loops, linked_and_knotted_rings_have_tunnels)
{
  const std::vector<Mesh_loop> links = loops_of(CSCD::test::chain_of_rings(3, 16));
  EXPECT_EQ(3U, of_kind(links, Loop_kind::handle).size());
  ASSERT_EQ(3U, of_kind(links, Loop_kind::tunnel).size());
  for (const Mesh_loop& tunnel : of_kind(links, Loop_kind::tunnel)) {
    EXPECT_NEAR(tunnel.length, 2 * pi * 0.8, 0.05 * tunnel.length);
  }
  const CSCD::test::Shape knot = CSCD::test::trefoil_knot(0.3, 16);
  expect_dual_bases(knot, 1);
  // Bounding outside, it is unlinked with the middle of the knot.
  const Mesh_loop tunnel = of_kind(loops_of(knot), Loop_kind::tunnel).at(0);
  EXPECT_EQ(0, linking_number(pushed_outwards(tunnel, knot, -0.2), to_polygon(tunnel)) % 2);
}

TEST(Find_surface_loops, surface_that_cuts_itself_has_loops_of_both_kinds)
{
  // A part of the ring is pushed through the opposite wall.
  const std::vector<Mesh_loop> loops = loops_of(moved(CSCD::test::torus(3, 1, 24), [](const CSCD::test::Triple& p) {
    return CSCD::test::Triple{p[0] - 6 * std::exp(-CGAL::square(std::atan2(p[1], p[0])) / 0.15), p[1], p[2]};
  }));
  EXPECT_EQ(1U, of_kind(loops, Loop_kind::handle).size());
  EXPECT_EQ(1U, of_kind(loops, Loop_kind::tunnel).size());
}

TEST(Find_surface_loops, neck_is_a_constriction)
{
  for (const double neck_radius : {0.3, 0.6}) {
    const std::vector<Mesh_loop> loops = loops_of(body_with_neck(neck_radius, 48));
    ASSERT_EQ(1U, loops.size());
    EXPECT_EQ(Loop_kind::constriction, loops[0].kind);
    EXPECT_NEAR(loops[0].length, 2 * pi * neck_radius, 0.02 * loops[0].length);
    // Parallel circles at the greatest distance, three diameters, measured along the profile.
    double x = 0;
    const auto radius = [neck_radius](double at) { return 1 - (1 - neck_radius) * std::exp(-2 * at * at); };
    constexpr double step = 1e-4;
    for (double distance = 0; distance < 6 * neck_radius; x += step) {
      distance += std::hypot(step, radius(x + step) - radius(x));
    }
    EXPECT_NEAR(loops[0].depth, radius(x) / neck_radius - 1, 0.05 * (radius(x) / neck_radius));
    for (const auto& point : loops[0].points) {
      EXPECT_NEAR(0, point.x(), 0.1);
    }
  }
}

TEST(Find_surface_loops, stenosis_of_a_curved_vessel_is_found)
{
  constexpr double bend_radius = 8;
  constexpr double angle = 2;
  constexpr double place = 1.1;
  constexpr double width = 0.1;
  const auto center = [](double a) {
    return CSCD::test::Triple{bend_radius * std::cos(a), bend_radius * std::sin(a), 0};
  };
  for (const double narrowest : {0.4, 0.6}) {
    std::vector<CSCD::test::Triple> points;
    std::vector<double> radii;
    for (double a = 0; a <= angle; a += 0.02) {
      points.push_back(center(a));
      radii.push_back(1 - (1 - narrowest) * std::exp(-CGAL::square((a - place) / width) / 2));
    }
    const std::vector<Mesh_loop> loops =
        loops_of(CSCD::test::swept_shape("vessel", points, radii, 40, CSCD::test::Tube_end::open));
    ASSERT_EQ(1U, loops.size()) << narrowest;
    EXPECT_EQ(Loop_kind::constriction, loops[0].kind);
    EXPECT_NEAR(loops[0].length, 2 * pi * narrowest, 0.02 * loops[0].length);
    EXPECT_GT(loops[0].depth, 0.3);
    // In a bend, parallel curves are a little longer than the circles.
    EXPECT_LT(loops[0].depth, 1.05 / narrowest - 1);
    CSCD::Vector3 middle = CSCD::Vector3::Zero();
    for (const auto& point : loops[0].points) {
      middle += to_vector(point) / double(loops[0].points.size());
    }
    const CSCD::test::Triple wanted = center(place);
    EXPECT_LT((middle - CSCD::Vector3(wanted[0], wanted[1], wanted[2])).norm(), 0.1) << narrowest;
  }
}

TEST(Find_surface_loops, waves_of_a_limb_are_as_deep_as_they_are_high)
{
  // Narrow at 1 and, beyond a rise in the middle, narrower at -1: only the latter is as deep as the body is thick.
  const auto radius = [](double x) {
    return 1 - 0.45 * std::exp(-(x - 1) * (x - 1)) - 0.5 * std::exp(-(x + 1) * (x + 1));
  };
  const std::vector<Mesh_loop> all = CSCD::find_surface_loops(
      CSCD::test::to_mesh<Loop_mesh>(body_of_revolution(10, radius, 40)), CSCD::parameters::default_values(), 0.01);
  ASSERT_EQ(2U, all.size());
  EXPECT_NEAR(all[0].length, 2 * pi * radius(-1), 0.02 * all[0].length);
  EXPECT_GT(all[0].depth, 0.5);
  double rise = 0;
  for (double x = -1; x < 1; x += 1e-3) {
    rise = std::max(rise, radius(x));
  }
  EXPECT_NEAR(all[1].depth, rise / radius(1) - 1, 0.02);
  EXPECT_LT(all[1].depth, CSCD::default_min_constriction_depth);
}

TEST(Find_surface_loops, bodies_that_are_nowhere_constricted_have_no_loops)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::sphere(3), CSCD::test::capsule(6, 1, 24), CSCD::test::tapered_tube(6, 0.4, 1.2, 24),
        CSCD::test::bent_tube(3, 2, 0.6, 24), CSCD::test::tube(6, 1, 24, CSCD::test::Tube_end::open),
        CSCD::test::tetrahedron()}) {
    EXPECT_TRUE(loops_of(shape).empty()) << shape.name;
  }
}

TEST(Find_surface_loops, refuses_what_is_no_surface)
{
  EXPECT_THROW(CSCD::find_surface_loops(Loop_mesh()), CSCD::Input_error);
  Loop_mesh mesh = CSCD::test::to_mesh<Loop_mesh>(CSCD::test::tetrahedron());
  mesh.point(*mesh.vertices().begin()) = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  EXPECT_THROW(CSCD::find_surface_loops(mesh), CSCD::Input_error);
}

} // namespace
