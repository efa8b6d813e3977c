// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the measures of skeletons on shapes with known answers, among these the limbs that tips belong to.

#include "support/Shape.h"
#include "support/convert_shape.h"
#include "support/message_of.h"
#include "support/shapes.h"
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Skeleton_graph.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/math/special_functions/ellint_2.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace CSCD::test;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::evaluate_skeleton, CSCD::Limb_measures, CSCD::Skeleton_measures;
namespace parameters = CSCD::parameters;

Mesh mesh_of(const Shape& shape)
{
  return to_mesh<Mesh>(shape);
}

/// A straight skeleton along the x axis, moved by `y`.
Skeleton axis(double from, double to, double y, std::size_t number_of_nodes)
{
  Skeleton skeleton;
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    const double t = double(i) / double(number_of_nodes - 1);
    const std::size_t v = add_vertex(skeleton);
    skeleton[v].point = Point((1 - t) * from + t * to, y, 0);
    if (i > 0) {
      add_edge(v - 1, v, skeleton);
    }
  }
  return skeleton;
}

/// Where the reconstructions do not matter.
const auto coarse = parameters::resolution(20);

TEST(Evaluate_skeleton, centreline_of_a_capsule_is_perfect)
{
  const Shape shape = capsule(8, 1, 48);
  const Skeleton_measures m = evaluate_skeleton(mesh_of(shape), to_skeleton<Skeleton>(shape.centreline));
  EXPECT_EQ(shape.points.size(), m.number_of_points);
  EXPECT_NEAR(std::sqrt(108.), m.diagonal, 1e-6);
  EXPECT_NEAR(8 / m.diagonal, m.counts.length, 1e-12);
  EXPECT_EQ(2u, m.counts.number_of_tips);
  EXPECT_TRUE(m.has_topology_of_surface());
  EXPECT_EQ(1, m.position.fraction_of_nodes_inside);
  EXPECT_EQ(1, m.position.fraction_of_length_inside);
  EXPECT_EQ(0, m.position.max_distance_outside);
  EXPECT_NEAR(0, m.position.offset_by_length, 1e-3);
  EXPECT_NEAR(0, m.position.deviation_by_length, 2e-3);
  EXPECT_NEAR(0, m.counts.mean_turning, 1e-6);
  // The vertices are on the round cones exactly; the triangulation differs by the square of a cell over the radius.
  EXPECT_NEAR(0, m.mean_distance_from_round_cones, 1e-12);
  const double of_a_cell = m.round_cones.cell_size * m.round_cones.cell_size * m.diagonal;
  EXPECT_EQ(0.005, m.round_cones.cell_size);
  EXPECT_LT(m.round_cones.mean, of_a_cell / 4);
  EXPECT_LT(m.round_cones.maximum, of_a_cell);
  EXPECT_LE(m.round_cones.mean * m.round_cones.mean, m.round_cones.mean_square);
  EXPECT_LT(m.round_cones.reverse_mean, 1e-3);
  EXPECT_EQ(0, m.round_cones.unresolved_fraction);
  // Convolution takes 0.6 radii off the ends and is as good elsewhere.
  EXPECT_NEAR(0.4 / m.diagonal, m.convolution.maximum, 0.03 / m.diagonal);
  EXPECT_GT(m.convolution.mean, 10 * m.round_cones.mean);
}

TEST(Evaluate_skeleton, centreline_of_a_torus_is_a_cycle_in_the_middle)
{
  const Shape shape = torus(4, 1, 32);
  const Skeleton skeleton = to_skeleton<Skeleton>(shape.centreline);
  const Skeleton_measures m = evaluate_skeleton(mesh_of(shape), skeleton);
  EXPECT_EQ(1u, m.position.genus);
  EXPECT_EQ(1u, m.counts.betti_number);
  EXPECT_EQ(0u, m.counts.number_of_tips + m.counts.number_of_junctions + m.counts.number_of_isolated_nodes);
  EXPECT_TRUE(m.has_topology_of_surface());
  const double n = double(num_vertices(skeleton));
  EXPECT_NEAR(2 * pi / n, m.counts.max_turning, 1e-9);
  EXPECT_NEAR(1. / 4, m.counts.mean_turning, 0.005); // the radius of the body over that of the circle
  EXPECT_NEAR(0, m.position.offset_by_length, 0.005);
  EXPECT_LT(m.mean_distance_from_round_cones * m.diagonal, 0.01);
  EXPECT_LT(m.round_cones.mean * m.diagonal, 0.01);
  // A bent line swells: towards the center of the torus more of it is near.
  EXPECT_GT(m.convolution.mean, m.round_cones.mean);
  EXPECT_LT(m.convolution.mean * m.diagonal, 0.1);
}

TEST(Evaluate_skeleton, a_tapered_tube_needs_radii_that_vary)
{
  const Shape shape = tapered_tube(10, 0.4, 1.2, 32);
  const Mesh mesh = mesh_of(shape);
  Skeleton skeleton;
  for (const double x : {0., 10.}) {
    const std::size_t v = add_vertex(skeleton);
    skeleton[v].point = Point(x, 0, 0);
    skeleton[v].radius = x == 0 ? 0.4 : 1.2;
  }
  add_edge(0, 1, skeleton);
  const auto own = parameters::use_skeleton_radii(true);
  const Skeleton_measures tapered = evaluate_skeleton(mesh, skeleton, own);
  // Rings of radius r lie r (1 - cos) inside the cone that touches balls of these radii, for the slope of 0.08.
  EXPECT_LT(tapered.mean_distance_from_round_cones * tapered.diagonal, 1.2 * 0.08 * 0.08);
  EXPECT_LT(tapered.round_cones.mean * tapered.diagonal, 0.01);
  EXPECT_NEAR(0, tapered.position.offset_by_length, 1e-3);
  skeleton[0].radius = skeleton[1].radius = 0.8;
  const Skeleton_measures constant = evaluate_skeleton(mesh, skeleton, own);
  EXPECT_NEAR(0.2, constant.mean_distance_from_round_cones * constant.diagonal, 0.05); // |x - 5| 0.08 on the average
  EXPECT_GT(constant.convolution.mean, 2 * tapered.convolution.mean);
}

TEST(Evaluate_skeleton, off_the_axis_of_a_cylinder_the_ray_star_is_known)
{
  const Mesh mesh = mesh_of(tube(20, 1, 48, Tube_end::flat));
  for (const double d : {0.2, 0.5, 0.8}) {
    const Skeleton_measures m = evaluate_skeleton(mesh, axis(2, 18, d, 5), coarse);
    // Rays from a point at distance d of the axis of a unit circle: their mean length is 2/pi E(d), the mean of their
    // vectors d/2, the mean of their squares 1.
    const double mean = 2 / pi * boost::math::ellint_2(d);
    EXPECT_NEAR(d / 2 / mean, m.position.offset_by_length, 2e-3) << d;
    EXPECT_NEAR(std::sqrt(1 - mean * mean) / mean, m.position.deviation_by_length, 2e-3) << d;
  }
}

TEST(Evaluate_skeleton, what_is_outside_is_counted)
{
  const Mesh mesh = mesh_of(tube(10, 1, 64, Tube_end::flat));
  const Skeleton_measures m = evaluate_skeleton(mesh, axis(5, 13, 0, 9), coarse); // five nodes of nine in [5, 10)
  EXPECT_NEAR(5. / 9, m.position.fraction_of_nodes_inside, 0.12);                 // and one on the surface
  EXPECT_NEAR(5. / 8, m.position.fraction_of_length_inside, 0.01);
  EXPECT_NEAR(3 / m.diagonal, m.position.max_distance_outside, 1e-9);
}

TEST(Evaluate_skeleton, borders_are_bridged)
{
  const Shape shape = tube(10, 1, 32, Tube_end::open);
  const Skeleton_measures m = evaluate_skeleton(mesh_of(shape), axis(1, 9, 0, 5), coarse);
  EXPECT_EQ(2u, m.position.number_of_borders);
  EXPECT_EQ(1, m.position.fraction_of_length_inside);
  EXPECT_TRUE(m.has_topology_of_surface());
}

TEST(Evaluate_skeleton, measures_points_too)
{
  const Shape shape = capsule(8, 1, 32);
  const Skeleton skeleton = to_skeleton<Skeleton>(shape.centreline);
  const Skeleton_measures of_mesh = evaluate_skeleton(mesh_of(shape), skeleton);
  std::vector<Point> points;
  CGAL::Point_set_3<Point> point_set;
  for (const Triple& p : shape.points) {
    points.emplace_back(p[0], p[1], p[2]);
    point_set.insert(points.back());
  }
  for (const Skeleton_measures& m :
       {evaluate_skeleton(points, skeleton), evaluate_skeleton(point_set, skeleton),
        evaluate_skeleton(point_set, skeleton, parameters::point_map(point_set.point_map()))}) {
    EXPECT_EQ(points.size(), m.number_of_points);
    EXPECT_NEAR(of_mesh.convolution.mean, m.convolution.mean, 1e-12);
    EXPECT_NEAR(of_mesh.round_cones.mean, m.round_cones.mean, 1e-12);
    EXPECT_GT(m.round_cones.reverse_mean, of_mesh.round_cones.reverse_mean); // the spacing of the points counts
    EXPECT_LT(m.round_cones.reverse_mean * m.diagonal, 0.2);
    EXPECT_TRUE(std::isnan(m.position.fraction_of_nodes_inside));
    EXPECT_FALSE(m.has_topology_of_surface());
  }
}

TEST(Evaluate_skeleton, hubs_and_complete_graphs_are_measured)
{
  const Mesh mesh = mesh_of(capsule(8, 1, 32));
  constexpr std::size_t number_of_nodes = 2450;
  constexpr std::size_t number_of_complete = 60; // all joined
  Skeleton star, complete;
  for (std::size_t v = 0; v < number_of_nodes; ++v) {
    const double angle = 2.4 * double(v); // about the golden angle: spread around the axis
    const double radius = 0.8 * double(v % 7) / 7;
    const double x = 8 * double(v) / number_of_nodes;
    const Point point(x, radius * std::cos(angle), radius * std::sin(angle));
    star[add_vertex(star)].point = v == 0 ? Point(4, 0, 0) : point;
    if (v > 0) {
      add_edge(0, v, star);
    }
    if (v % (number_of_nodes / number_of_complete) == 0) {
      const auto last = add_vertex(complete);
      complete[last].point = point;
      for (auto u = last; u-- > 0;) {
        add_edge(u, last, complete);
      }
    }
  }
  for (const Skeleton* skeleton : {&star, &complete}) {
    const Skeleton_measures m = evaluate_skeleton(mesh, *skeleton, coarse);
    EXPECT_EQ(m.counts.number_of_edges, num_edges(*skeleton));
    EXPECT_EQ(m.counts.betti_number, num_edges(*skeleton) + 1 - num_vertices(*skeleton));
    EXPECT_GT(m.position.fraction_of_length_inside, 0.999);
    EXPECT_LT(m.round_cones.maximum, 1);
  }
}

/// Expects an `Input_error` whose message holds `part`.
template <class Surface>
void expect_refusal(const Surface& surface, const Skeleton& skeleton, const std::string& part,
                    bool uses_own_radii = false, std::size_t resolution = 50)
{
  const std::string message = message_of([&] {
    evaluate_skeleton(surface, skeleton, parameters::use_skeleton_radii(uses_own_radii).resolution(resolution));
  });
  EXPECT_NE(std::string::npos, message.find(part)) << message;
}

TEST(Evaluate_skeleton, refuses_what_cannot_be_measured)
{
  const Shape shape = capsule(8, 1, 12);
  const Mesh mesh = mesh_of(shape);
  const Skeleton skeleton = axis(0, 8, 0, 5);
  expect_refusal(mesh, Skeleton(), "no nodes");
  expect_refusal(Mesh(), skeleton, "no faces");
  expect_refusal(std::vector<Point>(), skeleton, "no points");
  expect_refusal(std::vector<Point>(3, Point(1, 1, 1)), skeleton, "same point");
  expect_refusal(mesh, skeleton, "all radii of the skeleton are 0", true);
  expect_refusal(mesh, skeleton, "resolution", false, 0);
  expect_refusal(mesh, skeleton, "resolution", false, 10001);
  Skeleton changed = skeleton;
  changed[2].point = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_refusal(mesh, changed, "node 2 of the skeleton has a coordinate that is not finite");
  changed[2].point = Point(0, 1e300, 0);
  expect_refusal(mesh, changed, "node 2 of the skeleton is far from the surface");
  changed = skeleton;
  changed[3].radius = -1;
  expect_refusal(mesh, changed, "node 3 of the skeleton has a radius", true);
  changed[3].radius = 1e9;
  expect_refusal(mesh, changed, "node 3 of the skeleton has a radius", true);
  expect_refusal(std::vector<Point>{Point(0, 0, 0), Point(0, std::numeric_limits<double>::infinity(), 0)}, skeleton,
                 "point 1 has a coordinate");
}

TEST(Evaluate_skeleton, edges_without_length_and_repeated_nodes_do_no_harm)
{
  const Shape shape = capsule(8, 1, 12);
  Skeleton skeleton = axis(0, 8, 0, 5);
  for (int i = 0; i < 3; ++i) {
    const std::size_t v = add_vertex(skeleton);
    skeleton[v].point = skeleton[2].point;
    add_edge(2, v, skeleton);
  }
  add_edge(1, 1, skeleton);
  const Skeleton_measures m = evaluate_skeleton(mesh_of(shape), skeleton);
  EXPECT_LT(m.round_cones.mean * m.diagonal, 0.05);
  EXPECT_TRUE(std::isfinite(m.convolution.mean));
  EXPECT_EQ(1u, m.counts.betti_number); // the edge from a node to itself
}

Limb_measures limbs(const Shape& shape, const Skeleton& skeleton)
{
  return evaluate_skeleton(mesh_of(shape), skeleton, parameters::resolution(10)).limbs;
}

/// The limbs of a shape; the skeleton, a node in the middle of the first face, is none of its own.
Limb_measures limbs(const Shape& shape)
{
  Triple middle{0, 0, 0};
  for (const std::size_t corner : shape.triangles.front()) {
    middle = middle + (1. / 3) * shape.points[corner];
  }
  Skeleton skeleton;
  skeleton[add_vertex(skeleton)].point = Point(middle[0], middle[1], middle[2]);
  return limbs(shape, skeleton);
}

TEST(Measure_limbs, bodies_without_limbs_have_none)
{
  for (const Shape& shape : {sphere(3), torus(4, 1, 32), trefoil_knot(0.3, 12), chain_of_rings(3, 16), cube(),
                             subdivided_cube(4), noisy(sphere(3), 0.05, 1), noisy(torus(4, 1, 32), 0.1, 1)}) {
    const Limb_measures m = limbs(shape);
    EXPECT_TRUE(m.limbs.empty()) << shape.name;
    EXPECT_EQ(0u, m.number_of_limbs_without_tip);
    EXPECT_TRUE(std::isnan(m.tip_recall));
    EXPECT_TRUE(std::isnan(m.tip_precision));
  }
}

TEST(Measure_limbs, a_star_has_as_many_as_arms)
{
  for (const std::size_t n : {3, 4, 5, 6}) {
    const Limb_measures m = limbs(star(n, 6, 1, 0.3));
    EXPECT_EQ(n, m.limbs.size());
    EXPECT_EQ(n, m.number_of_limbs_without_tip);
    EXPECT_EQ(0, m.tip_recall);
    for (const CSCD::Surface_limb& limb : m.limbs) {
      // At the end of an arm, which is a half sphere.
      EXPECT_NEAR(7, limb.tip.norm(), 0.1);
    }
  }
}

TEST(Measure_limbs, open_and_closed_ends_are_both_ends)
{
  EXPECT_EQ(2u, limbs(tube(10, 1, 24, Tube_end::open)).limbs.size());
  EXPECT_EQ(2u, limbs(tube(10, 1, 24, Tube_end::flat)).limbs.size());
}

TEST(Measure_limbs, components_count_each_by_itself)
{
  const Shape one = star(3, 6, 1, 0.3);
  const Shape two = merged("two", {one, translated(scaled(one, 0.2), {20, 0, 0})});
  const Limb_measures m = limbs(two, to_skeleton<Skeleton>(one.centreline));
  EXPECT_EQ(6u, m.limbs.size());
  EXPECT_EQ(3u, m.number_of_limbs_without_tip);
  EXPECT_EQ(0.5, m.tip_recall);
  EXPECT_EQ(1, m.tip_precision);
}

TEST(Measure_limbs, the_centreline_has_all_tips_and_no_others)
{
  for (const Shape& shape : {star(3, 6, 1, 0.3), star(5, 6, 1, 0.3), jack(0.2), capsule(8, 1, 24)}) {
    const Limb_measures m = limbs(shape, to_skeleton<Skeleton>(shape.centreline));
    EXPECT_EQ(1, m.tip_recall) << shape.name;
    EXPECT_EQ(1, m.tip_precision) << shape.name;
  }
}

TEST(Measure_limbs, an_arm_left_out_is_missed)
{
  const Shape shape = star(5, 6, 1, 0.3);
  std::vector<Centreline_segment> segments = shape.centreline;
  const Triple tip = segments.front().target;
  segments.erase(segments.begin());
  const Limb_measures m = limbs(shape, to_skeleton<Skeleton>(segments));
  EXPECT_EQ(0.8, m.tip_recall);
  EXPECT_EQ(1, m.tip_precision);
  EXPECT_EQ(1u, m.number_of_limbs_without_tip);
  for (const CSCD::Surface_limb& limb : m.limbs) {
    const double distance = std::hypot(limb.tip.x() - tip[0], limb.tip.y() - tip[1], limb.tip.z() - tip[2]);
    EXPECT_EQ(limb.has_tip, distance > 2);
  }
}

TEST(Measure_limbs, a_tip_half_way_is_none_of_the_limb)
{
  const Shape shape = star(5, 6, 1, 0.3);
  std::vector<Centreline_segment> segments = shape.centreline;
  segments.front().target = 0.25 * segments.front().target;
  const Limb_measures m = limbs(shape, to_skeleton<Skeleton>(segments));
  EXPECT_EQ(0.8, m.tip_recall);
  EXPECT_EQ(0.8, m.tip_precision);
}

TEST(Measure_limbs, a_spur_is_one_tip_too_many_wherever_it_is)
{
  const Shape shape = star(5, 6, 1, 0.3);
  for (const double place : {0.2, 0.9}) {
    std::vector<Centreline_segment> segments = shape.centreline;
    const Triple tip = segments.front().target;
    segments.front().target = place * tip;
    segments.push_back({place * tip, tip, 0, 0});
    segments.push_back({place * tip, place * tip + Triple{0, 0, 0.7}, 0, 0});
    const Limb_measures m = limbs(shape, to_skeleton<Skeleton>(segments));
    EXPECT_EQ(1, m.tip_recall);
    EXPECT_EQ(5. / 6, m.tip_precision);
    EXPECT_EQ(1u, m.number_of_tips_without_limb);
  }
}

} // namespace
