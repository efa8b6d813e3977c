// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which types are models of the concepts, and which are not; what is refused, and how, is seen in compile_errors.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/concepts.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

struct Two_sites
{
  using Point = std::array<double, 3>;
  using Site_descriptor = std::size_t;

  std::size_t number_of_sites() const { return 2; }
  Eigen::Vector3d point(std::size_t i) const { return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i)); }
  float weight(std::size_t /* i */) const { return 1; }
  Eigen::Vector3d normal(std::size_t /* i */) const { return Eigen::Vector3d::UnitZ(); }
  std::vector<int> neighbors(std::size_t i) const { return {i == 0 ? 1 : 0}; }
  std::size_t number_of_triangles() const { return 0; }
  std::array<std::size_t, 3> triangle(std::size_t /* f */) const { return {}; }
};

struct Two_sites_not_const : Two_sites
{
  std::size_t number_of_sites() { return 2; }
};

struct Two_sites_without_triangles : Two_sites
{
  void triangle() const {}
};

struct Two_sites_with_named_neighbors : Two_sites
{
  std::vector<std::string> neighbors(std::size_t /* i */) const { return {}; }
};

TEST(Concepts, Skeletonization_traits)
{
  EXPECT_TRUE(CSCD::is_skeletonization_traits_v<Two_sites>);
  EXPECT_TRUE((CSCD::is_skeletonization_traits_v<CSCD::Triangle_mesh_traits<Mesh>>));
  CSCD::check_skeletonization_traits<Two_sites>();
  CSCD::check_skeletonization_traits<CSCD::Triangle_mesh_traits<Mesh>>();

  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Mesh>);
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<int>);
}

TEST(Concepts, Skeletonization_traits_one_requirement_missing)
{
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_not_const>::has_number_of_sites);
  EXPECT_TRUE(CSCD::Skeletonization_traits_requirements<Two_sites_not_const>::has_point);
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_without_triangles>::has_triangle);
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_with_named_neighbors>::has_neighbors);
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Two_sites_without_triangles>);
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Two_sites_with_named_neighbors>);
}

TEST(Concepts, Triangle_mesh)
{
  EXPECT_TRUE(CSCD::is_triangle_mesh_v<Mesh>);
  EXPECT_TRUE(CSCD::is_triangle_mesh_v<Polyhedron>);
  CSCD::check_triangle_mesh<Mesh>();
  CSCD::check_triangle_mesh<Polyhedron>();
}

TEST(Concepts, Not_a_triangle_mesh)
{
  EXPECT_FALSE(CSCD::is_triangle_mesh_v<std::vector<Point>>);
  EXPECT_FALSE(CSCD::is_triangle_mesh_v<CGAL::Point_set_3<Point>>);
  EXPECT_FALSE((CSCD::is_triangle_mesh_v<boost::adjacency_list<>>));
  EXPECT_FALSE(CSCD::is_triangle_mesh_v<int>);
}

TEST(Concepts, Curve_skeleton_graph)
{
  using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
  using Cgal_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
  EXPECT_TRUE(CSCD::is_curve_skeleton_graph_v<Skeleton>);
  EXPECT_TRUE(CSCD::is_curve_skeleton_graph_v<Cgal_skeleton>);
  CSCD::check_curve_skeleton_graph<Skeleton>();
  CSCD::check_curve_skeleton_graph<Cgal_skeleton>();
}

TEST(Concepts, Not_a_curve_skeleton_graph)
{
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  EXPECT_FALSE(CSCD::is_curve_skeleton_graph_v<Graph>);
  EXPECT_TRUE(CSCD::Curve_skeleton_graph_requirements<Graph>::has_add_edge);
  EXPECT_FALSE(CSCD::Curve_skeleton_graph_requirements<Graph>::has_point);
  EXPECT_FALSE(CSCD::is_curve_skeleton_graph_v<std::vector<Point>>);
  EXPECT_FALSE(CSCD::is_curve_skeleton_graph_v<Mesh>);
}

struct Deaf_visitor
{
  void on_stage_begin(CSCD::Skeletonization_stage /* stage */) {}
  void on_stage_end(CSCD::Skeletonization_stage /* stage */) {}
  bool go_further() { return true; }
};

TEST(Concepts, Skeletonization_visitor)
{
  EXPECT_TRUE(CSCD::is_skeletonization_visitor_v<CSCD::Default_skeletonization_visitor>);
  CSCD::check_skeletonization_visitor<CSCD::Default_skeletonization_visitor>();

  EXPECT_FALSE(CSCD::is_skeletonization_visitor_v<Deaf_visitor>);
  EXPECT_FALSE(CSCD::Skeletonization_visitor_requirements<Deaf_visitor>::has_progress);
  EXPECT_FALSE(CSCD::is_skeletonization_visitor_v<int>);
}

} // namespace
