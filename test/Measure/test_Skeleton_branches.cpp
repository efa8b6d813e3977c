// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of branches and their table: measures of drawn skeletons, roots and orders, and parts of surfaces whose area
// and volume are known.

#include "support/Shape.h"
#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/swept_shapes.h"
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace {

using CSCD::Branch_end, CSCD::Index, CSCD::Root_rule, CSCD::Skeleton_branch, CSCD::Skeleton_branches, CSCD::test::pi,
    CSCD::test::to_graph;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

/// From a junction of radius 2 at the origin: limbs 0 - 1 - 2 of length 20 along x, and 0 - 3 and 0 - 4 of length 10
/// along y and z; the last one is bent at 5. An isolated node 6, and a square 7 - 8 - 9 - 10.
Skeleton limbs_and_square()
{
  return to_graph<Skeleton>({{0, 0, 0},
                             {10, 0, 0},
                             {20, 0, 0},
                             {0, 10, 0},
                             {3, 0, 4},
                             {0, 0, 8},
                             {50, 0, 0},
                             {0, 0, -50},
                             {1, 0, -50},
                             {1, 1, -50},
                             {0, 1, -50}},
                            {{0, 1}, {1, 2}, {0, 3}, {0, 4}, {4, 5}, {7, 8}, {8, 9}, {9, 10}, {10, 7}},
                            {2, 1.5, 1, 1, 0.5, 0.5, 3, 1, 1, 1, 1});
}

/// The branch between two ends.
const Skeleton_branch& between(const Skeleton_branches& table, Index a, Index b)
{
  for (const Skeleton_branch& branch : table.branches) {
    if (std::minmax(branch.nodes.front(), branch.nodes.back()) == std::minmax(a, b)) {
      return branch;
    }
  }
  ADD_FAILURE() << "no branch between " << a << " and " << b;
  return table.branches.front();
}

using Branches = std::vector<std::vector<std::size_t>>;

Branches branches(std::size_t number_of_nodes, const Edges& edges)
{
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  return CSCD::split_into_branches(Graph(edges.begin(), edges.end(), number_of_nodes));
}

TEST(Split_into_branches, of_known_graphs)
{
  EXPECT_EQ((Branches{{0}, {1}}), branches(2, {})) << "isolated nodes";
  EXPECT_EQ((Branches{{0, 2, 1, 3}}), branches(4, {{1, 3}, {2, 1}, {0, 2}})) << "a path, from its lesser end";
  EXPECT_EQ((Branches{{0, 1, 2, 0}}), branches(3, {{0, 1}, {1, 2}, {2, 0}})) << "a cycle";
  EXPECT_EQ((Branches{{3, 4}, {0, 1, 2, 0}}), branches(5, {{0, 1}, {1, 2}, {2, 0}, {3, 4}})) << "cycles come last";
  EXPECT_EQ((Branches{{0, 1}, {1, 2, 3, 1}}), branches(4, {{0, 1}, {1, 2}, {2, 3}, {3, 1}})) << "a loop at a junction";
  EXPECT_EQ((Branches{{0, 2, 1}, {0, 1}, {0, 3, 4, 1}}), branches(5, {{0, 2}, {2, 1}, {0, 1}, {0, 3}, {3, 4}, {4, 1}}));
  EXPECT_EQ((Branches{{0, 1}, {0, 1}, {0, 1}}), branches(2, {{0, 1}, {1, 0}, {0, 1}})) << "parallel edges";
  EXPECT_EQ((Branches{{0, 1, 0}}), branches(2, {{0, 1}, {1, 0}})) << "a cycle: both have degree 2";
  EXPECT_EQ((Branches{{0, 1}, {1, 2, 1}}), branches(3, {{0, 1}, {1, 2}, {2, 1}}));
}

using Ends = std::array<Branch_end, 2>;

TEST(Skeleton_branches, tells_what_branches_end_in)
{
  auto skeleton = limbs_and_square();
  EXPECT_EQ((Ends{Branch_end::junction, Branch_end::tip}), between(CSCD::measure_branches(skeleton), 0, 2).ends);
  skeleton[2].is_opening = true;
  const Skeleton_branches table = CSCD::measure_branches(skeleton);
  ASSERT_EQ(5u, table.branches.size());
  EXPECT_EQ((Ends{Branch_end::junction, Branch_end::opening}), between(table, 0, 2).ends);
  EXPECT_EQ((Ends{Branch_end::isolated, Branch_end::isolated}), between(table, 6, 6).ends);
  EXPECT_EQ((Ends{Branch_end::closed, Branch_end::closed}), between(table, 7, 7).ends);
}

TEST(Skeleton_branches, measures_lengths)
{
  const Skeleton_branches table = CSCD::measure_branches(limbs_and_square());
  EXPECT_EQ(20, between(table, 0, 2).length);
  EXPECT_EQ(1, between(table, 0, 2).tortuosity());
  EXPECT_EQ(10, between(table, 0, 5).length);
  EXPECT_EQ(8, between(table, 0, 5).chord);
  EXPECT_EQ(1.25, between(table, 0, 5).tortuosity());
  EXPECT_EQ(4, between(table, 7, 7).length);
  EXPECT_EQ(infinity, between(table, 7, 7).tortuosity());
  EXPECT_EQ(0, between(table, 6, 6).length);
  EXPECT_TRUE(std::isnan(between(table, 6, 6).tortuosity()));
}

TEST(Skeleton_branches, measures_radii_and_frusta)
{
  const Skeleton_branches table = CSCD::measure_branches(limbs_and_square());
  const Skeleton_branch& cone = between(table, 0, 2); // of radii 2 and 1, in two pieces
  EXPECT_EQ(1, cone.min_radius);
  EXPECT_EQ(1.5, cone.mean_radius);
  EXPECT_EQ(2, cone.max_radius);
  EXPECT_EQ((std::array<double, 2>{2, 1}), cone.end_radii);
  EXPECT_NEAR(pi * 20 * (4 + 2 + 1) / 3, cone.cone_volume, 1e-9);
  EXPECT_NEAR(pi * (2 + 1) * std::hypot(20, 1), cone.cone_area, 1e-9);
  EXPECT_TRUE(std::isnan(cone.volume));
  EXPECT_TRUE(std::isnan(cone.surface_area));
  EXPECT_EQ(3, between(table, 6, 6).mean_radius);
  EXPECT_EQ(0, between(table, 6, 6).cone_volume);
}

TEST(Skeleton_branches, junctions_belong_to_the_thickest_branch)
{
  const Skeleton_branches table = CSCD::measure_branches(limbs_and_square());
  EXPECT_EQ(&between(table, 0, 2), &table.branches[table.branch_of_node[0]]);
  EXPECT_EQ(&between(table, 0, 5), &table.branches[table.branch_of_node[4]]);
  EXPECT_EQ(&between(table, 6, 6), &table.branches[table.branch_of_node[6]]);
}

TEST(Find_roots, obeys_rules_in_each_component)
{
  using Roots = std::vector<Index>;
  Skeleton skeleton = limbs_and_square();
  EXPECT_EQ((Roots{0, 6, 7}), find_roots(skeleton, Root_rule::thickest));
  EXPECT_EQ((Roots{0, 6, 7}), find_roots(skeleton, Root_rule::lowest)); // the first of several
  skeleton[3].point = Point(0, 10, -1);
  EXPECT_EQ((Roots{3, 6, 7}), find_roots(skeleton, Root_rule::lowest));
  EXPECT_EQ((Roots{5, 6, 9}), find_roots(skeleton, Point(1, 3, 9)));
  EXPECT_TRUE(find_roots(Skeleton(), Root_rule::longest).empty());
}

TEST(Find_roots, longest_is_the_thicker_end_of_the_longest_path)
{
  for (const double radius : {0.5, 2.}) {
    const Skeleton skeleton =
        to_graph<Skeleton>({{0, 0, 0}, {-5, 0, 0}, {9, 0, 0}, {0, 4, 0}}, {{0, 1}, {0, 2}, {0, 3}}, {9, radius, 1, 3});
    EXPECT_EQ((std::vector<Index>{radius > 1 ? 1u : 2u}), find_roots(skeleton, Root_rule::longest));
  }
}

TEST(Skeleton_branches, orders_count_branches_from_the_root)
{
  // A path 0 - 1 - 2 - 3 with limbs 4 at 1, and 5 and 6 at 2.
  const Skeleton skeleton =
      to_graph<Skeleton>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 1}},
                         {{0, 1}, {1, 2}, {2, 3}, {1, 4}, {2, 5}, {2, 6}}, {1, 1, 1, 1, 1, 1, 1});
  EXPECT_FALSE(between(CSCD::measure_branches(skeleton), 0, 1).order);
  Skeleton_branches table = CSCD::measure_branches(skeleton, {0});
  const auto number = [&table](Index a, Index b) { return std::size_t(&between(table, a, b) - table.branches.data()); };
  EXPECT_EQ(std::nullopt, between(table, 0, 1).parent);
  EXPECT_EQ(0u, between(table, 0, 1).order);
  EXPECT_EQ(1u, between(table, 1, 4).order);
  EXPECT_EQ(number(0, 1), between(table, 1, 4).parent);
  EXPECT_EQ(2u, between(table, 2, 6).order);
  EXPECT_EQ(number(1, 2), between(table, 2, 6).parent);
  table = CSCD::measure_branches(skeleton, {2}); // a junction: all that end there have no parent
  EXPECT_EQ(0u, between(table, 1, 2).order);
  EXPECT_EQ(std::nullopt, between(table, 2, 5).parent);
  EXPECT_EQ(number(1, 2), between(table, 0, 1).parent);
}

TEST(Skeleton_branches, cycles_have_an_order_on_both_sides_of_where_they_are_cut)
{
  // A tail 0 - 1, two paths from 1 to 2 (a thin one by 3, and a direct edge), and a tail 2 - 4.
  const Skeleton skeleton =
      to_graph<Skeleton>({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 1, 0}, {4, 0, 0}, {2, -1, 0}},
                         {{0, 1}, {1, 3}, {3, 2}, {2, 4}, {1, 5}, {5, 2}, {1, 2}}, {2, 2, 2, 0.1, 2, 1});
  const std::size_t skeleton_size = num_vertices(skeleton);
  const CSCD::internal::Rooted_forest forest(CSCD::internal::index_skeleton(skeleton), {4});
  ASSERT_EQ(2u, forest.loops().size());
  EXPECT_EQ(skeleton_size, forest.order().size());
  for (const auto& [u, v] : forest.loops()) {
    EXPECT_TRUE(u == 3 || v == 3 || u == 5 || v == 5); // the thin ones
  }
  const Skeleton_branches table = CSCD::measure_branches(skeleton, {4});
  EXPECT_EQ(0u, between(table, 2, 4).order);
  EXPECT_EQ(2u, between(table, 0, 1).order);
  for (const Skeleton_branch& branch : table.branches) {
    ASSERT_TRUE(branch.order);
    EXPECT_EQ(*branch.order > 0, branch.parent.has_value());
    if (branch.parent) {
      EXPECT_EQ(*branch.order, *table.branches[*branch.parent].order + 1);
    }
  }
}

struct Sum
{
  double area = 0;
  double volume = 0;
};

Sum sum_over_branches(const Skeleton_branches& table)
{
  Sum sum;
  for (const Skeleton_branch& branch : table.branches) {
    sum.area += branch.surface_area;
    sum.volume += branch.volume;
  }
  return sum;
}

Skeleton_branches branches_of_shape(const CSCD::test::Shape& shape, Mesh& mesh)
{
  mesh = CSCD::test::to_mesh<Mesh>(shape);
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  return CSCD::measure_branches(skeleton, mesh);
}

TEST(Skeleton_branches, parts_of_the_surface_add_up_to_it)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  for (const CSCD::test::Shape& shape :
       {CSCD::test::jack(0.2), CSCD::test::ladder(2, 0.2), CSCD::test::torus(3, 1, 24), CSCD::test::hand(0.15)}) {
    SCOPED_TRACE(shape.name);
    Mesh mesh;
    const Sum sum = sum_over_branches(branches_of_shape(shape, mesh));
    EXPECT_NEAR(PMP::area(mesh), sum.area, 1e-9 * sum.area);
    EXPECT_NEAR(PMP::volume(mesh), sum.volume, 1e-9 * sum.volume);
  }
}

TEST(Skeleton_branches, equal_limbs_have_equal_parts)
{
  Mesh mesh;
  const Skeleton_branches table = branches_of_shape(CSCD::test::y_tube(0.1), mesh); // of length 3 and radius 0.4
  ASSERT_EQ(3u, table.branches.size());
  const double third = sum_over_branches(table).volume / 3;
  EXPECT_NEAR(pi * 0.16 * 3, third, 0.1 * third);
  for (const Skeleton_branch& branch : table.branches) {
    EXPECT_NEAR(third, branch.volume, 0.1 * third);
    EXPECT_NEAR(sum_over_branches(table).area / 3, branch.surface_area, 0.1 * branch.surface_area);
    EXPECT_NEAR(third, branch.cone_volume, 0.15 * third);
  }
}

TEST(Node_measures, of_a_prism_are_exact)
{
  constexpr std::size_t around = 24;
  constexpr std::size_t number_of_nodes = 11;
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::tube(10, 1, around, CSCD::test::Tube_end::flat));
  std::vector<CSCD::test::Triple> points;
  Edges edges;
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    points.push_back({0.17 + 0.96 * double(i), 0, 0});
    edges.emplace_back(i, i + 1);
  }
  points.push_back({50, 0, 0}); // outside, with no vertices
  auto skeleton = to_graph<Skeleton>(points, edges, std::vector<double>(points.size(), 1));
  for (const auto vertex : vertices(mesh)) {
    const double position = std::round((mesh.point(vertex).x() - 0.17) / 0.96);
    skeleton[std::size_t(std::clamp(position, 0., double(number_of_nodes - 1)))].vertices.push_back(vertex);
  }
  const std::vector<CSCD::Node_measures> measures = CSCD::measure_nodes(skeleton, mesh);
  ASSERT_EQ(number_of_nodes + 1, measures.size());
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    EXPECT_NEAR(around * std::sin(2 * pi / around) / 2, measures[i].section_area, 1e-9) << i;
    const double to_end = std::min(0.17 + 0.96 * double(i), 10 - (0.17 + 0.96 * double(i)));
    EXPECT_NEAR(std::min(std::cos(pi / around), to_end), measures[i].inscribed_radius, 1e-9) << i;
  }
  EXPECT_TRUE(std::isnan(measures.back().section_area));
}

TEST(Node_measures, of_a_torus_are_those_of_its_circle)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::torus(3, 1, 32));
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  for (const CSCD::Node_measures& measured : CSCD::measure_nodes(skeleton, mesh)) {
    EXPECT_NEAR(pi, measured.section_area, 0.1);
    EXPECT_NEAR(1, measured.inscribed_radius, 0.05);
  }
}

TEST(Skeleton_branches, openings_count_as_closed)
{
  constexpr std::size_t around = 48;
  for (const auto end : {CSCD::test::Tube_end::open, CSCD::test::Tube_end::flat}) {
    Mesh mesh;
    const Skeleton_branches table = branches_of_shape(CSCD::test::tube(10, 1, around, end), mesh);
    ASSERT_EQ(1u, table.branches.size());
    // A prism over a polygon inscribed in the circle.
    EXPECT_NEAR(10 * around * std::sin(2 * pi / around) / 2, table.branches[0].volume, 1e-3);
  }
}

TEST(Skeleton_branches, volume_is_positive_if_the_surface_faces_inwards)
{
  Mesh mesh;
  const double volume = sum_over_branches(branches_of_shape(CSCD::test::y_tube(0.2), mesh)).volume;
  EXPECT_LT(0, volume);
  CSCD::test::Shape shape = CSCD::test::reversed(CSCD::test::y_tube(0.2));
  EXPECT_NEAR(volume, sum_over_branches(branches_of_shape(shape, mesh)).volume, 1e-6 * volume);
}

} // namespace
