// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Significance of branches, and the simplification of skeletons: on trees with known answers, and invariants on random
// graphs.

#include "support/invariants.h"
#include "support/point_skeletons.h"
#include "support/swept_shapes.h"
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/connected_components.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace parameters = CSCD::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t add_node(Skeleton& skeleton, const Point& point, double radius)
{
  const std::size_t node = add_vertex(skeleton);
  skeleton[node].point = point;
  skeleton[node].radius = radius;
  skeleton[node].vertices = {2 * node, 2 * node + 1};
  return node;
}

/// Adds a straight limb of `number` edges from `base`. \return the tip
std::size_t add_limb(Skeleton& skeleton, std::size_t base, const Kernel::Vector_3& step, int number, double radius)
{
  for (int i = 0; i < number; ++i) {
    const std::size_t next = add_node(skeleton, skeleton[base].point + step, radius);
    add_edge(base, next, skeleton);
    base = next;
  }
  return base;
}

double significance_at(const Skeleton& skeleton, std::size_t node)
{
  return skeleton[*out_edges(node, skeleton).first].significance;
}

std::vector<std::size_t> sorted_vertices(const Skeleton& skeleton)
{
  std::vector<std::size_t> result;
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    result.insert(result.end(), skeleton[node].vertices.begin(), skeleton[node].vertices.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Positions, radii and edges without numbering.
auto content(const Skeleton& skeleton)
{
  const auto node = [&](std::size_t v) {
    const Point& p = skeleton[v].point;
    return std::array<double, 4>{p.x(), p.y(), p.z(), skeleton[v].radius};
  };
  std::multiset<std::array<double, 4>> nodes;
  std::multiset<std::tuple<std::array<double, 4>, std::array<double, 4>, double>> ends;
  for (const auto v : boost::make_iterator_range(vertices(skeleton))) {
    nodes.insert(node(v));
  }
  for (const auto e : boost::make_iterator_range(edges(skeleton))) {
    std::array nodes_of_edge{node(source(e, skeleton)), node(target(e, skeleton))};
    std::sort(nodes_of_edge.begin(), nodes_of_edge.end());
    ends.emplace(nodes_of_edge[0], nodes_of_edge[1], skeleton[e].significance);
  }
  return std::make_pair(nodes, ends);
}

/// A simple graph of several components, some of them isolated nodes, some with cycles, with coordinates on a coarse
/// lattice so that there are edges without length and equal limbs; some radii are 0.
Skeleton random_skeleton(unsigned seed)
{
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return unsigned(random() % n); };
  Skeleton skeleton;
  const unsigned number = 1 + below(60);
  const unsigned extent = 3 + below(30);
  for (unsigned i = 0; i < number; ++i) {
    add_node(skeleton, Point(below(extent), below(extent), below(extent)), below(5) / 2.);
  }
  skeleton[0].radius = 1; // so that there are radii
  std::set<std::pair<unsigned, unsigned>> taken;
  const auto join = [&](unsigned a, unsigned b) {
    if (a != b && taken.insert(std::minmax(a, b)).second) {
      add_edge(a, b, skeleton);
    }
  };
  for (unsigned i = 1; i < number; ++i) {
    if (below(10) > 0) {
      join(i, i - 1 - below(std::min(i, 1 + below(8))));
    }
  }
  for (unsigned i = below(5); i > 0; --i) {
    join(below(number), below(number));
  }
  return skeleton;
}

TEST(Significance, is_the_reach_beyond_the_body_in_radii)
{
  // A rod of radius 4 along x, and on its middle limbs of radius 1 and 2, and a bump.
  Skeleton skeleton;
  const std::size_t middle = add_node(skeleton, Point(0, 0, 0), 4);
  const std::size_t left = add_limb(skeleton, middle, {-10, 0, 0}, 5, 4);
  add_limb(skeleton, middle, {10, 0, 0}, 6, 4);
  const std::size_t thin = add_limb(skeleton, middle, {0, 1, 0}, 9, 1);
  const std::size_t thick = add_limb(skeleton, middle, {0, 0, 2}, 5, 2);
  const std::size_t bump = add_limb(skeleton, middle, {0, -0.5, 0}, 4, 1);
  CSCD::compute_significance(skeleton);
  EXPECT_NEAR(significance_at(skeleton, thin), 9 + 1 - 4, 1e-12);
  EXPECT_NEAR(significance_at(skeleton, thick), (10 + 2 - 4) / 2., 1e-12);
  EXPECT_EQ(significance_at(skeleton, bump), 0);
  // The rod is left last: as long as both halves and both tips.
  EXPECT_NEAR(significance_at(skeleton, left), (110 + 4 + 4) / 8. - 1, 1e-12);
}

TEST(Significance, cycles_and_what_joins_them_are_infinitely_significant)
{
  Skeleton skeleton;
  for (const double x : {0., 20.}) {
    const std::size_t first = add_node(skeleton, Point(x, 0, 0), 1);
    add_limb(skeleton, first, {0, 5, 0}, 2, 1);
    add_edge(first, first + 2, skeleton);
  }
  add_edge(0, 3, skeleton);
  const std::size_t tip = add_limb(skeleton, 1, {0, 0, 3}, 2, 1);
  CSCD::compute_significance(skeleton);
  for (const auto e : boost::make_iterator_range(edges(skeleton))) {
    const bool is_limb = source(e, skeleton) > 5 || target(e, skeleton) > 5;
    EXPECT_EQ(skeleton[e].significance, is_limb ? 6 : infinity) << e;
  }
  CSCD::simplify_skeleton(skeleton, parameters::minimum_significance(1e300));
  EXPECT_EQ(num_vertices(skeleton), 6u);
  EXPECT_EQ(CSCD::test::skeleton_facts(skeleton).betti_number, 2u);
  EXPECT_EQ(skeleton[1].vertices.size(), 6u) << "those of the limb with tip " << tip;
}

TEST(Simplify_skeleton, pruning_keeps_what_is_as_significant_as_asked)
{
  for (unsigned seed = 0; seed < 100; ++seed) {
    Skeleton skeleton = random_skeleton(seed);
    CSCD::compute_significance(skeleton);
    for (const double threshold : {0.5, 1., 3., 10.}) {
      Skeleton pruned = skeleton;
      CSCD::simplify_skeleton(pruned, parameters::minimum_significance(threshold));
      std::size_t number_of_kept = 0;
      for (const auto e : boost::make_iterator_range(edges(skeleton))) {
        number_of_kept += skeleton[e].significance >= threshold ? 1 : 0;
      }
      std::size_t number_of_significant = 0;
      for (const auto e : boost::make_iterator_range(edges(pruned))) {
        number_of_significant += pruned[e].significance >= threshold ? 1 : 0;
      }
      EXPECT_EQ(number_of_significant, number_of_kept) << seed << ", " << threshold;
      // The other remaining edges are components that are one path each.
      for (const auto e : boost::make_iterator_range(edges(pruned))) {
        if (pruned[e].significance < threshold) {
          EXPECT_LE(out_degree(source(e, pruned), pruned), 2u) << seed;
          EXPECT_LE(out_degree(target(e, pruned), pruned), 2u) << seed;
        }
      }
    }
  }
}

TEST(Simplify_skeleton, topology_and_partition_stay_and_repetition_changes_nothing)
{
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Skeleton skeleton = random_skeleton(seed);
    std::mt19937 random(seed);
    const auto sometimes = [&](double greatest) {
      return random() % 2 == 0 ? 0. : std::uniform_real_distribution<double>(0, greatest)(random);
    };
    const double significance = sometimes(8);
    const double length = sometimes(20);
    const double length_over_radius = sometimes(10);
    const double spacing = sometimes(6);
    const double spacing_over_radius = spacing > 0 ? 0 : sometimes(4);
    const bool joins = random() % 2 == 0;
    const auto pruning = parameters::minimum_significance(significance)
                             .minimum_branch_length(length)
                             .minimum_length_over_radius(length_over_radius);
    const auto all = pruning.join_components(joins).spacing(spacing).spacing_over_radius(spacing_over_radius);
    Skeleton simplified = skeleton;
    const CSCD::Simplification_report report = CSCD::simplify_skeleton(simplified, all);
    const CSCD::test::Skeleton_facts before = CSCD::test::skeleton_facts(skeleton);
    const CSCD::test::Skeleton_facts facts = CSCD::test::skeleton_facts(simplified);
    EXPECT_EQ(facts.betti_number, before.betti_number) << seed;
    EXPECT_EQ(report.betti_number, facts.betti_number) << seed;
    EXPECT_EQ(facts.number_of_components, joins ? 1 : before.number_of_components) << seed;
    EXPECT_EQ(report.number_of_components, facts.number_of_components) << seed;
    EXPECT_EQ(report.number_of_nodes, facts.number_of_nodes) << seed;
    EXPECT_EQ(report.number_of_edges, facts.number_of_edges) << seed;
    EXPECT_EQ(report.number_of_joined_edges, joins ? before.number_of_components - 1 : 0) << seed;
    CSCD::test::expect_partition(simplified, 2 * before.number_of_nodes);
    EXPECT_EQ(CSCD::test::violations_of_graph(simplified), CSCD::test::Violations{}) << seed;
    const auto all_edges = edges(simplified);
    EXPECT_EQ(std::size_t(std::count_if(all_edges.first, all_edges.second,
                                        [&](const auto& e) { return simplified[e].is_joined; })),
              report.number_of_joined_edges)
        << seed;
    for (const auto v : boost::make_iterator_range(vertices(simplified))) {
      EXPECT_TRUE(simplified[v].radius >= 0 && simplified[v].radius <= 2) << seed;
    }

    const auto expect_idempotent = [&](const auto& np, const char* name) {
      Skeleton once = skeleton;
      CSCD::simplify_skeleton(once, np);
      Skeleton twice = once;
      CSCD::simplify_skeleton(twice, np);
      EXPECT_EQ(content(twice), content(once)) << name << ", seed " << seed;
    };
    expect_idempotent(parameters::minimum_significance(significance), "significance");
    expect_idempotent(parameters::minimum_branch_length(length), "length");
    expect_idempotent(parameters::minimum_length_over_radius(length_over_radius), "length over radius");
    expect_idempotent(parameters::join_components(true), "joining");
    expect_idempotent(parameters::minimum_component_size(9), "components");
  }
}

TEST(Simplify_skeleton, vertices_of_a_limb_go_to_where_it_was_cut)
{
  Skeleton skeleton;
  const std::size_t middle = add_node(skeleton, Point(0, 0, 0), 1);
  add_limb(skeleton, middle, {-2, 0, 0}, 5, 1);
  const std::size_t other = add_limb(skeleton, middle, {2, 0, 0}, 5, 1);
  // The limb bends so that its tip is next to the end of the rod, which would be the nearest node in space.
  std::size_t tip = add_limb(skeleton, middle, {0, 1, 0}, 1, 1);
  tip = add_limb(skeleton, tip, {1, 0, 0}, 8, 1);
  const CSCD::Simplification_report report = CSCD::simplify_skeleton(skeleton, parameters::minimum_branch_length(9.5));
  EXPECT_EQ(report.number_of_removed_nodes, 9u);
  EXPECT_EQ(skeleton[middle].vertices.size(), 2u + 18u);
  EXPECT_EQ(skeleton[other].vertices.size(), 2u);
}

TEST(Simplify_skeleton, samples_evenly_on_the_branch)
{
  Skeleton skeleton;
  const std::size_t first = add_node(skeleton, Point(0, 0, 0), 1);
  const std::size_t corner = add_limb(skeleton, first, {3, 0, 0}, 1, 2);
  add_limb(skeleton, corner, {0, 1, 0}, 9, 2);
  Skeleton relative = skeleton;
  CSCD::simplify_skeleton(skeleton, parameters::spacing(1.5));
  ASSERT_EQ(num_vertices(skeleton), 9u);
  std::multiset<std::pair<double, double>> places;
  for (const auto v : boost::make_iterator_range(vertices(skeleton))) {
    places.emplace(std::round(4 * skeleton[v].point.x()) / 4, std::round(4 * skeleton[v].point.y()) / 4);
    if (skeleton[v].point.x() == 1.5) {
      EXPECT_EQ(skeleton[v].radius, 1.5);
    }
  }
  const std::multiset<std::pair<double, double>> expected{{0, 0},   {1.5, 0}, {3, 0},   {3, 1.5}, {3, 3},
                                                          {3, 4.5}, {3, 6},   {3, 7.5}, {3, 9}};
  EXPECT_EQ(places, expected);
  EXPECT_EQ(sorted_vertices(skeleton).size(), 22u);

  CSCD::simplify_skeleton(relative, parameters::spacing_over_radius(0.5)); // 3 / 0.75 + 9 / 1 parts
  EXPECT_EQ(num_vertices(relative), 14u);
}

TEST(Simplify_skeleton, small_components_are_removed_but_for_the_largest)
{
  Skeleton skeleton;
  add_limb(skeleton, add_node(skeleton, Point(0, 0, 0), 1), {1, 0, 0}, 9, 1);
  add_limb(skeleton, add_node(skeleton, Point(0, 5, 0), 1), {1, 0, 0}, 4, 1);
  add_node(skeleton, Point(0, 9, 0), 1);
  Skeleton copy = skeleton;
  const CSCD::Simplification_report report = CSCD::simplify_skeleton(skeleton, parameters::minimum_component_size(10));
  EXPECT_EQ(report.number_of_removed_components, 1u);
  EXPECT_EQ(report.number_of_removed_vertices, 2u);
  EXPECT_EQ(sorted_vertices(skeleton).size(), 30u);
  CSCD::simplify_skeleton(copy, parameters::minimum_component_size(1000));
  EXPECT_EQ(num_vertices(copy), 10u);
  for (const auto v : boost::make_iterator_range(vertices(copy))) {
    copy[v].vertices.clear();
  }
  EXPECT_EQ(CSCD::simplify_skeleton(copy, parameters::minimum_component_size(11)).number_of_nodes, 10u);
}

TEST(Simplify_skeleton, joins_by_the_shortest_edges)
{
  // Against the minimum over all spanning trees, found by Prim's algorithm on all pairs.
  for (unsigned seed = 0; seed < 50; ++seed) {
    Skeleton skeleton = random_skeleton(1000 + seed);
    std::vector<std::size_t> component(num_vertices(skeleton));
    const auto number = std::size_t(boost::connected_components(skeleton, component.data()));
    std::vector<char> has_tip(number, 0);
    for (std::size_t v = 0; v < component.size(); ++v) {
      has_tip[component[v]] = has_tip[component[v]] != 0 || out_degree(v, skeleton) < 2 ? 1 : 0;
    }
    const auto is_end = [&](std::size_t v) { return out_degree(v, skeleton) < 2 || has_tip[component[v]] == 0; };
    std::vector<char> is_reached(number, 0);
    is_reached[component[0]] = 1;
    double expected = 0;
    for (std::size_t i = 1; i < number; ++i) {
      double least = infinity;
      std::size_t nearest = 0;
      for (std::size_t v = 0; v < component.size(); ++v) {
        for (std::size_t w = 0; w < component.size(); ++w) {
          if (is_reached[component[v]] != 0 && is_reached[component[w]] == 0 && (is_end(v) || is_end(w))) {
            const double length = std::sqrt(CGAL::squared_distance(skeleton[v].point, skeleton[w].point));
            if (length < least) {
              least = length;
              nearest = component[w];
            }
          }
        }
      }
      expected += least;
      is_reached[nearest] = 1;
    }
    CSCD::simplify_skeleton(skeleton, parameters::join_components(true));
    double length = 0;
    for (const auto e : boost::make_iterator_range(edges(skeleton))) {
      const double its_length =
          std::sqrt(CGAL::squared_distance(skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point));
      length += skeleton[e].is_joined ? its_length : 0;
    }
    EXPECT_NEAR(length, expected, 1e-9) << seed;
  }
}

TEST(Simplify_skeleton, joined_edges_stay_marked)
{
  Skeleton skeleton;
  add_limb(skeleton, add_node(skeleton, Point(0, 0, 0), 1), {1, 0, 0}, 9, 1);
  add_limb(skeleton, add_node(skeleton, Point(15, 0, 0), 1), {1, 0, 0}, 9, 1);
  CSCD::simplify_skeleton(skeleton, parameters::join_components(true).spacing(3));
  EXPECT_EQ(num_vertices(skeleton), 8u);
  CSCD::simplify_skeleton(skeleton, parameters::minimum_significance(1).spacing(1));
  std::size_t number = 0;
  for (const auto e : boost::make_iterator_range(edges(skeleton))) {
    const double length = std::abs(skeleton[source(e, skeleton)].point.x() - skeleton[target(e, skeleton)].point.x());
    EXPECT_NEAR(length, skeleton[e].is_joined ? 6 : 1, 1e-12);
    number += skeleton[e].is_joined ? 1 : 0;
  }
  EXPECT_EQ(number, 1u);
}

TEST(Simplify_skeleton, stays_inside_of_the_mesh)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  // Coarse sampling leaves the thin body of a ring.
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::torus(1, 0.1, 12));
  CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  const auto least_distance = [](const auto& graph) { // of an edge from the axis
    double least = infinity;
    for (const auto e : boost::make_iterator_range(edges(graph))) {
      const Point middle = CGAL::midpoint(graph[source(e, graph)].point, graph[target(e, graph)].point);
      least = std::min(least, std::hypot(middle.x(), middle.y()));
    }
    return least;
  };
  auto free = skeleton;
  const auto np = parameters::spacing(1.5);
  CSCD::simplify_skeleton(free, np);
  EXPECT_LT(least_distance(free), 0.9);
  const CSCD::Simplification_report report = CSCD::simplify_skeleton(skeleton, mesh, np);
  EXPECT_GT(least_distance(skeleton), 0.9);
  EXPECT_EQ(report.betti_number, 1u);
  EXPECT_LT(report.number_of_nodes, 30u);
  std::size_t number_of_vertices = 0;
  for (const auto v : boost::make_iterator_range(vertices(skeleton))) {
    number_of_vertices += skeleton[v].vertices.size();
  }
  EXPECT_EQ(number_of_vertices, num_vertices(mesh));
}

TEST(Simplify_skeleton, degenerate_skeletons)
{
  const auto all = parameters::minimum_significance(1)
                       .minimum_branch_length(1)
                       .minimum_length_over_radius(1)
                       .join_components(true)
                       .spacing(1)
                       .minimum_component_size(2);
  Skeleton empty;
  EXPECT_EQ(CSCD::simplify_skeleton(empty, all).number_of_nodes, 0u);

  Skeleton one;
  add_node(one, Point(1, 2, 3), 1);
  EXPECT_EQ(CSCD::simplify_skeleton(one, all).number_of_components, 1u);

  // All in one place.
  Skeleton point;
  const std::size_t middle = add_node(point, Point(1, 2, 3), 1);
  for (int i = 0; i < 4; ++i) {
    add_limb(point, middle, {0, 0, 0}, 3, 1);
  }
  const CSCD::Simplification_report report = CSCD::simplify_skeleton(point, all);
  EXPECT_EQ(report.number_of_components, 1u);
  EXPECT_EQ(report.number_of_tips, 2u);
  EXPECT_EQ(sorted_vertices(point).size(), 26u);

  // Loops and parallel edges are cycles, too; they may stay as they are.
  Skeleton loops;
  const std::size_t a = add_node(loops, Point(0, 0, 0), 1);
  const std::size_t b = add_limb(loops, a, {1, 0, 0}, 1, 1);
  add_edge(a, b, loops);
  add_edge(b, b, loops);
  add_limb(loops, a, {0, 0.1, 0}, 2, 1);
  const CSCD::Simplification_report of_loops = CSCD::simplify_skeleton(loops, all);
  EXPECT_EQ(of_loops.betti_number, 2u);
  EXPECT_EQ(of_loops.number_of_tips, 0u);
  EXPECT_EQ(sorted_vertices(loops).size(), 8u);
}

TEST(Simplify_skeleton, refuses_what_has_no_meaning)
{
  Skeleton skeleton;
  add_limb(skeleton, add_node(skeleton, Point(0, 0, 0), 1), {1, 0, 0}, 3, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton, parameters::minimum_significance(nan)), CSCD::Input_error);
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton, parameters::spacing(-1.)), CSCD::Input_error);
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton, parameters::minimum_branch_length(infinity)), CSCD::Input_error);
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton, parameters::spacing(1e-9)), CSCD::Input_error);
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton, parameters::spacing(1).spacing_over_radius(1)), CSCD::Input_error);
  EXPECT_EQ(num_vertices(skeleton), 4u);
  Skeleton without_radii = skeleton;
  for (const auto v : boost::make_iterator_range(vertices(without_radii))) {
    without_radii[v].radius = 0;
  }
  EXPECT_THROW(CSCD::simplify_skeleton(without_radii, parameters::minimum_significance(1)), CSCD::Input_error);
  EXPECT_NO_THROW(CSCD::simplify_skeleton(without_radii, parameters::minimum_branch_length(1)));
  skeleton[1].radius = nan;
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton), CSCD::Input_error);
  skeleton[1].radius = 1;
  skeleton[1].point = Point(0, nan, 0);
  EXPECT_THROW(CSCD::simplify_skeleton(skeleton), CSCD::Input_error);
}

} // namespace
