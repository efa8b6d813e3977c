// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices belong to the nearest node of their piece.

#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/embed_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace {

using CSCD::Index, CSCD::Separator, CSCD::Skeleton_builder, CSCD::Vector3, CSCD::test::Shape_solid;

/// The separator of `crossings`, with its measures.
Separator make_separator(const CSCD::Triangulated_surface& surface, std::vector<CSCD::Edge_crossing> crossings)
{
  Separator separator;
  separator.crossings = std::move(crossings);
  std::vector<Vector3> points;
  CSCD::internal::crossing_points(surface, separator.crossings, points);
  CSCD::internal::set_measures(separator, points);
  separator.source = surface.origin(separator.crossings.front().halfedge);
  return separator;
}

/// The cycle that the plane through `point` normal to `axis` cuts off `surface` and that comes nearest to `near`.
Separator section_separator(const CSCD::Triangulated_surface& surface, const Vector3& point, const Vector3& axis,
                            const Vector3& near)
{
  CSCD::internal::Plane_section section(surface);
  Separator best;
  double least = std::numeric_limits<double>::max();
  for (Index face = 0; face < surface.number_of_faces(); ++face) {
    double distance = std::numeric_limits<double>::max();
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      distance = std::min(distance, (surface.point(surface.origin(h)) - near).norm());
    }
    if (distance < least && section.cut_at_face(face, axis, point, std::numeric_limits<double>::max())) {
      least = distance;
      best = make_separator(surface, section.crossings());
    }
  }
  EXPECT_FALSE(best.crossings.empty()) << "the plane misses the surface";
  return best;
}

/// A shape cut across at some points of the x axis.
struct Cut_shape
{
  Cut_shape(const CSCD::test::Shape& shape, const std::vector<double>& places) : solid(shape)
  {
    for (const double x : places) {
      const Vector3 point = solid.at(x, 0, 0);
      separators.push_back(section_separator(solid.surface(), point, {1, 0, 0}, point));
    }
    packing = std::make_unique<CSCD::internal::Separator_packing>(solid.surface(), separators);
    skeleton = CSCD::internal::embed_skeleton(*solid, separators, packing->packed(), packing->cut_graph(), 0, report);
  }

  Shape_solid solid;
  std::vector<Separator> separators;
  std::unique_ptr<CSCD::internal::Separator_packing> packing;
  CSCD::Skeletonization_report report;
  CSCD::Embedded_skeleton skeleton;
};

TEST(Vertex_assignment, compares_all_nodes_of_a_straight_body)
{
  const Cut_shape shape(CSCD::test::capsule(6, 1, 24), {1.01, 3.02, 5.03});
  const Skeleton_builder& graph = shape.skeleton.graph;
  EXPECT_GT(graph.size(), 8u);
  const auto& points = shape.solid.surface().points();
  for (Index vertex = 0; vertex < points.size(); ++vertex) {
    const double distance = (graph[shape.skeleton.node_of_vertex[vertex]].position - points[vertex]).norm();
    for (Index node = 0; node < graph.size(); ++node) {
      ASSERT_LE(distance, (graph[node].position - points[vertex]).norm() + 1e-12);
    }
  }
  for (Index node = 0; node < graph.size(); ++node) {
    // The end of the curve lies in the hemisphere, and parts of that are nearer than the wall of the tube.
    EXPECT_NEAR(shape.solid.unit() * shape.skeleton.radius[node], 1, graph.degree(node) == 1 ? 0.25 : 0.1);
  }
}

TEST(Vertex_assignment, keeps_vertices_on_their_limb)
{
  // The ends of the ring lie side by side: of each node there is a nearer one on the other end for some vertices.
  const Shape_solid solid(CSCD::test::bent_tube(3, 6, 0.4, 24));
  std::vector<Separator> separators;
  for (const double angle : {0.5, 2., 4., 5.5}) {
    const Vector3 point = solid.at(3 * std::cos(angle), 3 * std::sin(angle), 0);
    separators.push_back(section_separator(solid.surface(), point, {-std::sin(angle), std::cos(angle), 0}, point));
  }
  const CSCD::internal::Separator_packing packing(solid.surface(), separators);
  CSCD::Skeletonization_report report;
  const CSCD::Embedded_skeleton skeleton =
      CSCD::internal::embed_skeleton(*solid, separators, packing.packed(), packing.cut_graph(), 0, report);
  const auto nodes_of_piece = CSCD::internal::nodes_of_pieces(packing.cut_graph(), skeleton.graph);
  for (Index vertex = 0; vertex < solid.surface().number_of_vertices(); ++vertex) {
    const std::vector<Index>& nodes = nodes_of_piece[packing.cut_graph().piece_of_vertex(vertex)];
    const Vector3& point = solid.surface().point(vertex);
    const Index own = skeleton.node_of_vertex[vertex];
    const double distance = (skeleton.graph[own].position - point).norm();
    ASSERT_TRUE(std::binary_search(nodes.begin(), nodes.end(), own));
    for (Index node : nodes) {
      ASSERT_LE(distance, (skeleton.graph[node].position - point).norm() + 1e-12);
    }
    const Vector3 place = solid.to_shape(point);
    const Vector3 node_place = solid.to_shape(skeleton.graph[own].position);
    ASSERT_GT(Vector3(place.x(), place.y(), 0).normalized().dot(node_place.normalized()), 0.5) << "on the same side";
  }
}

} // namespace
