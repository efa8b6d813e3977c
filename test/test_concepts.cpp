// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The library's own classes are models of the concepts. compile_errors tests the refused types and their messages;
// test_archetypes.cpp tests that the concepts suffice.

#include <CSCD/Local_policies.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/Traits/Reconstructed_surface_traits.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/concepts.h>
#include <CSCD/input_concepts.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

/// The checks are at compile time.
TEST(Concepts, have_models)
{
  CSCD::check_skeletonization_traits<CSCD::Triangle_mesh_traits<Mesh>>();
  CSCD::check_skeletonization_traits<CSCD::Point_set_traits<std::vector<Point>>>();
  CSCD::check_skeletonization_traits<CSCD::Reconstructed_surface_traits<std::vector<Point>>>();
  CSCD::check_skeletonization_surface<CSCD::Triangulated_solid>();
  CSCD::check_skeletonization_surface<CSCD::Point_solid>();
  CSCD::check_skeletonization_policies<CSCD::Local_policies, CSCD::Triangulated_solid>();
  CSCD::check_skeletonization_policies<CSCD::Published_policies, CSCD::Triangulated_solid>();
  CSCD::check_skeletonization_policies<CSCD::Published_policies, CSCD::Point_solid>();
  CSCD::check_skeletonization_visitor<CSCD::Default_skeletonization_visitor>();
  CSCD::check_triangle_mesh<Mesh>();
  CSCD::check_triangle_mesh<Polyhedron>();
  CSCD::check_curve_skeleton_graph<CSCD::Skeleton_graph<Point, std::size_t>>();
  CSCD::check_curve_skeleton_graph<CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton>();
}

TEST(Concepts, Skeletonization_policies)
{
  using CSCD::is_skeletonization_policies_v;
  EXPECT_TRUE((is_skeletonization_policies_v<CSCD::Local_policies, CSCD::Triangulated_solid>));
  EXPECT_FALSE((is_skeletonization_policies_v<CSCD::Local_policies, CSCD::Point_solid>));
  EXPECT_TRUE((is_skeletonization_policies_v<CSCD::Published_policies, CSCD::Point_solid>));
}

TEST(Concepts, Triangle_mesh)
{
  EXPECT_TRUE(CSCD::is_triangle_mesh_v<Mesh>);
  EXPECT_TRUE(CSCD::is_triangle_mesh_v<Polyhedron>);
  EXPECT_FALSE(CSCD::is_triangle_mesh_v<std::vector<Point>>);
  EXPECT_FALSE(CSCD::is_triangle_mesh_v<CGAL::Point_set_3<Point>>);
  EXPECT_FALSE((CSCD::is_triangle_mesh_v<boost::adjacency_list<>>));
  EXPECT_FALSE(CSCD::is_triangle_mesh_v<int>);
}

TEST(Concepts, Point_range)
{
  EXPECT_TRUE(CSCD::is_point_range_v<std::vector<Point>>);
  EXPECT_TRUE(CSCD::is_point_range_v<CGAL::Point_set_3<Point>>);
  EXPECT_FALSE(CSCD::is_point_range_v<Mesh>);
  EXPECT_FALSE(CSCD::is_point_range_v<int>);
}

} // namespace
