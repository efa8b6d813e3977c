// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of segmentation: properties of every segmentation, and bodies whose parts are unambiguous. Tests of shape
// diameters, on bodies whose thickness is known everywhere.

#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/simple_shapes.h"
#include "support/swept_shapes.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using Part_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Part_skeleton = CSCD::Skeleton_graph<Part_mesh::Point, Part_mesh::Vertex_index>;

/// A mesh and its parts.
struct Segmented_shape
{
  explicit Segmented_shape(const CSCD::test::Shape& shape, std::size_t wanted = 0)
      : mesh(CSCD::test::to_mesh<Part_mesh>(shape)),
        parts(mesh.add_property_map<Part_mesh::Face_index, std::size_t>("f:part", 1000000).first)
  {
    Part_skeleton skeleton;
    CSCD::extract_curve_skeleton(mesh, skeleton);
    number_of_parts = CSCD::segment_mesh(mesh, skeleton, parts, CSCD::parameters::default_values(), wanted);
  }

  std::set<std::size_t> labels() const { return {parts.begin(), parts.end()}; }

  /// The part that most faces with all corners chosen belong to, and the share of these faces that it has.
  template <class Condition>
  std::pair<std::size_t, double> main_part(const Condition& is_chosen) const
  {
    std::vector<std::size_t> counts(number_of_parts, 0);
    std::size_t number = 0;
    for (const auto face : mesh.faces()) {
      const auto corners = vertices_around_face(mesh.halfedge(face), mesh);
      if (std::all_of(corners.begin(), corners.end(), [&](auto v) { return is_chosen(mesh.point(v)); })) {
        ++counts[parts[face]];
        ++number;
      }
    }
    const auto greatest = std::max_element(counts.begin(), counts.end());
    return {std::size_t(greatest - counts.begin()), double(*greatest) / double(number)};
  }

  Part_mesh mesh;
  Part_mesh::Property_map<Part_mesh::Face_index, std::size_t> parts;
  std::size_t number_of_parts = 0;
};

TEST(Segment_mesh, labels_are_the_numbers_of_parts_from_zero)
{
  for (const CSCD::test::Shape& shape : {CSCD::test::sphere(3), CSCD::test::torus(3, 1, 24), CSCD::test::cube(),
                                         CSCD::test::tube(8, 1, 24, CSCD::test::Tube_end::open)}) {
    const Segmented_shape segmented(shape);
    EXPECT_GE(segmented.number_of_parts, 1u) << shape.name;
    EXPECT_EQ(segmented.labels().size(), segmented.number_of_parts) << shape.name;
    EXPECT_EQ(*segmented.labels().rbegin() + 1, segmented.number_of_parts) << shape.name;
  }
}

TEST(Segment_mesh, tail_and_ball_are_two_parts)
{
  const Segmented_shape shape(CSCD::test::ball_with_tail(0.08));
  EXPECT_GE(shape.number_of_parts, 2u);
}

TEST(Segment_mesh, there_are_as_many_parts_as_wanted)
{
  for (const std::size_t wanted : {1, 2, 5, 9}) {
    EXPECT_EQ(Segmented_shape(CSCD::test::star(5, 4, 0.5, 0.15), wanted).number_of_parts, wanted);
  }
}

TEST(Segment_mesh, components_are_never_joined)
{
  const CSCD::test::Shape two = CSCD::test::merged(
      "two", {CSCD::test::capsule(6, 1, 24), CSCD::test::translated(CSCD::test::capsule(6, 1, 24), {0, 5, 0})});
  const Segmented_shape segmented(two, 1);
  EXPECT_EQ(segmented.number_of_parts, 2u);
  const auto below = segmented.main_part([](const auto& p) { return p.y() < 2.5; });
  const auto above = segmented.main_part([](const auto& p) { return p.y() > 2.5; });
  EXPECT_EQ(below.second, 1);
  EXPECT_EQ(above.second, 1);
  EXPECT_NE(below.first, above.first);
}

/// For each part, the number of edges of its boundary at each vertex.
std::vector<std::map<Part_mesh::Vertex_index, int>> boundary_degrees(const Segmented_shape& shape)
{
  std::vector<std::map<Part_mesh::Vertex_index, int>> degrees(shape.number_of_parts);
  for (const auto edge : shape.mesh.edges()) {
    const auto h = shape.mesh.halfedge(edge);
    const std::size_t one = shape.parts[shape.mesh.face(h)];
    const std::size_t other = shape.parts[shape.mesh.face(shape.mesh.opposite(h))];
    if (one != other) {
      for (const std::size_t part : {one, other}) {
        ++degrees[part][shape.mesh.source(h)];
        ++degrees[part][shape.mesh.target(h)];
      }
    }
  }
  return degrees;
}

TEST(Segment_mesh, boundaries_are_not_much_longer_than_around_the_limb)
{
  constexpr double radius = 0.5;
  constexpr std::size_t number_of_limbs = 5;
  const Segmented_shape star(CSCD::test::star(number_of_limbs, 4, radius, 0.1));
  ASSERT_GT(star.number_of_parts, 1U);
  double length = 0;
  for (const auto edge : star.mesh.edges()) {
    const auto h = star.mesh.halfedge(edge);
    if (star.parts[star.mesh.face(h)] != star.parts[star.mesh.face(star.mesh.opposite(h))]) {
      length += std::sqrt(
          CGAL::squared_distance(star.mesh.point(source(h, star.mesh)), star.mesh.point(target(h, star.mesh))));
    }
  }
  EXPECT_LT(length / double(number_of_limbs), 1.3 * 2 * CSCD::test::pi * radius);
}

TEST(Segment_mesh, boundaries_of_parts_are_simple_closed_curves)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::star(5, 4, 0.5, 0.15), CSCD::test::hand(0.15), CSCD::test::ball_with_tail(0.08)}) {
    const Segmented_shape segmented(shape);
    ASSERT_GT(segmented.number_of_parts, 1U) << shape.name;
    for (const auto& degrees : boundary_degrees(segmented)) {
      EXPECT_FALSE(degrees.empty()) << shape.name;
      for (const auto& [vertex, degree] : degrees) {
        EXPECT_EQ(degree, 2) << shape.name << ": at " << vertex;
      }
    }
  }
}

/// A mesh, its skeleton, and the shape diameters.
struct Measured_thickness
{
  explicit Measured_thickness(const CSCD::test::Shape& shape) : mesh(CSCD::test::to_mesh<Part_mesh>(shape))
  {
    CSCD::extract_curve_skeleton(mesh, skeleton);
    of_vertices = mesh.add_property_map<Part_mesh::Vertex_index, double>("v:diameter", -1).first;
    of_faces = mesh.add_property_map<Part_mesh::Face_index, double>("f:diameter", -1).first;
    CSCD::estimate_vertex_shape_diameters(mesh, skeleton, of_vertices);
    CSCD::estimate_face_shape_diameters(mesh, skeleton, of_faces);
  }

  Part_mesh mesh;
  Part_skeleton skeleton;
  Part_mesh::Property_map<Part_mesh::Vertex_index, double> of_vertices;
  Part_mesh::Property_map<Part_mesh::Face_index, double> of_faces;
};

TEST(Shape_diameters, torus_is_as_thick_as_its_tube_everywhere)
{
  const Measured_thickness torus(CSCD::test::torus(3, 1, 32));
  for (const auto vertex : torus.mesh.vertices()) {
    EXPECT_NEAR(torus.of_vertices[vertex], 2, 0.1);
  }
  for (const auto face : torus.mesh.faces()) {
    EXPECT_NEAR(torus.of_faces[face], 2, 0.1);
  }
}

TEST(Shape_diameters, follow_a_tapering_tube)
{
  const Measured_thickness cone(CSCD::test::tapered_tube(20, 2, 1, 32));
  for (const auto vertex : cone.mesh.vertices()) {
    const Part_mesh::Point& point = cone.mesh.point(vertex);
    const double thickness = 2 * std::hypot(point.y(), point.z());
    if (point.x() > 3 && point.x() < 17) { // away from the caps
      EXPECT_NEAR(cone.of_vertices[vertex], thickness, 0.1 * thickness);
    }
  }
}

TEST(Shape_diameters, are_not_smoothed_with_no_steps)
{
  Measured_thickness tube(CSCD::test::capsule(6, 1, 24));
  CSCD::estimate_vertex_shape_diameters(tube.mesh, tube.skeleton, tube.of_vertices, CSCD::parameters::default_values(),
                                        0);
  for (const auto node : boost::make_iterator_range(vertices(tube.skeleton))) {
    for (const auto vertex : tube.skeleton[node].vertices) {
      const double to_node = std::sqrt(CGAL::squared_distance(tube.mesh.point(vertex), tube.skeleton[node].point));
      EXPECT_LE(tube.of_vertices[vertex], 2 * to_node + 1e-12);
    }
  }
}

TEST(Shape_diameters, isolated_vertices_have_none)
{
  Measured_thickness tube(CSCD::test::capsule(6, 1, 24));
  const auto isolated = tube.mesh.add_vertex(Part_mesh::Point(0, 0, 50));
  CSCD::estimate_vertex_shape_diameters(tube.mesh, tube.skeleton, tube.of_vertices);
  EXPECT_EQ(tube.of_vertices[isolated], 0);
}

TEST(Shape_diameters, skeleton_of_another_mesh_is_refused)
{
  Measured_thickness small(CSCD::test::capsule(6, 1, 12));
  Part_mesh large = CSCD::test::to_mesh<Part_mesh>(CSCD::test::capsule(6, 1, 24));
  const auto diameters = large.add_property_map<Part_mesh::Vertex_index, double>("v:diameter").first;
  EXPECT_THROW(CSCD::estimate_vertex_shape_diameters(large, small.skeleton, diameters), CSCD::Input_error);
}

} // namespace
