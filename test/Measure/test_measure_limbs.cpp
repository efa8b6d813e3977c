// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the limbs that are found on shapes with known limbs, and of their matching with the tips of a skeleton.

#include "support/Shape.h"
#include "support/convert_shape.h"
#include "support/shapes.h"
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Skeleton_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace CSCD::test;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::Limb_measures;

Limb_measures limbs(const Shape& shape, const Skeleton& skeleton)
{
  const Mesh mesh = to_mesh<Mesh>(shape);
  return CSCD::evaluate_skeleton(mesh, skeleton, CSCD::parameters::resolution(10)).limbs;
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
