// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortening by edge flips ends in geodesics, and says so where it does not.

#include "Separator/is_closed_curve.h"
#include "Surface/to_indexed_triangles.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::Shortening_outcome;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_loop;
using CSCD::internal::Locality_ball;
using CSCD::internal::Surface_path;
using CSCD::test::pi;
using CSCD::test::Shape;
using CSCD::test::Triple;
using Edge_flip_shortening = CSCD::internal::Edge_flip_shortening<Triangulated_surface>;
using Intrinsic_triangulation = CSCD::internal::Intrinsic_triangulation<Triangulated_surface>;

constexpr auto nothing_is_pinned = [](Index) { return false; };

/// The halfedges between consecutive vertices of `loop`.
std::vector<Index> halfedges(const Triangulated_surface& surface, const Vertex_loop& loop, bool is_closed = true)
{
  std::vector<Index> result;
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < loop.size(); ++i) {
    result.push_back(surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]));
    EXPECT_NE(result.back(), CSCD::no_index);
  }
  return result;
}

double length(const Triangulated_surface& surface, const std::vector<Index>& curve)
{
  double sum = 0;
  for (const Index h : curve) {
    sum += surface.length(h);
  }
  return sum;
}

double angle_between(const Vector_3& u, const Vector_3& v)
{
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The angle on the left of the path at its point `i`, a vertex, measured from face to face in space.
double left_angle(const Triangulated_surface& surface, const Surface_path& path, std::size_t i)
{
  const std::size_t size = path.points.size();
  const Edge_crossing& before = path.points[(i + size - 1) % size];
  const Edge_crossing& after = path.points[(i + 1) % size];
  const Vector_3 center = CSCD::internal::crossing_point(surface, path.points[i]);
  Vector_3 direction = CSCD::internal::crossing_point(surface, before) - center;
  double angle = 0;
  const auto turn_to = [&](const Vector_3& point) {
    angle += angle_between(direction, point - center);
    direction = point - center;
  };
  std::vector<Edge_crossing> incident_edges;
  CSCD::internal::push_off_vertex(surface, before, path.points[i], after, incident_edges);
  for (const Edge_crossing& incident_edge : incident_edges) {
    turn_to(surface.point(surface.target(incident_edge.halfedge)));
  }
  turn_to(CSCD::internal::crossing_point(surface, after));
  return angle;
}

double vertex_angle(const Triangulated_surface& surface, Index vertex)
{
  double sum = 0;
  for (const Index h : surface.outgoing(vertex)) {
    sum += angle_between(surface.point(surface.target(h)) - surface.point(vertex),
                         surface.point(surface.opposite_vertex(h)) - surface.point(vertex));
  }
  return sum;
}

/// Consecutive points share a face, lengths add up, and the path is straight at all vertices that are not pinned.
template <class IsPinned>
void expect_geodesic(const Triangulated_surface& surface, const Surface_path& path, const IsPinned& is_pinned,
                     double tolerance = 1e-5)
{
  std::vector<Vector_3> points;
  CSCD::internal::crossing_points(surface, path.points, points);
  const std::size_t size = points.size();
  double sum = 0;
  for (std::size_t i = 0; i + (path.is_closed ? 0 : 1) < size; ++i) {
    sum += (points[(i + 1) % size] - points[i]).norm();
  }
  ASSERT_NEAR(sum, path.length, 1e-7 * path.length);
  for (std::size_t i = path.is_closed ? 0 : 1; i + (path.is_closed ? 0 : 1) < size; ++i) {
    const Index vertex = surface.origin(path.points[i].halfedge);
    if (CSCD::internal::is_vertex(path.points[i]) && !is_pinned(vertex)) {
      const double left = left_angle(surface, path, i);
      ASSERT_GE(left, pi - tolerance) << "point " << i;
      ASSERT_GE(vertex_angle(surface, vertex) - left, pi - tolerance) << "point " << i;
    }
  }
}

/// Whether two paths have the same points, bit by bit.
bool are_equal(const Surface_path& a, const Surface_path& b)
{
  return a.length == b.length && std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                                            [](const Edge_crossing& p, const Edge_crossing& q) {
                                              return p.halfedge == q.halfedge && p.position == q.position;
                                            });
}

/// The vertices of a ring of a tube, which makes a detour over the next ring at every `period`-th vertex.
Vertex_loop ring_with_detours(Index ring, Index around, Index period)
{
  Vertex_loop loop;
  for (Index k = 0; k < around; ++k) {
    if (k % period == period - 1) {
      loop.push_back((ring + 1) * around + k);
      loop.push_back((ring + 1) * around + (k + 1) % around);
    } else {
      loop.push_back(ring * around + k);
    }
  }
  return loop;
}

double polygon_length(double radius, Index around)
{
  return 2 * double(around) * radius * std::sin(pi / double(around));
}

/// Two cones that meet in a ring of radius `neck`, with `rings` rings on either side.
Shape two_cones(double neck, Index rings, Index around)
{
  const std::vector<Triple> points = CSCD::test::sampled_segment({-2, 0, 0}, {2, 0, 0}, 2 * rings + 1);
  std::vector<double> radii;
  for (const Triple& point : points) {
    radii.push_back(neck + 0.5 * std::fabs(point[0]));
  }
  return CSCD::test::swept_shape("two cones", points, radii, around, CSCD::test::Tube_end::flat);
}

TEST(Edge_flip_shortening, finds_the_neck_of_two_cones)
{
  constexpr Index around = 20;
  constexpr Index rings = 12;
  const Triangulated_surface surface = CSCD::test::to_surface(two_cones(0.6, rings, around));
  Edge_flip_shortening shorten(surface);
  Surface_path path;
  for (const Index ring : {rings - 8, rings - 1, rings, rings + 3, rings + 9}) {
    SCOPED_TRACE(ring);
    const std::vector<Index> loop = halfedges(surface, ring_with_detours(ring, around, 5));
    EXPECT_EQ(shorten(loop, true, path), Shortening_outcome::straight);
    EXPECT_NEAR(path.length, polygon_length(0.6, around), 1e-6);
    expect_geodesic(surface, path, nothing_is_pinned);
  }
}

TEST(Edge_flip_shortening, says_that_a_loop_on_a_sphere_collapses)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(3));
  Edge_flip_shortening shorten(surface);
  Surface_path path;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); vertex += 7) {
    std::vector<Index> loop;
    for (const Index h : surface.outgoing(vertex)) {
      loop.push_back(Triangulated_surface::next(h));
    }
    EXPECT_EQ(shorten(loop, true, path), Shortening_outcome::collapsed);
    EXPECT_TRUE(path.points.empty());
  }
}

/// The loops of the nearest meetings of fronts from every `step`-th vertex.
std::vector<Vertex_loop> loops_of_meetings(const Triangulated_surface& surface, Index step)
{
  const CSCD::Vertex_fan_table corners(surface);
  CSCD::internal::Geodesic_polar_coordinates front(corners, surface.number_of_vertices());
  std::vector<Vertex_loop> loops;
  for (Index source = 0; source < surface.number_of_vertices(); source += step) {
    CSCD::internal::Nearest_meeting meeting(surface, front, source);
    front.grow(source, std::numeric_limits<std::size_t>::max(), meeting);
    if (meeting.has_found()) {
      Vertex_loop loop;
      CSCD::internal::trace_loop(front, meeting.first(), meeting.second(), loop);
      if (loop.size() >= 3) {
        loops.push_back(loop);
      }
    }
  }
  return loops;
}

std::vector<Shape> rough_shapes()
{
  return {CSCD::test::noisy(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat), 0.4, 1),
          CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.3, 2),
          CSCD::test::y_tube(0.15),
          CSCD::test::subdivided_cube(3),
          CSCD::test::anisotropic_tube(10, 1, 60, 6),
          CSCD::test::tube(10, 1, 3, CSCD::test::Tube_end::flat),
          CSCD::test::plate_with_hole(),
          CSCD::test::double_torus(0.2)};
}

TEST(Edge_flip_shortening, ends_in_geodesics_on_rough_surfaces)
{
  for (const Shape& shape : rough_shapes()) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Edge_flip_shortening shorten(surface);
    Surface_path path;
    std::vector<Edge_crossing> crossings;
    std::size_t number_of_geodesics = 0;
    const std::vector<Vertex_loop> loops = loops_of_meetings(surface, 3);
    for (const Vertex_loop& loop : loops) {
      SCOPED_TRACE(loop.front());
      const std::vector<Index> curve = halfedges(surface, loop);
      const Shortening_outcome outcome = shorten(curve, true, path);
      if (outcome == Shortening_outcome::collapsed) {
        continue;
      }
      ASSERT_EQ(outcome, Shortening_outcome::straight);
      ++number_of_geodesics;
      ASSERT_LE(path.length, length(surface, curve) * (1 + 1e-12));
      expect_geodesic(surface, path, nothing_is_pinned);
      ASSERT_TRUE(CSCD::internal::push_off_vertices(surface, path, crossings));
      ASSERT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
    }
    EXPECT_TRUE(number_of_geodesics > loops.size() / 4 || shape.name == "tube" || loops.empty());
  }
}

/// The border of a disc of about `size` faces around `seed`, if it is a simple closed curve; else nothing.
template <class Triangulation>
std::vector<Index> disc_border(const Triangulation& surface, Index seed, std::size_t size)
{
  std::vector<char> is_inside(surface.number_of_faces(), 0);
  std::vector<Index> faces{seed};
  is_inside[seed] = 1;
  for (std::size_t i = 0; i < faces.size() && faces.size() < size; ++i) {
    for (Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
      const Index neighbor = Triangulated_surface::face(surface.twin(h));
      if (!is_inside[neighbor]) {
        is_inside[neighbor] = 1;
        faces.push_back(neighbor);
      }
    }
  }
  std::vector<Index> from(surface.number_of_vertices(), CSCD::no_index);
  std::size_t number = 0;
  Index first = CSCD::no_index;
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    if (is_inside[Triangulated_surface::face(h)] && !is_inside[Triangulated_surface::face(surface.twin(h))]) {
      if (from[surface.origin(h)] != CSCD::no_index) {
        return {};
      }
      from[surface.origin(h)] = h;
      first = h;
      ++number;
    }
  }
  std::vector<Index> border;
  Index h = first;
  do {
    border.push_back(h);
    h = from[surface.target(h)];
  } while (h != first);
  return border.size() == number ? border : std::vector<Index>();
}

TEST(Edge_flip_shortening, shrinks_borders_of_discs_to_points_or_to_geodesics)
{
  for (const Shape& shape : rough_shapes()) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Edge_flip_shortening shorten(surface);
    Surface_path path;
    std::size_t number_of_discs = 0;
    std::size_t number_of_collapsed = 0;
    for (Index seed = 0; seed < surface.number_of_faces(); seed += std::max<Index>(1, surface.number_of_faces() / 60)) {
      for (const std::size_t size : {3u, 20u, surface.number_of_faces() / 5, surface.number_of_faces() / 3}) {
        const std::vector<Index> border = disc_border(surface, seed, size);
        if (border.empty()) {
          continue;
        }
        SCOPED_TRACE(seed);
        ++number_of_discs;
        const Shortening_outcome outcome = shorten(border, true, path);
        if (outcome == Shortening_outcome::collapsed) {
          ++number_of_collapsed;
          continue;
        }
        ASSERT_EQ(outcome, Shortening_outcome::straight);
        ASSERT_LE(path.length, length(surface, border) * (1 + 1e-12));
        expect_geodesic(surface, path, nothing_is_pinned);
      }
    }
    EXPECT_GT(number_of_discs, 0u);
  }
}

TEST(Edge_flip_shortening, shortens_curves_along_the_edges_of_an_intrinsic_triangulation)
{
  for (const Shape& shape : {CSCD::test::noisy(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat), 0.4, 1),
                             CSCD::test::y_tube(0.15), CSCD::test::noisy(CSCD::test::y_tube(0.15), 0.2, 2)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Intrinsic_triangulation triangulation(surface);
    Edge_flip_shortening shorten_on_surface(surface);
    Surface_path path;
    Surface_path path_on_surface;
    std::size_t number_of_geodesics = 0;
    for (const bool is_delaunay : {false, true}) {
      if (is_delaunay) {
        ASSERT_GT(triangulation.make_delaunay(), 0u);
      }
      Edge_flip_shortening shorten(triangulation);
      for (Index seed = 0; seed < surface.number_of_faces(); seed += surface.number_of_faces() / 100) {
        const std::vector<Index> border = disc_border(triangulation, seed, surface.number_of_faces() / 3);
        if (border.empty()) {
          continue;
        }
        SCOPED_TRACE(seed);
        const Shortening_outcome outcome = shorten(border, true, path);
        if (!is_delaunay) {
          ASSERT_EQ(shorten_on_surface(border, true, path_on_surface), outcome);
          ASSERT_TRUE(are_equal(path, path_on_surface));
        } else if (outcome != Shortening_outcome::collapsed) {
          ++number_of_geodesics;
          ASSERT_EQ(outcome, Shortening_outcome::straight);
          expect_geodesic(surface, path, nothing_is_pinned);
        }
      }
    }
    EXPECT_GT(number_of_geodesics, 0u);
  }
}

TEST(Edge_flip_shortening, takes_nothing_off_pinned_vertices)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::y_tube(0.15));
  Edge_flip_shortening shorten(surface);
  Surface_path free_path;
  Surface_path path;
  std::size_t number_of_held = 0;
  for (const Vertex_loop& loop : loops_of_meetings(surface, 11)) {
    const std::vector<Index> curve = halfedges(surface, loop);
    // All vertices pinned: nothing moves.
    EXPECT_NE(shorten(
                  curve, true, [](Index) { return true; }, path),
              Shortening_outcome::collapsed);
    EXPECT_NEAR(path.length, length(surface, curve), 1e-12);
    EXPECT_EQ(path.points.size(), curve.size());
    const Locality_ball ball(surface, surface.points(), surface.point(loop.front()), curve);
    const Shortening_outcome outcome = shorten(curve, true, ball, path);
    const Shortening_outcome free_outcome = shorten(curve, true, free_path);
    ASSERT_NE(outcome, Shortening_outcome::unfinished);
    if (outcome == Shortening_outcome::held) {
      ++number_of_held;
      EXPECT_GE(path.length, free_path.length * (1 - 1e-9));
    } else {
      EXPECT_EQ(outcome, free_outcome);
    }
    expect_geodesic(surface, path, ball);
    // It may go out of the ball by the length of an edge, where it is pinned.
    for (const Edge_crossing& point : path.points) {
      if (CSCD::internal::is_vertex(point) && ball(surface.origin(point.halfedge))) {
        EXPECT_EQ(outcome, Shortening_outcome::held);
      }
    }
  }
  EXPECT_GT(number_of_held, 0u);
}

TEST(Edge_flip_shortening, takes_out_what_goes_straight_back)
{
  constexpr Index around = 16;
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(8, 1, around, CSCD::test::Tube_end::flat));
  Edge_flip_shortening shorten(surface);
  Surface_path path;
  Vertex_loop loop;
  for (Index k = 0; k < around; ++k) {
    loop.push_back(5 * around + k);
  }
  for (const Index ring : {6u, 7u, 8u, 7u, 6u, 5u}) {
    loop.push_back(ring * around + around - 1);
  }
  EXPECT_EQ(shorten(halfedges(surface, loop), true, path), Shortening_outcome::straight);
  EXPECT_NEAR(path.length, polygon_length(1, around), 1e-9);
  // Nothing but there and back, closed, and open with both ends in one vertex.
  const std::vector<Index> spike = halfedges(surface, {80, 96, 112, 96}, true);
  EXPECT_EQ(shorten(spike, true, path), Shortening_outcome::collapsed);
  EXPECT_EQ(shorten(
                spike, true, [](Index) { return true; }, path),
            Shortening_outcome::collapsed);
  EXPECT_EQ(shorten(spike, false, path), Shortening_outcome::collapsed);
  EXPECT_EQ(shorten(std::vector<Index>(), true, path), Shortening_outcome::collapsed);
}

TEST(Edge_flip_shortening, does_not_pass_over_other_parts_of_the_curve)
{
  // From below to a vertex, up, to the left, down, and back to the vertex, where it ends within the angle.
  constexpr Index around = 16;
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(8, 1, around, CSCD::test::Tube_end::flat));
  const auto vertex_at = [](Index ring, Index k) { return ring * around + k; };
  const Index middle = vertex_at(6, 4);
  const std::vector<Index> curve = halfedges(
      surface, {vertex_at(4, 2), vertex_at(5, 3), middle, vertex_at(7, 4), vertex_at(7, 3), vertex_at(6, 3), middle},
      false);
  Edge_flip_shortening shorten(surface);
  Surface_path path;
  EXPECT_EQ(shorten(
                curve, false, [&](Index vertex) { return vertex != middle; }, path),
            Shortening_outcome::unfinished);
  EXPECT_NEAR(path.length, length(surface, curve), 1e-12);
  EXPECT_EQ(path.points.size(), curve.size() + 1);
  // Once the loop at its end has shrunk, nothing is in the way.
  EXPECT_EQ(shorten(curve, false, path), Shortening_outcome::straight);
  EXPECT_NEAR(path.length, 2 * surface.length(curve.front()), 1e-9);
}

TEST(Edge_flip_shortening, gives_the_same_on_several_threads_and_with_used_objects)
{
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat), 0.4, 1));
  std::vector<std::vector<Index>> curves;
  for (const Vertex_loop& loop : loops_of_meetings(surface, 5)) {
    curves.push_back(halfedges(surface, loop));
  }
  std::vector<Surface_path> paths(curves.size());
  using Worker = std::unique_ptr<Edge_flip_shortening>;
  CSCD::internal::For_each_index<Worker> for_each(
      [&surface] { return std::make_unique<Edge_flip_shortening>(surface); }, 0);
  for_each(Index(curves.size()), [&](Index i, Worker& shorten) { (*shorten)(curves[i], true, paths[i]); });
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Edge_flip_shortening shorten(surface);
    Surface_path path;
    shorten(curves[i], true, path);
    ASSERT_TRUE(are_equal(path, paths[i])) << "curve " << i;
  }
}

TEST(Edge_flip_shortening, goes_along_borders)
{
  // A square with a square hole, between the middles of two opposite sides: along two corners of the hole.
  Shape shape;
  constexpr std::size_t n = 12;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      shape.points.push_back({double(i), double(j), 0});
    }
  }
  std::vector<bool> is_removed;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t v = i * (n + 1) + j;
      shape.triangles.push_back({v, v + n + 1, v + n + 2});
      shape.triangles.push_back({v, v + n + 2, v + 1});
      is_removed.resize(shape.triangles.size(), i >= 4 && i < 8 && j >= 4 && j < 8);
    }
  }
  // The vertices within the hole go: numbers are found by place.
  CSCD::test::remove_triangles(shape, is_removed);
  auto triangles = CSCD::test::to_indexed_triangles(shape);
  const auto pairing = CSCD::check_manifold(triangles, [](Index vertex) { return vertex; });
  ASSERT_EQ(CSCD::internal::bridge_borders(triangles, pairing), 2u);
  const Triangulated_surface surface(std::move(triangles));
  const auto vertex_at = [&](double x, double y) { return CSCD::test::nearest_vertex(surface, Vector_3(x, y, 0)); };
  Vertex_loop curve;
  for (int y = 6; y <= 10; ++y) {
    curve.push_back(vertex_at(0, y));
  }
  for (int x = 1; x <= 12; ++x) {
    curve.push_back(vertex_at(x, 10));
  }
  for (int y = 9; y >= 6; --y) {
    curve.push_back(vertex_at(12, y));
  }
  const std::vector<Index> edges = halfedges(surface, curve, false);
  Surface_path path;
  Edge_flip_shortening shorten(surface, surface.first_hole_filling_face());
  EXPECT_EQ(shorten(edges, false, path), Shortening_outcome::straight);
  EXPECT_NEAR(path.length, 4 + 2 * std::hypot(4., 2.), 1e-9);
  // Around the hole it stays; over the bridges, it shrinks to the other side of the sheet.
  Vertex_loop loop;
  for (int k = 3; k < 9; ++k) {
    loop.push_back(vertex_at(k, 3));
  }
  for (int k = 3; k < 9; ++k) {
    loop.push_back(vertex_at(9, k));
  }
  for (int k = 9; k > 3; --k) {
    loop.push_back(vertex_at(k, 9));
  }
  for (int k = 9; k > 3; --k) {
    loop.push_back(vertex_at(3, k));
  }
  EXPECT_EQ(shorten(halfedges(surface, loop), true, path), Shortening_outcome::straight);
  EXPECT_NEAR(path.length, 16, 1e-9);
  Edge_flip_shortening shorten_over_bridges(surface);
  EXPECT_EQ(shorten_over_bridges(halfedges(surface, loop), true, path), Shortening_outcome::collapsed);
}

} // namespace
