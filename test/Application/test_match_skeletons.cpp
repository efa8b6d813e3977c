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

/// A trunk with a head, two long and two short limbs, all of different lengths, bent in the middle; each face has the
/// number of the nearest limb.
struct Bent_body
{
  static constexpr std::size_t number_of_limbs = 6;

  explicit Bent_body(double angle, double cell_size = 0.2)
  {
    const auto add = [&](const CSCD::test::Triple& from, double direction, double length, double radius) {
      const auto at = [](const CSCD::test::Triple& p, double phi, double distance) {
        return CSCD::test::Triple{p[0] + distance * std::cos(phi), p[1] + distance * std::sin(phi), p[2]};
      };
      const CSCD::test::Triple elbow = at(from, direction, length / 2);
      limbs.push_back({from, elbow, radius, radius});
      limbs.push_back({elbow, at(elbow, direction + angle, length / 2), radius, radius});
    };
    const CSCD::test::Triple hip{0, 0, 0};
    const CSCD::test::Triple chest{0, 4, 0};
    limbs.push_back({hip, chest, 1, 1});
    limbs.push_back({hip, chest, 1, 1});
    add(chest, CSCD::test::pi / 2, 3, 0.7);
    add(chest, 0.2, 6, 0.4);
    add(chest, CSCD::test::pi - 0.2, 5, 0.4);
    add(hip, -CSCD::test::pi / 2 + 0.5, 8, 0.5);
    add(hip, -CSCD::test::pi / 2 - 0.5, 7, 0.5);
    mesh = CSCD::test::to_mesh<Pose_mesh>(CSCD::test::limb_shape("bent body", limbs, cell_size));
    CSCD::extract_curve_skeleton(mesh, skeleton);
    limb = mesh.add_property_map<Pose_mesh::Face_index, std::size_t>("f:limb").first;
    carried = mesh.add_property_map<Pose_mesh::Face_index, std::size_t>("f:carried", 1000).first;
    for (const auto face : mesh.faces()) {
      const auto& p = mesh.point(target(halfedge(face, mesh), mesh));
      const CSCD::test::Triple point{p.x(), p.y(), p.z()};
      const auto nearest = std::min_element(limbs.begin(), limbs.end(), [&](const auto& a, const auto& b) {
        return CSCD::test::distance(a, point) - a.source_radius < CSCD::test::distance(b, point) - b.source_radius;
      });
      limb[face] = std::size_t(nearest - limbs.begin()) / 2;
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

  std::vector<CSCD::test::Limb> limbs;
  Pose_mesh mesh;
  Pose_skeleton skeleton;
  Pose_mesh::Property_map<Pose_mesh::Face_index, std::size_t> limb;
  Pose_mesh::Property_map<Pose_mesh::Face_index, std::size_t> carried;
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
