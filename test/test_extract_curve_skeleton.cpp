// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The whole pipeline on generated shapes with known answers, and the guarantees of the entry point.

#include "support/Centreline_error.h"
#include "support/Inside_count.h"
#include "support/expect_skeleton.h"
#include "support/invariants.h"
#include "support/shapes.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::test::Shape, CSCD::test::Shape_maker, CSCD::test::Violations;
namespace parameters = CSCD::parameters;

/// A shape, its mesh and the result of the pipeline.
class Skeletonized_shape : public testing::TestWithParam<Shape_maker>
{
protected:
  Skeletonized_shape()
      : m_shape(GetParam().make()), m_mesh(CSCD::test::to_mesh<Mesh>(m_shape)),
        m_report(CSCD::extract_curve_skeleton(m_mesh, m_skeleton))
  {
  }

  Shape m_shape;
  Mesh m_mesh;
  Skeleton m_skeleton;
  CSCD::Skeletonization_report m_report;
};

class Closed_shape : public Skeletonized_shape
{
};

TEST_P(Closed_shape, satisfies_the_invariants)
{
  EXPECT_EQ(CSCD::test::violated_invariants(m_mesh, m_skeleton, m_report), Violations{});
  EXPECT_EQ(m_report.number_of_bridged_borders, 0u);
  EXPECT_EQ(m_report.betti_number, m_shape.genus);
}

TEST_P(Closed_shape, has_its_skeleton_inside)
{
  const CSCD::test::Inside_count count = CSCD::test::count_inside(m_mesh, m_skeleton);
  EXPECT_EQ(count.number_of_nodes_outside, m_report.number_of_nodes_outside);
  EXPECT_EQ(count.number_of_nodes_outside, 0u) << "of " << count.number_of_nodes;
  EXPECT_GE(count.fraction_of_length_inside(), 0.999);
}

INSTANTIATE_TEST_SUITE_P(Known, Closed_shape, testing::ValuesIn(CSCD::test::shapes_with_known_skeleton()),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Hard, Closed_shape, testing::ValuesIn(CSCD::test::hard_closed_shapes()),
                         testing::PrintToStringParamName());

class Known_skeleton : public Skeletonized_shape
{
};

TEST_P(Known_skeleton, has_the_known_tips_and_junctions)
{
  EXPECT_EQ(m_report.number_of_tips, m_shape.number_of_tips);
  EXPECT_EQ(m_report.number_of_junctions, m_shape.number_of_junctions);
}

TEST_P(Known_skeleton, follows_the_known_centreline)
{
  const CSCD::test::Centreline_error error = CSCD::test::centreline_error(m_shape, m_skeleton);
  // All in units of the local radius. The axis of a limb ends where its cap begins; a skeleton may go on into the cap
  // or stop short of it by about a radius.
  EXPECT_LT(error.mean_of_nodes, 0.1);
  EXPECT_LT(error.max_of_nodes, 1);
  EXPECT_LT(error.max_gap, 1.5);
  EXPECT_LT(error.max_of_radii, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Known, Known_skeleton, testing::ValuesIn(CSCD::test::shapes_with_known_skeleton()),
                         testing::PrintToStringParamName());

class Open_shape : public Skeletonized_shape
{
};

TEST_P(Open_shape, satisfies_the_invariants)
{
  EXPECT_EQ(CSCD::test::violated_invariants(m_mesh, m_skeleton, m_report), Violations{});
  EXPECT_EQ(m_report.number_of_bridged_borders + m_report.number_of_wide_borders, m_shape.number_of_border_cycles);
}

INSTANTIATE_TEST_SUITE_P(All, Open_shape, testing::ValuesIn(CSCD::test::open_shapes()),
                         testing::PrintToStringParamName());

/// Removes the triangles with all corners in the part of space `is_removed`.
template <class Predicate>
Shape cut_off(Shape shape, const Predicate& is_removed)
{
  std::vector<bool> is_removed_triangle;
  for (const CSCD::test::Triangle& triangle : shape.triangles) {
    is_removed_triangle.push_back(std::all_of(triangle.begin(), triangle.end(),
                                              [&](std::size_t corner) { return is_removed(shape.points[corner]); }));
  }
  CSCD::test::remove_triangles(shape, is_removed_triangle);
  return shape;
}

/// Limbs that end at borders.
class Open_end : public testing::Test
{
protected:
  void skeletonize(const Shape& shape)
  {
    m_report = CSCD::extract_curve_skeleton(CSCD::test::to_mesh<Mesh>(shape), m_skeleton);
    m_openings.clear();
    for (const auto node : boost::make_iterator_range(vertices(m_skeleton))) {
      if (m_skeleton[node].is_opening) {
        EXPECT_EQ(out_degree(node, m_skeleton), 1u);
        m_openings.push_back(m_skeleton[node]);
      }
    }
    EXPECT_EQ(m_report.number_of_openings, m_openings.size());
  }

  /// Distance of the nearest opening from a point.
  double distance(const Point& point) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& opening : m_openings) {
      least = std::min(least, std::sqrt(CGAL::squared_distance(point, opening.point)));
    }
    return least;
  }

  CSCD::Skeletonization_report m_report;
  Skeleton m_skeleton;
  std::vector<Skeleton::vertex_bundled> m_openings;
};

// Far enough from the border to be inside of it, near enough to reach it.
constexpr double max_gap = 0.05;

TEST_F(Open_end, tube_is_followed_from_end_to_end)
{
  for (const double length : {3., 6., 15.}) {
    skeletonize(CSCD::test::tube(length, 1, 24, CSCD::test::Tube_end::open));
    EXPECT_EQ(m_openings.size(), 2u) << length;
    EXPECT_EQ(m_report.number_of_tips, 2u) << length;
    EXPECT_LT(distance(Point(0, 0, 0)), max_gap) << length;
    EXPECT_LT(distance(Point(length, 0, 0)), max_gap) << length;
    for (const auto& opening : m_openings) {
      EXPECT_NEAR(opening.radius, 1, max_gap);
    }
  }
}

TEST_F(Open_end, oblique_cut_ends_at_the_middle_of_the_border)
{
  Shape shape = CSCD::test::tube(12, 1, 24, CSCD::test::Tube_end::open);
  for (CSCD::test::Triple& point : shape.points) {
    point[0] += point[0] / 12 * point[1]; // the plane of the end is at 45 degrees to the axis
  }
  skeletonize(shape);
  EXPECT_EQ(m_report.number_of_tips, 2u);
  EXPECT_LT(distance(Point(0, 0, 0)), max_gap);
  EXPECT_LT(distance(Point(12, 0, 0)), max_gap);
}

TEST_F(Open_end, each_limb_that_is_cut_off_is_open)
{
  const Shape shape = CSCD::test::y_tube(0.1);
  const auto radius = [](const CSCD::test::Triple& p) { return std::hypot(p[0], p[1], p[2]); };
  skeletonize(cut_off(shape, [&](const CSCD::test::Triple& p) { return radius(p) > 2.5; }));
  EXPECT_EQ(m_openings.size(), 3u);
  EXPECT_EQ(m_report.number_of_tips, 3u);
  EXPECT_EQ(m_report.number_of_junctions, 1u);
  const auto tip = std::max_element(shape.points.begin(), shape.points.end());
  skeletonize(cut_off(shape, [&](const CSCD::test::Triple& p) {
    return radius(p) > 2.5 && p[0] * (*tip)[0] + p[1] * (*tip)[1] > 0.9 * radius(p) * radius(*tip);
  }));
  EXPECT_EQ(m_openings.size(), 1u);
  EXPECT_EQ(m_report.number_of_tips, 3u);
}

TEST_F(Open_end, holes_windows_and_sheets_are_none)
{
  const Shape capsule = CSCD::test::capsule(8, 1, 32);
  skeletonize(cut_off(capsule, [](const CSCD::test::Triple& p) { return p[0] > 8.97; })); // a pinhole at the tip
  EXPECT_EQ(m_report.number_of_bridged_borders, 1u);
  EXPECT_TRUE(m_openings.empty());
  for (const double middle : {4., 7.}) { // a window in the side, also at the end of the limb
    skeletonize(
        cut_off(capsule, [&](const CSCD::test::Triple& p) { return std::fabs(p[0] - middle) < 0.8 && p[2] > 0.3; }));
    EXPECT_EQ(m_report.number_of_bridged_borders, 1u);
    EXPECT_TRUE(m_openings.empty()) << middle;
  }
  skeletonize(cut_off(capsule, [](const CSCD::test::Triple& p) { return p[2] > 0.1; })); // half a pipe
  EXPECT_TRUE(m_openings.empty());
  skeletonize(CSCD::test::flat_disc(8, 24));
  EXPECT_TRUE(m_openings.empty());
  for (const double height : {0.35, 0.5, 0.65}) { // small holes all over a body without limbs
    for (const std::size_t number : {12, 20, 32}) {
      skeletonize(CSCD::test::with_small_holes(CSCD::test::ellipsoid({1, 1, height}, 4), number, 1));
      EXPECT_EQ(m_report.number_of_bridged_borders, number);
      EXPECT_TRUE(m_openings.empty()) << height << ' ' << number;
    }
  }
}

/// The guarantees of the entry point, on one shape.
class Extract_curve_skeleton : public testing::Test
{
protected:
  Mesh m_mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2));
  Skeleton m_skeleton;
};

TEST_F(Extract_curve_skeleton, keeps_the_invariants_for_every_seed)
{
  for (unsigned int seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    m_skeleton[add_vertex(m_skeleton)].vertices.push_back(*m_mesh.vertices().begin()); // is not to stay
    const auto report = CSCD::test::expect_skeleton(m_mesh, m_skeleton, parameters::random_seed(seed));
    EXPECT_EQ(report.number_of_tips, 3u);
    EXPECT_EQ(report.number_of_junctions, 1u);
  }
}

TEST_F(Extract_curve_skeleton, keeps_to_the_maximum_number_of_sources)
{
  for (const std::size_t maximum : {std::size_t(1), std::size_t(10), std::size_t(100)}) {
    SCOPED_TRACE(maximum);
    const auto report = CSCD::test::expect_skeleton(m_mesh, m_skeleton, parameters::maximum_number_of_sources(maximum));
    EXPECT_LE(report.number_of_sources, maximum);
  }
}

TEST_F(Extract_curve_skeleton, tells_what_it_did)
{
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(m_mesh, m_skeleton);
  EXPECT_GT(report.number_of_sources, 0u);
  EXPECT_GT(report.number_of_separators, 0u);
  EXPECT_GT(report.number_of_packed_separators, 0u);
  EXPECT_LE(report.number_of_packed_separators, report.number_of_separators);
  EXPECT_GE(report.number_of_levels, 1u);
  EXPECT_EQ(report.number_of_threads, 1u);
  EXPECT_EQ(report.number_of_degenerate_faces, 0u);
  for (std::size_t stage = 0; stage < report.seconds.size(); ++stage) {
    EXPECT_GT(report.seconds[stage], 0);
  }
}

/// A body of radius 1 along the x axis with limbs of radius 0.5 that stand out by 0.2, 0.6 and 2.
Mesh body_with_limbs()
{
  const auto limb = [](double x, double height) { return CSCD::test::Limb{{x, 0, 0}, {x, 0, 0.5 + height}, 0.5, 0.5}; };
  return CSCD::test::to_mesh<Mesh>(CSCD::test::limb_shape(
      "body with limbs", {{{-5, 0, 0}, {5, 0, 0}, 1, 1}, limb(-3, 0.2), limb(0, 0.6), limb(3, 2)}, 0.15));
}

/// A body of revolution, as thick as `radii` at `places` of the x axis.
Mesh revolved(const std::vector<double>& places, const std::vector<double>& radii)
{
  std::vector<CSCD::test::Triple> points;
  for (const double x : places) {
    points.push_back({x, 0, 0});
  }
  return CSCD::test::to_mesh<Mesh>(CSCD::test::swept_shape("", points, radii, 24, CSCD::test::Tube_end::flat));
}

TEST(Thin_limb, of_long_faces_is_followed_to_its_end)
{
  for (const auto& [radius, rings] : {std::pair(0.003, 20), {0.01, 2}, {0.01, 20}, {0.03, 20}}) {
    std::vector<double> places; // a ball of radius 1 on a wire
    std::vector<double> radii;
    for (int i = 1; i < 40 + rings; ++i) {
      places.push_back(i < 40 ? -std::cos(i * CSCD::test::pi / 40) : 1 + 3. * (i - 39) / rings);
      radii.push_back(std::max(i < 40 ? std::sin(i * CSCD::test::pi / 40) : 0, radius));
    }
    Skeleton skeleton;
    EXPECT_EQ(CSCD::extract_curve_skeleton(revolved(places, radii), skeleton).number_of_edges_outside, 0U);
    const auto is_at_end = [&](auto node) { return skeleton[node].point.x() > 3.5; };
    EXPECT_TRUE(std::any_of(vertices(skeleton).first, vertices(skeleton).second, is_at_end)) << radius << ' ' << rings;
  }
}

TEST(Thin_limb, of_four_sides_is_followed_along_all_its_turns)
{
  std::vector<CSCD::test::Triple> places; // a coil whose rings are five times as far apart as it is thick
  for (int i = 0; i < 700; ++i) {
    places.push_back({20 * std::cos(i / 20.), 20 * std::sin(i / 20.), 0.13 * i});
  }
  const CSCD::test::Shape coil =
      CSCD::test::swept_shape("", places, std::vector<double>(700, 0.15), 4, CSCD::test::Tube_end::flat);
  Skeleton skeleton;
  EXPECT_EQ(CSCD::extract_curve_skeleton(CSCD::test::to_mesh<Mesh>(coil), skeleton).number_of_edges_outside, 0U);
  double length = 0;
  for (const auto edge : CGAL::make_range(edges(skeleton))) {
    length += std::sqrt(
        CGAL::squared_distance(skeleton[source(edge, skeleton)].point, skeleton[target(edge, skeleton)].point));
  }
  EXPECT_NEAR(length, 699 * std::hypot(1, 0.13), 5);
}

TEST(Shaft, has_a_straight_axis_and_no_branches_in_its_flange)
{
  for (const auto& [radius, thickness] :
       {std::pair(0.15, 0.4), {0.2, 0.9}, {0.3, 0.1}, {0.3, 0.4}, {0.3, 1.2}, {0.45, 0.1}, {0.45, 0.9}}) {
    std::vector<double> places;
    std::vector<double> radii;
    for (int i = -30; i <= 30; ++i) {
      const double way = std::abs(i * 0.1 - 0.5) - thickness / 2; // out of the flange
      places.push_back(i * 0.1);
      radii.push_back(way < 0.01 ? 1 : way < 0.11 ? (1 + radius) / 2 : radius);
    }
    Skeleton skeleton;
    EXPECT_EQ(CSCD::extract_curve_skeleton(revolved(places, radii), skeleton).number_of_tips, 2U) << thickness;
    for (const auto node : CGAL::make_range(vertices(skeleton))) {
      EXPECT_LT(std::hypot(skeleton[node].point.y(), skeleton[node].point.z()), 0.1) << thickness;
    }
  }
}

TEST(Thin_wall, of_a_cup_leads_no_branch_around_its_hollow)
{
  Skeleton skeleton;
  const auto report = CSCD::extract_curve_skeleton(CSCD::test::to_mesh<Mesh>(CSCD::test::cup(0.07)), skeleton);
  EXPECT_GT(report.number_of_tunnels, 0u);
  EXPECT_LE(report.number_of_tips, 1u);
  EXPECT_EQ(report.number_of_edges_outside, 0u);
  // Removing branches to tips leaves the cycle.
  ASSERT_EQ(report.betti_number, 1u);
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const auto node : CGAL::make_range(vertices(skeleton))) {
      if (out_degree(node, skeleton) == 1) {
        clear_vertex(node, skeleton);
        is_changed = true;
      }
    }
  }
  for (const auto node : CGAL::make_range(vertices(skeleton))) {
    EXPECT_TRUE(out_degree(node, skeleton) == 0 || skeleton[node].point.x() > 0.6) << "in the handle or the wall by it";
  }
}

double total_length(const Skeleton& skeleton)
{
  double sum = 0;
  for (const auto edge : CGAL::make_range(edges(skeleton))) {
    sum += std::sqrt(
        CGAL::squared_distance(skeleton[source(edge, skeleton)].point, skeleton[target(edge, skeleton)].point));
  }
  return sum;
}

TEST(Components, have_the_skeletons_that_each_has_alone)
{
  using namespace CSCD::test;
  // A limb that is a part of its own and ends in the body, as in models of characters; a ball in the hollow of a cup.
  std::vector<std::pair<Shape, Shape>> pairs{{capsule(8, 1, 24), translated(capsule(8, 0.4, 16), {6.5, 0.1, 0.1})}};
  for (const auto& [radius, x, z] :
       {CSCD::test::Triple{0.2, 0, 0.8}, {0.35, 0, 0.8}, {0.35, 0.2, 1.2}, {0.5, 0.2, 1.2}}) {
    pairs.push_back({cup(0.07), translated(scaled(sphere(3), radius), {x, 0, z})});
  }
  for (const auto& [one, other] : pairs) {
    Skeleton skeleton;
    double length = 0;
    std::size_t number_of_tips = 0;
    for (const Shape& shape : {one, other}) {
      number_of_tips += CSCD::extract_curve_skeleton(to_mesh<Mesh>(shape), skeleton).number_of_tips;
      length += total_length(skeleton);
    }
    const auto report = CSCD::extract_curve_skeleton(to_mesh<Mesh>(merged("", {one, other})), skeleton);
    EXPECT_EQ(report.number_of_tips, number_of_tips);
    EXPECT_EQ(report.number_of_edges_outside, 0u);
    EXPECT_NEAR(total_length(skeleton), length, 0.04 * length);
  }
}

TEST(Flat_component, keeps_its_nodes_beside_a_body)
{
  for (const int number_of_faces : {1, 2}) {
    for (const double height : {-0.003, 0.003}) {
      Mesh mesh = body_with_limbs();
      const double z = 1 + height;
      const auto a = mesh.add_vertex({1.2, 0, z});
      const auto b = mesh.add_vertex({1.4, 0, z});
      const auto c = mesh.add_vertex({1.3, 0.2, z});
      mesh.add_face(a, b, c);
      if (number_of_faces == 2) {
        mesh.add_face(a, c, mesh.add_vertex({1.1, 0.2, z}));
      }
      Skeleton skeleton;
      const auto report = CSCD::extract_curve_skeleton(mesh, skeleton);
      EXPECT_EQ(report.number_of_skeleton_components, 2u);
      const auto is_beside = [&](auto node) {
        return CGAL::squared_distance(skeleton[node].point, Point(1.3, 0.1, z)) < 0.3 * 0.3;
      };
      EXPECT_TRUE(std::any_of(vertices(skeleton).first, vertices(skeleton).second, is_beside));
      for (const auto edge : CGAL::make_range(edges(skeleton))) {
        EXPECT_EQ(is_beside(source(edge, skeleton)), is_beside(target(edge, skeleton))) << number_of_faces << height;
      }
    }
  }
}

TEST(Detail, decides_how_small_a_limb_may_be)
{
  const Mesh mesh = body_with_limbs();
  const Mesh ladder = CSCD::test::to_mesh<Mesh>(CSCD::test::ladder(3, 0.15));
  for (const auto& [detail, number_of_tips] :
       {std::pair(0., 2u), std::pair(0.02, 2u), std::pair(0.1, 3u), std::pair(0.5, 4u), std::pair(1., 4u)}) {
    Skeleton skeleton;
    const auto report = CSCD::extract_curve_skeleton(mesh, skeleton, parameters::detail(detail));
    EXPECT_EQ(CSCD::test::violated_invariants(mesh, skeleton, report), Violations{}) << detail;
    EXPECT_EQ(report.betti_number, 0u) << detail;
    EXPECT_EQ(report.number_of_tips, number_of_tips) << detail;
    EXPECT_EQ(CSCD::extract_curve_skeleton(ladder, skeleton, parameters::detail(detail)).betti_number, 3u) << detail;
  }
  Skeleton skeleton;
  EXPECT_THROW(CSCD::extract_curve_skeleton(mesh, skeleton, parameters::detail(1.5)), CSCD::Input_error);
}

TEST(Narrow_fork, has_its_junction_where_the_axes_meet)
{
  // Less than forty degrees apart, the walls of the branches part four radii after their axes.
  std::vector<CSCD::test::Limb> limbs{{{0, -6, 0}, {0, 0, 0}, 1, 1}};
  for (const double angle : {-0.3, 0.3}) {
    limbs.push_back({{0, 0, 0}, {10 * std::sin(angle), 10 * std::cos(angle), 0}, 0.85, 0.85});
  }
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(CSCD::test::to_mesh<Mesh>(CSCD::test::limb_shape("fork", limbs, 0.25)), skeleton);
  for (const auto v : CGAL::make_range(vertices(skeleton))) {
    EXPECT_TRUE(degree(v, skeleton) < 3 || CGAL::squared_distance(skeleton[v].point, Mesh::Point(0, 0, 0)) < 1);
  }
}

} // namespace
