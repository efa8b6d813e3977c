// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of descriptions of shapes and of finding their classes.

#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/swept_shapes.h"
#include <CSCD/Application/classify_shapes.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

using Class_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

CSCD::Shape_description description_of(const CSCD::test::Shape& shape, CSCD::Shape_descriptor descriptor)
{
  const Class_mesh mesh = CSCD::test::to_mesh<Class_mesh>(shape);
  CSCD::Skeleton_graph<Class_mesh::Point, Class_mesh::Vertex_index> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  return CSCD::describe_shape(mesh, skeleton, descriptor);
}

TEST(Describe_shape, does_not_depend_on_the_scale)
{
  const CSCD::test::Shape star = CSCD::test::star(4, 4, 0.5, 0.2);
  for (const auto descriptor : {CSCD::Shape_descriptor::diameter, CSCD::Shape_descriptor::skeleton}) {
    const double distance = CSCD::shape_distance(description_of(star, descriptor),
                                                 description_of(CSCD::test::scaled(star, 1. / 1024), descriptor));
    EXPECT_NEAR(distance, 0, 1e-6); // distances along skeletons are sums of floats
  }
}

TEST(Describe_shape, distance_of_two_tubes_is_that_of_their_thickness)
{
  // Both are as thick everywhere, so that all quantiles differ by the same.
  const auto description = [](double minor_radius) {
    return description_of(CSCD::test::torus(6, minor_radius, 32), CSCD::Shape_descriptor::diameter);
  };
  const auto value = [](double r) {
    return std::log(0.01 + 2 * r / std::sqrt(4 * CSCD::test::pi * CSCD::test::pi * 6 * r));
  };
  EXPECT_NEAR(CSCD::shape_distance(description(1), description(0.5)), value(1) - value(0.5), 0.02);
}

TEST(Describe_shape, limbs_tell_more_than_thickness)
{
  // Limbs of one thickness and one length in all.
  const CSCD::test::Shape few = CSCD::test::star(3, 8, 0.5, 0.2);
  const CSCD::test::Shape many = CSCD::test::star(6, 4, 0.5, 0.2);
  const auto distance = [&](CSCD::Shape_descriptor descriptor) {
    return CSCD::shape_distance(description_of(few, descriptor), description_of(many, descriptor));
  };
  EXPECT_GT(distance(CSCD::Shape_descriptor::skeleton), 2 * distance(CSCD::Shape_descriptor::diameter));
}

TEST(Classify_shapes, takes_the_class_of_the_nearest_other)
{
  const std::vector<CSCD::Shape_description> descriptions{{0, 0}, {1, 0}, {0, 5}, {0, 6}, {0.4, 0}, {3, 0}};
  const std::vector<std::string> classes{"a", "a", "b", "b", "", "c"};
  const CSCD::Shape_classification result = CSCD::classify_shapes(descriptions, classes);
  EXPECT_EQ((std::vector<std::string>{"a", "a", "b", "b", "a", "a"}), result.found);
  EXPECT_EQ((std::vector<std::size_t>{1, 0, 3, 2, 0, 1}), result.nearest);
  EXPECT_DOUBLE_EQ(0.4, result.distance[4]);
  EXPECT_DOUBLE_EQ(0.8, result.accuracy);
  // a: precision 2 of 3, recall 2 of 2; b: both 1; c: never found.
  EXPECT_DOUBLE_EQ((0.8 + 1 + 0) / 3, result.macro_f1);
}

TEST(Classify_shapes, without_classes_nothing_is_found)
{
  const CSCD::Shape_classification result = CSCD::classify_shapes({{1}, {2}}, {"", ""});
  EXPECT_EQ((std::vector<std::size_t>{2, 2}), result.nearest);
  EXPECT_EQ(result.found[0], "");
  EXPECT_EQ(result.distance[1], std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(result.accuracy));
  EXPECT_TRUE(CSCD::classify_shapes({}, {}).found.empty());
}

} // namespace
