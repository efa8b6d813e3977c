// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of rigs: properties of every rig, and that bending a joint moves its limb smoothly and nothing else.

#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/simple_shapes.h"
#include "support/swept_shapes.h"
#include <CSCD/Application/make_rig.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace {

using Rig_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Rig_skeleton = CSCD::Skeleton_graph<Rig_mesh::Point, Rig_mesh::Vertex_index>;

struct Rigged_shape
{
  explicit Rigged_shape(const CSCD::test::Shape& shape, std::optional<CSCD::Index> root = std::nullopt)
      : mesh(CSCD::test::to_mesh<Rig_mesh>(shape))
  {
    CSCD::extract_curve_skeleton(mesh, skeleton);
    rig = CSCD::make_rig(mesh, skeleton, root);
  }

  /// The sum of the weights of a joint and its descendants at a vertex: a turn of the joint turns it by this share.
  double share(std::size_t joint, std::size_t vertex) const
  {
    double sum = 0;
    for (const CSCD::Rig_influence& influence : rig.influences[vertex]) {
      std::size_t j = influence.joint;
      while (j != joint && rig.joints[j].parent) {
        j = *rig.joints[j].parent;
      }
      sum += j == joint ? influence.weight : 0;
    }
    return sum;
  }

  std::vector<std::size_t> joints_behind(std::size_t joint) const
  {
    std::vector<std::size_t> result;
    for (std::size_t j = 0; j < rig.joints.size(); ++j) {
      if (rig.joints[j].parent == joint) {
        result.push_back(j);
      }
    }
    return result;
  }

  /// The largest change of the share of a joint along an edge, times the radius of the joint over the length of the
  /// edge, or the mean length of edges if it is shorter.
  double steepness(std::size_t joint) const
  {
    std::vector<double> lengths;
    for (const auto edge : mesh.edges()) {
      lengths.push_back(
          std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(edge, 0)), mesh.point(mesh.vertex(edge, 1)))));
    }
    const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.) / double(lengths.size());
    double greatest = 0;
    std::size_t e = 0;
    for (const auto edge : mesh.edges()) {
      const double change = std::abs(share(joint, mesh.vertex(edge, 0)) - share(joint, mesh.vertex(edge, 1)));
      greatest = std::max(greatest, change * rig.joints[joint].radius / std::max(mean, lengths[e++]));
    }
    return greatest;
  }

  Rig_mesh mesh;
  Rig_skeleton skeleton;
  CSCD::Rig rig;
};

void expect_valid(const Rigged_shape& shape)
{
  const CSCD::Rig& rig = shape.rig;
  ASSERT_FALSE(rig.joints.empty());
  std::set<std::string> names;
  std::set<std::size_t> ancestors; // of the joint before, and itself
  for (std::size_t j = 0; j < rig.joints.size(); ++j) {
    const CSCD::Rig_joint& joint = rig.joints[j];
    EXPECT_TRUE(names.insert(name(joint)).second);
    const auto& point = shape.skeleton[joint.node].point;
    EXPECT_EQ(CSCD::Vector3(point.x(), point.y(), point.z()), joint.point);
    EXPECT_TRUE(!joint.parent || ancestors.count(*joint.parent) == 1) << "what depends on a joint comes in one piece";
    ancestors.erase(joint.parent ? ancestors.upper_bound(*joint.parent) : ancestors.begin(), ancestors.end());
    ancestors.insert(j);
  }
  ASSERT_EQ(shape.mesh.number_of_vertices(), rig.influences.size());
  for (const CSCD::Rig::Influences& influences : rig.influences) {
    double sum = 0;
    std::set<CSCD::Index> seen;
    for (const CSCD::Rig_influence& influence : influences) {
      ASSERT_LT(influence.joint, rig.joints.size());
      EXPECT_GE(influence.weight, 0);
      if (influence.weight > 0) {
        EXPECT_TRUE(seen.insert(influence.joint).second);
        EXPECT_FALSE(rig.joints[influence.joint].is_tip);
      }
      sum += influence.weight;
    }
    EXPECT_NEAR(1, sum, 1e-12);
  }
}

TEST(Make_rig, holds_for_bodies_of_all_kinds)
{
  const CSCD::test::Shape ball = CSCD::test::sphere(2);
  for (const CSCD::test::Shape& shape :
       {ball, CSCD::test::cube(), CSCD::test::torus(3, 1, 16), CSCD::test::double_torus(0.25), CSCD::test::hand(0.15),
        CSCD::test::tube(8, 1, 16, CSCD::test::Tube_end::open)}) {
    SCOPED_TRACE(shape.name);
    expect_valid(Rigged_shape(shape));
  }
}

TEST(Make_rig, joins_components_to_one_body)
{
  const CSCD::test::Shape two = CSCD::test::chain_of_rings(2, 12);
  const Rigged_shape rigged(two);
  expect_valid(rigged);
  EXPECT_EQ(1, std::count_if(rigged.rig.joints.begin(), rigged.rig.joints.end(),
                             [](const CSCD::Rig_joint& joint) { return !joint.parent; }));
  const CSCD::Index root = 3;
  EXPECT_EQ(root, Rigged_shape(two, root).rig.joints.front().node);
}

TEST(Make_rig, a_body_with_fins_has_a_spine)
{
  using CSCD::test::ellipsoid, CSCD::test::merged, CSCD::test::moved, CSCD::test::translated, CSCD::test::Triple;
  const CSCD::test::Shape body = // taller than long, and thinner behind
      moved(ellipsoid({3, 1, 4}, 3), [](const Triple& p) {
        return Triple{p[0] < 0 ? p[0] : 1.5 * p[0], p[1], p[2]};
      });
  const CSCD::test::Shape fin = ellipsoid({1.5, 0.1, 0.5}, 2);
  const CSCD::test::Shape high = ellipsoid({0.5, 1.5, 1.5}, 2); // thick fins above and below: longest across
  const CSCD::test::Shape whole = merged("fish", {body, translated(fin, {6, 0, 0}), translated(fin, {7, 0, 2}),
                                                  translated(high, {0, 0, 5}), translated(high, {0, 0, -5})});
  const auto turn = [](const Triple& p, double cosine, double sine) {
    return Triple{cosine * p[0] - sine * p[2], p[1], sine * p[0] + cosine * p[2]};
  };
  const Rigged_shape fish(moved(whole, [&](const auto& p) { return turn(p, 0.8, 0.6); }));
  ASSERT_EQ(7u, fish.rig.joints.size());
  for (std::size_t j = 0; j < 7; ++j) {
    const CSCD::Rig_joint& joint = fish.rig.joints[j];
    EXPECT_EQ("spine_" + std::to_string(j), name(joint));
    EXPECT_EQ(j == 6, joint.is_tip);
    const Triple point = turn({joint.point.x(), joint.point.y(), joint.point.z()}, 0.8, -0.6);
    EXPECT_NEAR(-2.625 + 1.125 * double(j), point[0], 0.01) << "from end to end of the body";
    EXPECT_NEAR(0, std::hypot(point[1], point[2]), 0.01);
  }
  for (const CSCD::Rig::Influences& influences : fish.rig.influences) {
    EXPECT_NEAR(1, influences[0].weight + influences[1].weight + influences[2].weight + influences[3].weight, 1e-12);
  }
  for (const double size : {0.3, 0.7, 1.1, 1.7}) {
    EXPECT_EQ(7u, Rigged_shape(CSCD::test::scaled(whole, size)).rig.joints.size()) << "whatever rounding does";
  }
  EXPECT_NE("spine_0", name(Rigged_shape(merged("two", {body, translated(body, {9, 0, 0})})).rig.joints[0]));
  EXPECT_NE("spine_0", name(Rigged_shape(body).rig.joints[0]));
  const CSCD::test::Shape ball = ellipsoid({3, 3, 3}, 3);
  EXPECT_NE("spine_0", name(Rigged_shape(merged("robot", {ball, translated(fin, {4, 0, 0})})).rig.joints[0]));
}

TEST(Make_rig, small_thin_parts_move_with_the_body)
{
  const CSCD::test::Shape tube = CSCD::test::bent_tube(5, CSCD::test::pi / 2, 0.7, 20);
  const auto rig_with_strand = [&](double radius) {
    const CSCD::test::Shape strand = translated(CSCD::test::capsule(1, radius, 8), {3, 3.5, 0.8 + radius});
    return Rigged_shape(CSCD::test::merged("tube and strand", {tube, strand})).rig;
  };
  const auto is_in_strand = [](const CSCD::Rig_joint& joint) { return joint.point.z() > 0.5; };
  const CSCD::Rig thin = rig_with_strand(0.05);
  EXPECT_EQ(0, std::count_if(thin.joints.begin(), thin.joints.end(), is_in_strand));
  for (const CSCD::Rig_influence& influence : thin.influences.back()) {
    EXPECT_TRUE(influence.weight == 0 || (thin.joints[influence.joint].point - CSCD::Vector3(3.5, 3.5, 0)).norm() < 3);
  }
  const CSCD::Rig thick = rig_with_strand(0.3);
  EXPECT_LT(2, std::count_if(thick.joints.begin(), thick.joints.end(), is_in_strand));
}

TEST(Make_rig, has_joints_at_even_distances_along_a_limb)
{
  const CSCD::test::Shape tube = CSCD::test::capsule(10, 1, 16);
  const Rigged_shape any(tube);
  const Rigged_shape from_end(tube, CSCD::find_roots(any.skeleton, CSCD::Root_rule::longest).front());
  expect_valid(from_end);
  ASSERT_EQ(7u, from_end.rig.joints.size()) << "two ends and five between them";
  EXPECT_TRUE(from_end.rig.joints.back().is_tip);
  for (std::size_t j = 1; j < 7; ++j) {
    EXPECT_EQ(j - 1, *from_end.rig.joints[j].parent);
    EXPECT_NEAR((from_end.rig.joints[j].point - from_end.rig.joints[j - 1].point).norm(), 10. / 6, 0.7);
  }
}

TEST(Make_rig, bending_a_joint_of_a_bent_tube_moves_what_is_behind_it)
{
  const Rigged_shape tube(CSCD::test::bent_tube(5, CSCD::test::pi / 2, 0.7, 20));
  expect_valid(tube);
  std::size_t number_of_bends = 0;
  for (std::size_t j = 0; j < tube.rig.joints.size(); ++j) {
    const CSCD::Rig_joint& joint = tube.rig.joints[j];
    if (!joint.parent || joint.is_tip) {
      continue;
    }
    ++number_of_bends;
    EXPECT_LT(tube.steepness(j), 1.5);
    const double place = std::atan2(joint.point.y(), joint.point.x());
    const CSCD::Vector3& before = tube.rig.joints[*joint.parent].point;
    const double sign = std::atan2(before.y(), before.x()) < place ? 1 : -1;
    for (const auto v : tube.mesh.vertices()) { // a radius around the joint is where the weights go over
      const auto& p = tube.mesh.point(v);
      const double behind = 5 * sign * (std::atan2(p.y(), p.x()) - place);
      if (std::abs(behind) > 1.5) {
        EXPECT_NEAR(behind > 0 ? 1 : 0, tube.share(j, v), 0.01) << behind;
      }
    }
  }
  EXPECT_GE(number_of_bends, 2u) << "an arc is no straight bone";
}

TEST(Make_rig, a_limb_bent_by_a_right_angle_keeps_its_volume)
{
  const CSCD::test::Shape tube = CSCD::test::capsule(10, 1, 32);
  const Rigged_shape any(tube);
  const Rigged_shape limb(tube, CSCD::find_roots(any.skeleton, CSCD::Root_rule::longest).front());
  const std::size_t joint = limb.rig.joints.size() / 2;
  const CSCD::Vector3 center = limb.rig.joints[joint].point;
  Rig_mesh bent = limb.mesh;
  for (const auto v : bent.vertices()) {
    const auto p = bent.point(v);
    const double x = p.x() - center.x();
    const double z = p.z() - center.z();
    const double share = limb.share(joint, v);
    bent.point(v) = {p.x() + share * (z - x), p.y(), p.z() - share * (x + z)};
  }
  const auto volume = [](const Rig_mesh& mesh) { return CGAL::Polygon_mesh_processing::volume(mesh); };
  EXPECT_NEAR(1, volume(bent) / volume(limb.mesh), 0.05);
}

TEST(Make_rig, each_limb_of_a_star_has_a_joint_that_moves_it_alone)
{
  constexpr std::size_t number_of_limbs = 5;
  const Rigged_shape star(CSCD::test::star(number_of_limbs, 6, 0.8, 0.25));
  expect_valid(star);
  const std::vector<std::size_t> joints = star.joints_behind(0);
  ASSERT_EQ(number_of_limbs, joints.size());
  for (const std::size_t j : joints) {
    const CSCD::Vector3 direction = star.rig.joints[j].point.normalized();
    EXPECT_LT(star.rig.joints[j].point.norm(), 3) << "where the limb leaves the middle";
    EXPECT_LT(star.steepness(j), 3);
    for (const auto v : star.mesh.vertices()) {
      const auto& p = star.mesh.point(v);
      const double along = CSCD::Vector3(p.x(), p.y(), p.z()).dot(direction);
      const double distance = std::sqrt((p - CGAL::ORIGIN).squared_length());
      const bool is_on_limb = along > 0.9 * distance;
      if (is_on_limb && distance > 4) {
        EXPECT_NEAR(1, star.share(j, v), 0.01);
      } else if (!is_on_limb && distance > 3) {
        EXPECT_EQ(0, star.share(j, v)) << "another limb";
      }
    }
  }
}

TEST(Make_rig, vertices_without_a_face_belong_to_the_first_joint)
{
  Rig_mesh mesh = CSCD::test::to_mesh<Rig_mesh>(CSCD::test::capsule(6, 1, 12));
  mesh.add_vertex({100, 100, 100});
  Rig_skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  const CSCD::Rig rig = CSCD::make_rig(mesh, skeleton);
  ASSERT_EQ(mesh.number_of_vertices(), rig.influences.size());
  EXPECT_EQ(0u, rig.influences.back()[0].joint);
  EXPECT_EQ(1, rig.influences.back()[0].weight);
}

} // namespace
