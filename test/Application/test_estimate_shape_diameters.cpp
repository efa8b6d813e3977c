// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of shape diameters, on bodies whose thickness is known everywhere.

#include "support/convert_shape.h"
#include "support/shape_operations.h"
#include "support/swept_shapes.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using Diameter_point = CGAL::Simple_cartesian<double>::Point_3;
using Diameter_mesh = CGAL::Surface_mesh<Diameter_point>;
using Diameter_skeleton = CSCD::Skeleton_graph<Diameter_point, Diameter_mesh::Vertex_index>;

/// A mesh, its skeleton, and the shape diameters.
struct Measured_thickness
{
  explicit Measured_thickness(const CSCD::test::Shape& shape) : mesh(CSCD::test::to_mesh<Diameter_mesh>(shape))
  {
    CSCD::extract_curve_skeleton(mesh, skeleton);
    of_vertices = mesh.add_property_map<Diameter_mesh::Vertex_index, double>("v:diameter", -1).first;
    of_faces = mesh.add_property_map<Diameter_mesh::Face_index, double>("f:diameter", -1).first;
    CSCD::estimate_vertex_shape_diameters(mesh, skeleton, of_vertices);
    CSCD::estimate_face_shape_diameters(mesh, skeleton, of_faces);
  }

  Diameter_mesh mesh;
  Diameter_skeleton skeleton;
  Diameter_mesh::Property_map<Diameter_mesh::Vertex_index, double> of_vertices;
  Diameter_mesh::Property_map<Diameter_mesh::Face_index, double> of_faces;
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
    const Diameter_point& point = cone.mesh.point(vertex);
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
  const auto isolated = tube.mesh.add_vertex(Diameter_point(0, 0, 50));
  CSCD::estimate_vertex_shape_diameters(tube.mesh, tube.skeleton, tube.of_vertices);
  EXPECT_EQ(tube.of_vertices[isolated], 0);
}

TEST(Shape_diameters, skeleton_of_another_mesh_is_refused)
{
  Measured_thickness small(CSCD::test::capsule(6, 1, 12));
  Diameter_mesh large = CSCD::test::to_mesh<Diameter_mesh>(CSCD::test::capsule(6, 1, 24));
  const auto diameters = large.add_property_map<Diameter_mesh::Vertex_index, double>("v:diameter").first;
  EXPECT_THROW(CSCD::estimate_vertex_shape_diameters(large, small.skeleton, diameters), CSCD::Input_error);
}

} // namespace
