// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Degenerate and hostile meshes: each gives a skeleton with all invariants, or an Input_error that names the element.

#include "support/Inside_count.h"
#include "support/expect_skeleton.h"
#include "support/invariants.h"
#include "support/message_of.h"
#include "support/shapes.h"
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/skeletonize.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::test::Shape, CSCD::test::Triple, CSCD::test::Violations;
// Of std::array, which argument-dependent look-up does not find.
using CSCD::test::operator+;
using CSCD::test::operator-;
using CSCD::test::operator*;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Expects a skeleton with all invariants; returns the report.
CSCD::Skeletonization_report expect_skeleton(const Mesh& mesh, std::size_t number_of_cavities = 0)
{
  Skeleton skeleton;
  const CSCD::Skeletonization_report report =
      CSCD::test::expect_skeleton(mesh, skeleton, CSCD::parameters::default_values(), number_of_cavities);
  EXPECT_GT(num_vertices(skeleton), 0u);
  return report;
}

CSCD::Skeletonization_report expect_skeleton(const Shape& shape, std::size_t number_of_cavities = 0)
{
  return expect_skeleton(CSCD::test::to_mesh<Mesh>(shape), number_of_cavities);
}

/// Expects an Input_error with all of `words` in its message, and the output as it was.
void expect_refused(const Mesh& mesh, const std::vector<std::string>& words)
{
  Skeleton skeleton = CSCD::test::marked_skeleton<Skeleton>();
  const std::string message = CSCD::test::message_of([&] { CSCD::extract_curve_skeleton(mesh, skeleton); });
  for (const std::string& word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << message;
  }
  CSCD::test::expect_is_marked(skeleton);
}

void expect_refused(const Shape& shape, const std::vector<std::string>& words)
{
  expect_refused(CSCD::test::to_mesh<Mesh>(shape), words);
}

/// Expects either. \return whether there is a skeleton
bool expect_skeleton_or_refused(const Shape& shape)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  Skeleton skeleton;
  try {
    const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(mesh, skeleton);
    EXPECT_EQ(CSCD::test::violated_invariants_without_area(mesh, skeleton, report), Violations{});
    return true;
  } catch (const CSCD::Input_error& error) {
    EXPECT_FALSE(std::string(error.what()).empty());
  }
  return false;
}

Shape triangles(const std::vector<Triple>& points, const std::vector<CSCD::test::Triangle>& faces)
{
  Shape shape;
  shape.points = points;
  shape.triangles = faces;
  return shape;
}

//
// Too little
//

TEST(Degenerate_input, empty_mesh)
{
  expect_refused(Mesh(), {"no faces"});
}

TEST(Degenerate_input, isolated_vertices_only)
{
  Mesh mesh;
  for (int i = 0; i < 10; ++i) {
    mesh.add_vertex(Point(i, i * i, 0));
  }
  expect_refused(mesh, {"no faces"});
}

TEST(Degenerate_input, isolated_vertices_beside_a_surface)
{
  Mesh mesh;
  mesh.add_vertex(Point(100, 0, 0));
  mesh += CSCD::test::to_mesh<Mesh>(CSCD::test::capsule(8, 1, 16));
  // Not even its coordinates matter.
  mesh.add_vertex(Point(not_a_number, 0, 0));
  EXPECT_EQ(expect_skeleton(mesh).number_of_isolated_vertices, 2u);
}

TEST(Degenerate_input, one_or_two_triangles)
{
  expect_skeleton(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  expect_skeleton(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}));
}

TEST(Degenerate_input, one_triangle_seen_from_both_sides)
{
  const Mesh pillow = CSCD::test::to_mesh<Mesh>(triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}));
  expect_skeleton(pillow);
}

TEST(Degenerate_input, removed_elements_that_are_not_collected)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::capsule(8, 1, 16));
  mesh += CSCD::test::to_mesh<Mesh>(CSCD::test::translated(CSCD::test::cube(), {20, 0, 0}));
  const Mesh::Vertex_index first_of_cube(static_cast<Mesh::size_type>(mesh.number_of_vertices() - 8));
  CGAL::Polygon_mesh_processing::keep_largest_connected_components(mesh, 1);
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_TRUE(mesh.is_removed(first_of_cube));
  EXPECT_EQ(expect_skeleton(mesh).number_of_surface_components, 1u);
}

//
// Bad coordinates
//

TEST(Degenerate_input, coordinates_that_are_not_finite)
{
  for (const double bad : {not_a_number, infinity, -infinity}) {
    SCOPED_TRACE(bad);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Shape shape = CSCD::test::capsule(8, 1, 16);
      shape.points[17][axis] = bad;
      expect_refused(shape, {"vertex 17", "finite"});
    }
  }
}

TEST(Degenerate_input, all_points_equal)
{
  Shape shape = CSCD::test::sphere(1);
  for (Triple& p : shape.points) {
    p = {3, 4, 5};
  }
  expect_refused(shape, {"same point"});
}

TEST(Degenerate_input, all_points_on_a_line)
{
  Shape shape = CSCD::test::sphere(2);
  for (Triple& p : shape.points) {
    p = {p[0], 2 * p[0], -p[0]};
  }
  expect_skeleton_or_refused(shape);
}

TEST(Degenerate_input, all_points_in_a_plane)
{
  Shape shape = CSCD::test::capsule(8, 1, 24);
  for (Triple& p : shape.points) {
    p[2] = 0;
  }
  expect_skeleton_or_refused(shape);
}

TEST(Degenerate_input, one_component_of_several_is_a_point)
{
  Shape dot = CSCD::test::sphere(1);
  for (Triple& p : dot.points) {
    p = {20, 0, 0};
  }
  expect_skeleton_or_refused(CSCD::test::merged("", {CSCD::test::capsule(8, 1, 24), dot}));
}

TEST(Degenerate_input, faces_without_area)
{
  Shape shape = CSCD::test::capsule(8, 1, 24);
  // Needles: two neighbours on a ring coincide.
  for (std::size_t v = 48; v < 240; v += 24) {
    shape.points[v + 1] = shape.points[v];
  }
  const CSCD::Skeletonization_report report = expect_skeleton(shape);
  EXPECT_GT(report.number_of_degenerate_faces, 0u);
}

TEST(Degenerate_input, faces_almost_without_area)
{
  Shape shape = CSCD::test::y_tube(0.2);
  for (std::size_t t = 0; t < shape.triangles.size(); t += 7) {
    const CSCD::test::Triangle& triangle = shape.triangles[t];
    shape.points[triangle[0]] =
        shape.points[triangle[1]] + 1e-12 * (shape.points[triangle[0]] - shape.points[triangle[1]]);
  }
  expect_skeleton(shape);
}

TEST(Degenerate_input, many_points_in_one_place)
{
  Shape shape = CSCD::test::y_tube(0.2);
  const std::size_t n = shape.points.size();
  for (std::size_t v = 0; v < n / 3; ++v) {
    shape.points[v] = shape.points[0];
  }
  expect_skeleton(shape);
}

TEST(Degenerate_input, coordinates_on_a_coarse_grid)
{
  Shape shape = CSCD::test::y_tube(0.1);
  for (Triple& p : shape.points) {
    for (double& coordinate : p) {
      coordinate = std::round(coordinate / 0.2) * 0.2;
    }
  }
  expect_skeleton(shape);
}

TEST(Degenerate_input, huge_and_tiny_coordinates)
{
  for (const double scale : {1e-200, 1e-30, 1e30, 1e200}) {
    SCOPED_TRACE(scale);
    expect_skeleton(CSCD::test::scaled(CSCD::test::y_tube(0.2), scale));
  }
  expect_refused(CSCD::test::scaled(CSCD::test::y_tube(0.2), 1e300), {"extent", "scale"});
  expect_refused(CSCD::test::scaled(CSCD::test::y_tube(0.2), 1e-300), {"extent", "scale"});
}

TEST(Degenerate_input, coordinates_of_a_map)
{
  const CSCD::Skeletonization_report report =
      expect_skeleton(CSCD::test::translated(CSCD::test::y_tube(0.15), {4.5e5, 5.4e6, 300}));
  EXPECT_EQ(report.number_of_tips, 3u);
}

TEST(Degenerate_input, coordinates_of_which_few_digits_remain)
{
  // The body is a millionth of a millionth of its distance from the origin.
  expect_skeleton_or_refused(CSCD::test::translated(CSCD::test::y_tube(0.15), {1e12, 1e12, 1e12}));
  expect_skeleton_or_refused(CSCD::test::translated(CSCD::test::y_tube(0.15), {1e15, 1e15, 1e15}));
}

//
// Bad topology
//

TEST(Degenerate_input, face_with_four_sides)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const Triple& p : CSCD::test::cube().points) {
    v.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
  }
  mesh.add_face(v[0], v[2], v[3]);
  mesh.add_face(v[0], v[3], v[1]);
  mesh.add_face(v[4], v[5], v[7], v[6]);
  expect_refused(mesh, {"face 2", "4 sides", "triangulate"});
}

TEST(Degenerate_input, pinched_vertex_of_an_open_surface)
{
  Mesh bow_tie;
  std::vector<Mesh::Vertex_index> v;
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(-1, 0, 0), Point(-1, -1, 0)}) {
    v.push_back(bow_tie.add_vertex(p));
  }
  bow_tie.add_face(v[0], v[1], v[2]);
  bow_tie.add_face(v[0], v[3], v[4]);
  expect_refused(bow_tie, {"vertex 0", "pinched", "duplicate"});
}

TEST(Degenerate_input, pinched_vertex_of_a_closed_surface)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::tetrahedron());
  mesh += CSCD::test::to_mesh<Mesh>(CSCD::test::translated(CSCD::test::tetrahedron(), {2, 2, 2}));
  const Mesh::Vertex_index kept(0);
  const Mesh::Vertex_index dropped(7);
  for (const Mesh::Halfedge_index h : halfedges_around_target(halfedge(dropped, mesh), mesh)) {
    set_target(h, kept, mesh);
  }
  mesh.set_halfedge(dropped, Mesh::null_halfedge());
  expect_refused(mesh, {"vertex 0", "pinched"});
}

TEST(Degenerate_input, edges_of_triangles_that_are_not_a_surface)
{
  const std::vector<CSCD::Vector3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  const auto refusal = [&points](const std::vector<std::array<CSCD::Index, 3>>& faces) {
    CSCD::Skeleton skeleton;
    return CSCD::test::message_of([&] { CSCD::skeletonize(points, faces, CSCD::Options(), skeleton); });
  };
  EXPECT_NE(refusal({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}).find(" has 3 faces, a surface has at most two"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 1, 2}, {0, 1, 3}}).find(" has two faces of opposite orientation"), std::string::npos);
}

TEST(Degenerate_input, inside_out)
{
  const CSCD::Skeletonization_report turned = expect_skeleton(CSCD::test::reversed(CSCD::test::y_tube(0.15)));
  EXPECT_EQ(turned.number_of_tips, 3u);
  EXPECT_EQ(turned.number_of_junctions, 1u);
  EXPECT_EQ(turned.number_of_nodes_outside, 0u);
}

TEST(Degenerate_input, components_of_either_orientation)
{
  const Shape shape = CSCD::test::merged(
      "", {CSCD::test::y_tube(0.2), CSCD::test::reversed(CSCD::test::translated(CSCD::test::y_tube(0.2), {10, 0, 0}))});
  const CSCD::Skeletonization_report report = expect_skeleton(shape);
  EXPECT_EQ(report.number_of_tips, 6u);
  EXPECT_EQ(report.number_of_nodes_outside, 0u);
}

TEST(Degenerate_input, surface_within_a_surface)
{
  const CSCD::Skeletonization_report report = expect_skeleton(CSCD::test::hollow_sphere(3), 1);
  EXPECT_EQ(report.number_of_cavities, 1u);
  EXPECT_EQ(report.number_of_skeleton_components, 1u);
  EXPECT_EQ(report.number_of_nodes_outside, 0u);
}

TEST(Degenerate_input, thin_wall_around_a_void)
{
  const Shape outer = CSCD::test::y_tube(0.2);
  const Shape inner = CSCD::test::reversed(CSCD::test::star(3, 3, 0.3, 0.1));
  const CSCD::Skeletonization_report report = expect_skeleton(CSCD::test::merged("", {inner, outer}), 1);
  EXPECT_EQ(report.number_of_cavities, 1u);
  EXPECT_EQ(report.number_of_tips, 3u);
  EXPECT_EQ(report.number_of_nodes, expect_skeleton(outer).number_of_nodes);
  EXPECT_FALSE(report.warnings.empty());
}

TEST(Degenerate_input, components_of_very_different_size)
{
  const Shape shape =
      CSCD::test::merged("", {CSCD::test::capsule(8, 1, 24),
                              CSCD::test::translated(CSCD::test::scaled(CSCD::test::y_tube(0.2), 1e-6), {20, 0, 0})});
  EXPECT_EQ(expect_skeleton(shape).number_of_surface_components, 2u);
}

TEST(Degenerate_input, border_that_is_almost_everything)
{
  // Every other face of a body is missing, wherever that leaves no pinched vertex.
  expect_skeleton(CSCD::test::with_small_holes(CSCD::test::y_tube(0.15), 100000, 1));
  expect_skeleton(CSCD::test::with_small_holes(CSCD::test::torus(3, 1, 24), 100000, 2));
}

//
// Bad geometry
//

TEST(Degenerate_input, needle)
{
  const CSCD::Skeletonization_report report =
      expect_skeleton(CSCD::test::swept_shape("needle", CSCD::test::sampled_segment({0, 0, 0}, {1000, 0, 0}, 1000),
                                              std::vector<double>(1000, 0.05), 8, CSCD::test::Tube_end::flat));
  EXPECT_EQ(report.number_of_tips, 2u);
  expect_skeleton(CSCD::test::box("needle", {1e6, 1, 1}));
  expect_skeleton(CSCD::test::box("plate", {1e4, 1e4, 1}));
  expect_skeleton(CSCD::test::box("foil", {1, 1, 1e-9}));
}

TEST(Degenerate_input, prisms_over_stars_and_combs_hold_their_skeletons)
{
  for (const std::size_t arms : {40U, 400U}) {
    std::vector<Triple> polygon; // a tip, a valley, and so on
    std::vector<CSCD::test::Triangle> fill;
    for (std::size_t i = 0; i < 2 * arms; ++i) {
      const double angle = CGAL_PI * double(i) / double(arms);
      const double radius = i % 2 == 0 ? 5 : 1;
      polygon.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
      if (i % 2 == 0) {
        fill.push_back({i, i + 1, (i + 2 * arms - 1) % (2 * arms)});
      } else if (i > 1 && i + 2 < 2 * arms) {
        fill.push_back({1, i, i + 2}); // slivers
      }
    }
    EXPECT_EQ(expect_skeleton(CSCD::test::prism("star", polygon, fill)).number_of_edges_outside, 0u) << arms;
  }
  EXPECT_EQ(expect_skeleton(CSCD::test::comb(30, false)).number_of_edges_outside, 0u);
}

TEST(Degenerate_input, each_tooth_of_a_comb_is_a_branch)
{
  for (const std::size_t teeth : {30U, 100U}) {
    SCOPED_TRACE(teeth);
    for (const bool has_bar : {false, true}) {
      const CSCD::Skeletonization_report report = expect_skeleton(CSCD::test::comb(teeth, has_bar));
      EXPECT_GE(report.number_of_tips, teeth);
      EXPECT_LE(report.number_of_tips, teeth + 3); // those of the back, too
    }
  }
}

TEST(Degenerate_input, fragments_are_not_refined)
{
  std::vector<Shape> parts;
  for (std::size_t i = 0; i < 4000; ++i) {
    parts.push_back(CSCD::test::translated(CSCD::test::tetrahedron(), {5.0 * static_cast<double>(i), 0, 0}));
  }
  const CSCD::Skeletonization_report report = expect_skeleton(CSCD::test::merged("fragments", parts));
  EXPECT_EQ(report.number_of_surface_components, 4000u);
  EXPECT_EQ(report.number_of_inserted_vertices, 0u);
}

TEST(Degenerate_input, fragments_without_thickness_have_no_inside)
{
  std::vector<Shape> parts{CSCD::test::scaled(CSCD::test::subdivided_cube(4), 10)};
  const Shape fragment = triangles({{0, 0, 0}, {0.5, 0, 0.1}, {0, 0.1, 0.2}}, {{0, 1, 2}});
  constexpr std::size_t number = 50;
  for (std::size_t i = 0; i < number; ++i) {
    const auto place = static_cast<double>(i);
    parts.push_back(CSCD::test::translated(fragment, {1 + 0.15 * place, 3 + 0.07 * place, 5 + 0.01 * place}));
  }
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::merged("fragments", parts));
  Skeleton skeleton;
  EXPECT_EQ(CSCD::test::expect_skeleton(mesh, skeleton).number_of_nodes_outside, number);
  const auto nodes = vertices(skeleton);
  EXPECT_EQ(std::count_if(nodes.first, nodes.second, [&](auto node) { return degree(node, skeleton) == 0; }),
            std::ptrdiff_t(number));
}

/// Cubes of side `width` at the points of a lattice of n x n x n; struts of eight faces join neighbors.
Shape wire_lattice(std::size_t n, double width)
{
  Shape shape;
  const auto vertex = [n](const std::array<std::size_t, 3>& cell, std::size_t corner) {
    return ((cell[0] * n + cell[1]) * n + cell[2]) * 8 + corner;
  };
  const auto add_quad = [&shape](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    shape.triangles.push_back({a, b, c});
    shape.triangles.push_back({a, c, d});
  };
  for (std::size_t number = 0; number < n * n * n; ++number) {
    const std::array<std::size_t, 3> cell{number / n / n, number / n % n, number % n};
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Triple point{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] = double(cell[axis]) + width * (double(corner >> axis & 1) - 0.5);
      }
      shape.points.push_back(point);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t along = std::size_t(1) << axis;
      const std::size_t u = std::size_t(1) << (axis + 1) % 3;
      const std::size_t v = std::size_t(1) << (axis + 2) % 3;
      const std::array<std::size_t, 4> ring{0, u, u + v, v};
      std::array<std::size_t, 3> next = cell;
      ++next[axis];
      for (std::size_t i = 0; next[axis] < n && i < 4; ++i) {
        const std::size_t a = ring[i];
        const std::size_t b = ring[(i + 1) % 4];
        add_quad(vertex(cell, a + along), vertex(cell, b + along), vertex(next, b), vertex(next, a));
      }
      if (next[axis] == n) {
        add_quad(vertex(cell, along), vertex(cell, u + along), vertex(cell, u + v + along), vertex(cell, v + along));
      }
      if (cell[axis] == 0) {
        add_quad(vertex(cell, v), vertex(cell, u + v), vertex(cell, u), vertex(cell, 0));
      }
    }
  }
  return shape;
}

TEST(Degenerate_input, handles_by_the_hundred)
{
  const CSCD::Skeletonization_report report = expect_skeleton(wire_lattice(5, 0.3));
  EXPECT_EQ(report.genus, 176u); // 300 struts, 125 cubes
  EXPECT_EQ(report.betti_number, 176u);
  EXPECT_EQ(report.number_of_junctions, 125u);
  EXPECT_EQ(report.number_of_edges_outside, 0u);
}

TEST(Degenerate_input, surface_that_cuts_itself)
{
  // The limbs of a star folded through each other.
  Shape shape = CSCD::test::star(5, 3, 0.35, 0.12);
  for (Triple& p : shape.points) {
    p[1] = std::fabs(p[1]);
  }
  expect_skeleton(shape);
  shape = CSCD::test::torus(1, 2, 24); // a spindle torus
  expect_skeleton(shape);
}

TEST(Degenerate_input, two_bodies_in_the_same_place)
{
  const Shape shape = CSCD::test::y_tube(0.2);
  expect_skeleton(CSCD::test::merged("", {shape, shape}));
}

TEST(Degenerate_input, noise_as_large_as_the_edges)
{
  for (const double amplitude : {0.5, 1.0, 3.0}) {
    SCOPED_TRACE(amplitude);
    expect_skeleton(CSCD::test::noisy(CSCD::test::y_tube(0.15), amplitude, 1));
  }
}

TEST(Degenerate_input, points_anywhere)
{
  for (std::size_t seed = 1; seed <= 3; ++seed) {
    expect_skeleton(CSCD::test::noisy(CSCD::test::torus(3, 1, 8), 100, seed));
  }
}

TEST(Degenerate_input, triangles_of_very_different_size)
{
  // One corner subdivided again and again.
  Shape shape = CSCD::test::tetrahedron();
  for (int i = 0; i < 40; ++i) {
    const CSCD::test::Triangle t = shape.triangles.back();
    const std::size_t centre = shape.points.size();
    shape.points.push_back(0.98 * shape.points[t[0]] + 0.01 * shape.points[t[1]] + 0.01 * shape.points[t[2]]);
    shape.triangles.back() = {t[1], t[2], centre};
    shape.triangles.insert(shape.triangles.end(), {{t[2], t[0], centre}, {t[0], t[1], centre}});
  }
  EXPECT_TRUE(expect_skeleton_or_refused(shape)); // CGAL tells no inside from faces without area
}

TEST(Degenerate_input, vertices_with_very_many_faces)
{
  expect_skeleton(CSCD::test::double_cone(200));
  expect_skeleton(CSCD::test::double_cone(10000));
}

} // namespace
