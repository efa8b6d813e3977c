// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which types are models of the concepts, and which are not; what is refused, and how, is seen in compile_errors.

#include <CSCD/Local_policies.h>
#include <CSCD/Selection/Separator_cost.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Surface/Triangulated_surface.h>
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
#include <optional>
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
  using Input_descriptor = std::size_t;

  std::size_t number_of_sites() const { return 2; }
  Eigen::Vector3d point(std::size_t i) const { return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i)); }
  float weight(std::size_t /* i */) const { return 1; }
  Eigen::Vector3d normal(std::size_t /* i */) const { return Eigen::Vector3d::UnitZ(); }
  std::vector<int> neighbors(std::size_t i) const { return {i == 0 ? 1 : 0}; }
  std::size_t number_of_triangles() const { return 0; }
  std::array<std::size_t, 3> triangle(std::size_t /* f */) const { return {}; }
  std::array<std::size_t, 1> descriptors(std::size_t i) const { return {i}; }
  Point to_input_point(const Eigen::Vector3d& p) const { return {p.x(), p.y(), p.z()}; }
  double to_input_length(double length) const { return length; }
  int genus() const { return 0; }
  int number_of_components() const { return 1; }
  int number_of_input_vertices() const { return 2; }
  int number_of_isolated_vertices() const { return 0; }
  int number_of_bridged_borders() const { return 0; }
  int number_of_inserted_vertices() const { return 0; }
  int number_of_degenerate_faces() const { return 0; }
  std::vector<std::string> warnings() const { return {}; }
  double seconds_to_compile() const { return 0; }
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

struct Two_sites_of_another_kind : Two_sites
{
  using Input_descriptor = std::string;
};

struct Two_sites_with_one_warning : Two_sites
{
  std::string warnings() const { return {}; }
};

struct Two_sites_without_genus : Two_sites
{
  void genus() const {}
};

struct Two_sites_without_a_count : Two_sites
{
  void number_of_bridged_borders() const {}
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
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_of_another_kind>::has_descriptors);
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_with_one_warning>::has_warnings);
  EXPECT_TRUE(CSCD::Skeletonization_traits_requirements<Two_sites_of_another_kind>::has_input_descriptor);
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_without_genus>::has_genus);
  EXPECT_FALSE(CSCD::Skeletonization_traits_requirements<Two_sites_without_a_count>::has_counts_of_input);
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Two_sites_without_triangles>);
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Two_sites_with_named_neighbors>);
}

struct Levels_by_value
{
  CSCD::Surface_levels levels() const;
};

struct Body
{
  const CSCD::Triangulated_surface& surface() const;
  bool is_inside(const Eigen::Vector3d& p) const;
  std::optional<Eigen::Vector3d> middle_behind(const Eigen::Vector3d& p) const;
  void crossings(const Eigen::Vector3d& p, const Eigen::Vector3d& q, std::vector<double>& distances) const;
};

struct Body_that_returns_crossings : Body
{
  std::vector<double> crossings(const Eigen::Vector3d& p, const Eigen::Vector3d& q) const;
};

struct Body_with_a_surface_by_value : Body
{
  CSCD::Triangulated_surface surface() const;
};

struct Body_without_edges : Body
{
  const std::vector<Eigen::Vector3d>& surface() const;
};

struct Body_without_a_middle : Body
{
  bool middle_behind(const Eigen::Vector3d& p) const;
};

struct Triangulated_body : Body
{
  struct Place
  {
    Eigen::Vector3d point;
  };
  struct Hit
  {
    Eigen::Vector3d point;
    unsigned face;
  };

  const CSCD::Surface_levels& levels() const;
  const CSCD::Triangulated_surface& solid_surface() const;
  Place closest_point(const Eigen::Vector3d& p) const;
  const Hit* first_hit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction) const;
};

struct Triangulated_body_that_is_always_hit : Triangulated_body
{
  Hit first_hit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction) const;
};

struct Triangulated_body_without_faces : Triangulated_body
{
  const Place* first_hit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction) const;
};

TEST(Concepts, Multiresolution_skeletonization_traits)
{
  EXPECT_TRUE((CSCD::is_multiresolution_skeletonization_traits_v<CSCD::Triangle_mesh_traits<Mesh>>));
  EXPECT_TRUE(CSCD::is_multiresolution_skeletonization_traits_v<Triangulated_body>);
  EXPECT_FALSE(CSCD::is_multiresolution_skeletonization_traits_v<Levels_by_value>) << "the levels must stay";
  EXPECT_FALSE(CSCD::is_multiresolution_skeletonization_traits_v<Two_sites>);
  CSCD::check_multiresolution_skeletonization_traits<Triangulated_body>();
}

TEST(Concepts, Solid_skeletonization_traits)
{
  EXPECT_TRUE((CSCD::is_solid_skeletonization_traits_v<CSCD::Triangle_mesh_traits<Mesh>>));
  EXPECT_TRUE(CSCD::is_solid_skeletonization_traits_v<Body>);
  EXPECT_FALSE(CSCD::is_solid_skeletonization_traits_v<Levels_by_value>);
  EXPECT_FALSE(CSCD::Solid_skeletonization_traits_requirements<Body_that_returns_crossings>::has_crossings);
  EXPECT_TRUE(CSCD::Solid_skeletonization_traits_requirements<Body_that_returns_crossings>::has_surface);
  EXPECT_FALSE(CSCD::Solid_skeletonization_traits_requirements<Body_with_a_surface_by_value>::has_surface);
  EXPECT_FALSE(CSCD::Solid_skeletonization_traits_requirements<Body_without_edges>::has_surface);
  EXPECT_FALSE(CSCD::Solid_skeletonization_traits_requirements<Body_without_a_middle>::has_middle_behind);
  CSCD::check_solid_skeletonization_traits<Body>();
}

TEST(Concepts, Triangulated_solid_skeletonization_traits)
{
  using Always_hit = Triangulated_body_that_is_always_hit;
  using Without_faces = Triangulated_body_without_faces;
  EXPECT_TRUE((CSCD::is_triangulated_solid_skeletonization_traits_v<CSCD::Triangle_mesh_traits<Mesh>>));
  EXPECT_TRUE(CSCD::is_triangulated_solid_skeletonization_traits_v<Triangulated_body>);
  EXPECT_FALSE(CSCD::is_triangulated_solid_skeletonization_traits_v<Body>);
  EXPECT_FALSE(CSCD::Triangulated_solid_skeletonization_traits_requirements<Always_hit>::has_first_hit);
  EXPECT_TRUE(CSCD::Triangulated_solid_skeletonization_traits_requirements<Always_hit>::has_closest_point);
  EXPECT_FALSE(CSCD::Triangulated_solid_skeletonization_traits_requirements<Without_faces>::has_first_hit);
  CSCD::check_triangulated_solid_skeletonization_traits<Triangulated_body>();
}

struct Weight_in_words
{
  std::string operator()(const CSCD::Separator& separator) const;
};

TEST(Concepts, Separator_weight)
{
  EXPECT_TRUE(CSCD::is_separator_cost_v<CSCD::Length_and_planarity_cost>);
  EXPECT_TRUE(CSCD::is_separator_cost_v<float (*)(CSCD::Separator)>);
  EXPECT_FALSE(CSCD::is_separator_cost_v<Weight_in_words>);
  EXPECT_FALSE(CSCD::is_separator_cost_v<double>);
  CSCD::check_separator_cost<CSCD::Length_and_planarity_cost>();
}

struct Finder_that_answers_by_value
{
  CSCD::Search_result operator()(unsigned source, unsigned level_hint);
};

struct Finder_of_nothing
{
  void operator()(unsigned source, unsigned level_hint, CSCD::Search_result& result);
};

struct Policies_for_bodies
{
  struct Packing
  {
    const std::vector<unsigned>& packed() const;
  };
  template <class ConcurrencyTag, class Progress>
  std::vector<CSCD::Separator> find_separators(const Body& body, const CSCD::Search_settings& settings,
                                               CSCD::Skeletonization_report& report, const Progress& progress) const;
  Packing pack_separators(const Body& body, std::vector<CSCD::Separator>& separators,
                          CSCD::Skeletonization_report& report) const;
  CSCD::Embedded_skeleton build_skeleton(const Body& body, const std::vector<CSCD::Separator>& separators,
                                         const Packing& packing, CSCD::Skeletonization_report& report) const;
};

struct Policies_that_pack_by_value : Policies_for_bodies
{
  struct Packing
  {
    std::vector<unsigned> packed() const;
  };
  Packing pack_separators(const Body& body, std::vector<CSCD::Separator>& separators,
                          CSCD::Skeletonization_report& report) const;
};

TEST(Concepts, Skeletonization_policies)
{
  using Traits = CSCD::Triangle_mesh_traits<Mesh>;
  EXPECT_TRUE((CSCD::is_skeletonization_policies_v<CSCD::Local_policies<Traits>, Traits>));
  EXPECT_TRUE((CSCD::is_skeletonization_policies_v<Policies_for_bodies, Body>));
  EXPECT_FALSE((CSCD::is_skeletonization_policies_v<Policies_for_bodies, Traits>));
  EXPECT_FALSE((CSCD::is_skeletonization_policies_v<Policies_that_pack_by_value, Body>));
  EXPECT_FALSE((CSCD::is_skeletonization_policies_v<Body, Body>));
  EXPECT_TRUE((CSCD::is_separator_finder_v<CSCD::Local_separator_finder<Traits>, Traits>));
  EXPECT_FALSE((CSCD::is_separator_finder_v<Finder_that_answers_by_value, Traits>));
  EXPECT_FALSE((CSCD::is_separator_finder_v<Finder_of_nothing, Traits>));
  CSCD::check_skeletonization_policies<CSCD::Local_policies<Traits>, Traits>();
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
