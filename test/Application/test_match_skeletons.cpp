// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of matching skeletons and of carrying labels, on bodies whose limbs are bent.

#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/swept_shapes.h"
#include <CSCD/Application/match_skeletons.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using Pose_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pose_skeleton = CSCD::Skeleton_graph<Pose_mesh::Point, Pose_mesh::Vertex_index>;

/// A limb of a body: a chain of straight pieces.
struct Chain
{
  std::vector<CSCD::test::Triple> points;
  double radius;
};

/// A body whose faces have the number of the nearest of its chains.
struct Labelled_body
{
  Labelled_body(const std::vector<Chain>& chains, double cell_size)
  {
    std::vector<CSCD::test::Limb> limbs;
    std::vector<std::size_t> number;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      for (std::size_t i = 1; i < chains[c].points.size(); ++i) {
        limbs.push_back({chains[c].points[i - 1], chains[c].points[i], chains[c].radius, chains[c].radius});
        number.push_back(c);
      }
    }
    mesh = CSCD::test::to_mesh<Pose_mesh>(CSCD::test::limb_shape("body", limbs, cell_size));
    CSCD::extract_curve_skeleton(mesh, skeleton);
    limb = mesh.add_property_map<Pose_mesh::Face_index, std::size_t>("f:limb").first;
    carried = mesh.add_property_map<Pose_mesh::Face_index, std::size_t>("f:carried", 1000).first;
    for (const auto face : mesh.faces()) {
      const auto& p = mesh.point(target(halfedge(face, mesh), mesh));
      const CSCD::test::Triple point{p.x(), p.y(), p.z()};
      const auto nearest = std::min_element(limbs.begin(), limbs.end(), [&](const auto& a, const auto& b) {
        return CSCD::test::distance(a, point) - a.source_radius < CSCD::test::distance(b, point) - b.source_radius;
      });
      limb[face] = number[std::size_t(nearest - limbs.begin())];
    }
  }

  /// The part of the faces whose carried label is that of their limb.
  double rightly_labelled() const
  {
    std::size_t right = 0;
    for (const auto face : mesh.faces()) {
      right += limb[face] == carried[face] ? 1 : 0;
    }
    return double(right) / double(mesh.number_of_faces());
  }

  Pose_mesh mesh;
  Pose_skeleton skeleton;
  Pose_mesh::Property_map<Pose_mesh::Face_index, std::size_t> limb;
  Pose_mesh::Property_map<Pose_mesh::Face_index, std::size_t> carried;
};

/// A trunk with a head, two long and two short limbs, all of different lengths, bent in the middle.
struct Bent_body : Labelled_body
{
  explicit Bent_body(double angle, double cell_size = 0.2) : Labelled_body(chains(angle), cell_size) {}

  static std::vector<Chain> chains(double angle)
  {
    const CSCD::test::Triple hip{0, 0, 0};
    const CSCD::test::Triple chest{0, 4, 0};
    const auto bent = [&](const CSCD::test::Triple& from, double direction, double length, double radius) {
      const auto at = [](const CSCD::test::Triple& p, double phi, double distance) {
        return CSCD::test::Triple{p[0] + distance * std::cos(phi), p[1] + distance * std::sin(phi), p[2]};
      };
      const CSCD::test::Triple elbow = at(from, direction, length / 2);
      return Chain{{from, elbow, at(elbow, direction + angle, length / 2)}, radius};
    };
    return {{{hip, chest}, 1},
            bent(chest, CSCD::test::pi / 2, 3, 0.7),
            bent(chest, 0.2, 6, 0.4),
            bent(chest, CSCD::test::pi - 0.2, 5, 0.4),
            bent(hip, -CSCD::test::pi / 2 + 0.5, 8, 0.5),
            bent(hip, -CSCD::test::pi / 2 - 0.5, 7, 0.5)};
  }
};

/// A body that is symmetric but for its pose, with feet that tell its front from its back: the legs step out.
struct Walking_body : Labelled_body
{
  Walking_body(double step, double cell_size) : Labelled_body(chains(step), cell_size) {}

  static std::vector<Chain> chains(double step)
  {
    const auto leg = [](double x, double z) {
      return Chain{{{0, 0, 0}, {x, -3, z / 2}, {x, -6, z}, {x, -6, z + 2}}, 0.5};
    };
    const auto arm = [](double x, double z) { return Chain{{{0, 4, 0}, {x, 4, 0}, {2 * x, 4, z}}, 0.4}; };
    return {{{{0, 0, 0}, {0, 4, 0}}, 1},
            {{{0, 4, 0}, {0, 6.5, 0}}, 0.7},
            arm(2.5, step),
            arm(-2.5, -step),
            leg(1.2, -step),
            leg(-1.2, step)};
  }
};

TEST(Match_skeletons, labels_follow_limbs_into_other_poses)
{
  const Bent_body straight(0);
  for (const double angle : {0.5, -0.6}) {
    Bent_body bent(angle, 0.23);
    ASSERT_NE(straight.mesh.number_of_faces(), bent.mesh.number_of_faces());
    CSCD::carry_labels(straight.mesh, straight.skeleton, straight.limb, bent.mesh, bent.skeleton, bent.carried);
    EXPECT_GT(bent.rightly_labelled(), 0.9) << angle;
  }
}

TEST(Match_skeletons, sides_of_a_symmetric_body_are_not_exchanged)
{
  const Walking_body standing(0, 0.2);
  for (const double step : {-0.7, 0.7}) {
    Walking_body walking(step, 0.22);
    CSCD::carry_labels(standing.mesh, standing.skeleton, standing.limb, walking.mesh, walking.skeleton,
                       walking.carried);
    EXPECT_GT(walking.rightly_labelled(), 0.9) << step;
  }
}

TEST(Match_skeletons, every_node_corresponds_to_itself)
{
  const Bent_body body(0.3, 0.25);
  const CSCD::Skeleton_match match = CSCD::match_skeletons(body.skeleton, body.skeleton);
  EXPECT_EQ(match.ends.size(), 5U);
  for (const auto& [first, second] : match.ends) {
    EXPECT_EQ(first, second);
  }
  ASSERT_EQ(match.nodes.size(), num_vertices(body.skeleton));
  for (std::size_t i = 0; i < match.nodes.size(); ++i) {
    EXPECT_EQ(i, match.nodes[i]);
  }
}

TEST(Match_skeletons, scale_does_not_matter)
{
  const CSCD::test::Shape shape = CSCD::test::hand(0.15);
  const auto match_with = [&](double factor) {
    const Pose_mesh mesh = CSCD::test::to_mesh<Pose_mesh>(shape);
    const Pose_mesh other = CSCD::test::to_mesh<Pose_mesh>(CSCD::test::scaled(shape, factor));
    Pose_skeleton skeleton;
    Pose_skeleton other_skeleton;
    CSCD::extract_curve_skeleton(mesh, skeleton);
    CSCD::extract_curve_skeleton(other, other_skeleton);
    return CSCD::match_skeletons(skeleton, other_skeleton).nodes;
  };
  EXPECT_EQ(match_with(1), match_with(1. / 1024)); // a power of two: nothing is rounded
}

TEST(Match_skeletons, bodies_without_tips_and_of_several_components_are_matched)
{
  const CSCD::test::Shape torus = CSCD::test::torus(3, 1, 20);
  const CSCD::test::Shape two =
      CSCD::test::merged("two", {CSCD::test::capsule(6, 1, 16), CSCD::test::translated(torus, {0, 9, 0})});
  for (const CSCD::test::Shape& shape : {torus, two, CSCD::test::tetrahedron()}) {
    const Pose_mesh mesh = CSCD::test::to_mesh<Pose_mesh>(shape);
    Pose_skeleton skeleton;
    CSCD::extract_curve_skeleton(mesh, skeleton);
    const CSCD::Skeleton_match match = CSCD::match_skeletons(skeleton, skeleton);
    EXPECT_EQ(match.nodes.size(), num_vertices(skeleton)) << shape.name;
    EXPECT_GE(match.ends.size(), 1U) << shape.name;
    for (const CSCD::Index node : match.nodes) {
      EXPECT_LT(node, num_vertices(skeleton)) << shape.name;
    }
  }
}

TEST(Match_skeletons, skeleton_of_another_mesh_is_refused)
{
  const Bent_body one(0, 0.25);
  Bent_body two(0, 0.35); // of fewer vertices
  EXPECT_THROW(CSCD::carry_labels(one.mesh, two.skeleton, one.limb, two.mesh, two.skeleton, two.carried),
               CSCD::Input_error);
}

} // namespace
