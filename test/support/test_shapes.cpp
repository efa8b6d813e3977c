// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generated shapes have their stated properties, which the other tests rely on.

#include "support/Surface_facts.h"
#include "support/convert_shape.h"
#include "support/shapes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void expect_is_as_declared(const CSCD::test::Shape& shape)
{
  ASSERT_TRUE(CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(shape.triangles));
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  ASSERT_EQ(mesh.number_of_faces(), shape.triangles.size());
  const CSCD::test::Surface_facts facts = CSCD::test::surface_facts(mesh);
  EXPECT_EQ(facts.number_of_components, shape.number_of_components);
  EXPECT_EQ(facts.genus, shape.genus);
  EXPECT_EQ(facts.number_of_border_cycles, shape.number_of_border_cycles);
  EXPECT_EQ(facts.number_of_isolated_vertices, 0u);
  if (shape.is_closed()) {
    EXPECT_GT(CGAL::Polygon_mesh_processing::volume(mesh), 0) << "triangles face inwards";
  }
  for (const auto f : mesh.faces()) {
    EXPECT_GT(CGAL::Polygon_mesh_processing::face_area(f, mesh), 0);
  }
}

TEST(Shapes, are_as_declared)
{
  for (const std::vector<CSCD::test::Shape_maker>& list :
       {CSCD::test::shapes_with_known_skeleton(), CSCD::test::hard_closed_shapes(), CSCD::test::open_shapes()}) {
    for (const CSCD::test::Shape_maker& maker : list) {
      SCOPED_TRACE(maker.name);
      expect_is_as_declared(maker.make());
    }
  }
  expect_is_as_declared(CSCD::test::hollow_sphere(3));
}

TEST(Shapes, surface_keeps_its_distance_from_the_centreline)
{
  // A limb's fillets and the coarse grid shift the surface by parts of the radius.
  const double tolerance = 0.35;
  for (const CSCD::test::Shape_maker& maker : CSCD::test::shapes_with_known_skeleton()) {
    SCOPED_TRACE(maker.name);
    const CSCD::test::Shape shape = maker.make();
    ASSERT_FALSE(shape.centreline.empty());
    for (const CSCD::test::Triple& p : shape.points) {
      double nearest = std::numeric_limits<double>::max();
      for (const CSCD::test::Centreline_segment& segment : shape.centreline) {
        nearest = std::min(nearest, CSCD::test::distance(segment, p) / CSCD::test::radius_near(segment, p));
      }
      ASSERT_LT(nearest, 1 + tolerance);
    }
  }
}

} // namespace
