// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of the heat method where the exact ones are known, how they change with the input, and far beyond the range
// of numbers.

#include "Published/Length_triangulation.h"
#include "Surface/to_bridged_surface.h"
#include "Surface/to_surface.h"
#include "support/Similarity.h"
#include "support/shapes.h"
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <thread>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Face_layout;
using CSCD::internal::Geodesic_source;
using CSCD::internal::Heat_method;
using CSCD::test::pi;
// Of std::array, which argument-dependent look-up does not find.
using CSCD::test::operator+;
using CSCD::test::operator*;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> distances_from(const Heat_method& method, const std::vector<Geodesic_source>& sources)
{
  Heat_method::Workspace workspace;
  std::vector<double> distances;
  method(sources, distances, workspace);
  return distances;
}

std::vector<double> distances_from(const Heat_method& method, Index source)
{
  return distances_from(method, std::vector{Geodesic_source::at_vertex(source)});
}

/// The largest difference of two lists, relative to the largest finite number of the first; both must be infinite at
/// the same places.
double max_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  EXPECT_EQ(a.size(), b.size());
  double difference = 0;
  double scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isfinite(a[i])) {
      difference = std::max(difference, std::fabs(a[i] - b[i]));
      scale = std::max(scale, std::fabs(a[i]));
    } else {
      EXPECT_EQ(a[i], b[i]);
    }
  }
  return difference / scale;
}

/// The largest error in mean edge lengths, over the vertices for which `exact(vertex)` is not negative.
template <class Exact>
double max_error_in_edges(const Heat_method& method, const std::vector<double>& distances, const Exact& exact)
{
  double largest = 0;
  for (Index vertex = 0; vertex < distances.size(); ++vertex) {
    if (exact(vertex) >= 0) {
      largest = std::max(largest, std::fabs(distances[vertex] - exact(vertex)));
    }
  }
  return largest / method.elements().unit(0);
}

double distance_on_sphere(const Vector_3& a, const Vector_3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(Heat_method, is_exact_on_a_plane_to_part_of_an_edge)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::subdivided_cube(5));
  const Vector_3 center(0.5, 0.5, 1);
  const Heat_method method(surface);
  const double error = max_error_in_edges(method, distances_from(method, CSCD::test::nearest_vertex(surface, center)),
                                          [&](Index vertex) {
                                            const Vector_3 offset = surface.point(vertex) - center;
                                            return offset.z() == 0 && offset.norm() < 0.5 ? offset.norm() : -1.;
                                          });
  EXPECT_LT(error, 0.6);
}

TEST(Heat_method, is_as_exact_on_thin_triangles_once_they_are_delaunay)
{
  // A sheared plane: straight lines in it are shortest.
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::moved(CSCD::test::subdivided_cube(5), [](const CSCD::test::Triple& p) {
        return CSCD::test::Triple{p[0] + 2.3 * p[1], p[1], p[2]};
      }));
  CSCD::internal::Intrinsic_triangulation<Triangulated_surface> delaunay(surface);
  EXPECT_GT(delaunay.make_delaunay(), 1000u);
  const Index source = CSCD::test::nearest_vertex(surface, {0.5 + 2.3 * 0.5, 0.5, 1});
  const auto exact = [&](Index vertex) {
    const Vector_3& p = surface.point(vertex);
    const bool is_well_inside =
        p.z() == 1 && std::fabs(p.y() - 0.5) < 0.3 && std::fabs(p.x() - 2.3 * p.y() - 0.5) < 0.3;
    return is_well_inside ? (p - surface.point(source)).norm() : -1.;
  };
  const Heat_method method(surface);
  const Heat_method delaunay_method(delaunay);
  EXPECT_GT(max_error_in_edges(method, distances_from(method, source), exact), 2);
  EXPECT_LT(max_error_in_edges(delaunay_method, distances_from(delaunay_method, source), exact), 1);
}

TEST(Heat_method, is_exact_on_a_cylinder_to_part_of_an_edge_but_for_the_ridge)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(6, 1, 48, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(surface, {3, 0, 1});
  const Vector_3 from = surface.point(source);
  const auto exact = [&](double max_angle) {
    return [&, max_angle](Index vertex) {
      const Vector_3 to = surface.point(vertex);
      const double angle = std::acos(std::clamp(to.y() * from.y() + to.z() * from.z(), -1., 1.));
      return std::fabs(to.x() - from.x()) < 1 && angle < max_angle ? std::hypot(to.x() - from.x(), angle) : -1;
    };
  };
  const Heat_method method(surface);
  const std::vector<double> distances = distances_from(method, source);
  EXPECT_LT(max_error_in_edges(method, distances, exact(2.8)), 0.6);
  EXPECT_LT(max_error_in_edges(method, distances, exact(4)), 1) << "opposite of the source";
}

TEST(Heat_method, is_exact_on_a_sphere_to_part_of_an_edge_however_fine)
{
  for (const std::size_t times : {2u, 3u, 4u, 5u}) {
    SCOPED_TRACE(times);
    const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(times));
    const Heat_method method(surface);
    const double error = max_error_in_edges(method, distances_from(method, 7), [&](Index vertex) {
      return distance_on_sphere(surface.point(vertex), surface.point(7));
    });
    EXPECT_LT(error, 0.6);
  }
}

TEST(Heat_method, reaches_through_two_thousand_edges)
{
  // Eight edges around, 2000 along; heat reaches through some 740 of them.
  const double edge = 2 * std::sin(pi / 8);
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(2000 * edge, 1, 8, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(surface, {0, 1, 0});
  const std::vector<double> distances = distances_from(Heat_method(surface), source);
  double largest = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const Vector_3 offset = surface.point(vertex) - surface.point(source);
    // A path straight along the tube is a lower bound, one that goes half around it an upper one.
    const double along = std::fabs(offset.x());
    ASSERT_GT(distances[vertex], along - 0.5 * edge);
    ASSERT_LT(distances[vertex], 1.01 * std::hypot(along, 4 * edge) + 0.5 * edge);
    largest = std::max(largest, along);
  }
  EXPECT_GT(largest, 1990 * edge);
}

TEST(Heat_method, does_not_notice_the_frontiers_between_stages)
{
  // From ring to ring of a long tube, heat falls by one factor, so that the distance grows by one length.
  constexpr Index around = 8;
  const double edge = 2 * std::sin(pi / around);
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(2000 * edge, 1, around, CSCD::test::Tube_end::flat));
  const double length = surface.point(around).x() - surface.point(0).x();
  const std::vector<double> distances = distances_from(Heat_method(surface), 0);
  Index number_of_rings = 0;
  for (Index v = 100 * around; surface.point(v).x() < 1900 * edge; v += around, ++number_of_rings) {
    ASSERT_NEAR(distances[v + around] - distances[v], length, 1e-6 * length) << v;
  }
  EXPECT_GT(number_of_rings, 1700u);
}

TEST(Heat_method, is_infinite_on_components_without_a_source)
{
  const CSCD::test::Shape ball = CSCD::test::sphere(3);
  const CSCD::test::Shape ring = CSCD::test::torus(3, 1, 16);
  const Triangulated_surface both =
      CSCD::test::to_surface(CSCD::test::merged("two", {ball, CSCD::test::translated(ring, {100, 0, 0})}));
  const Index offset = Index(ball.points.size());
  const Heat_method method(both);
  const std::vector<double> on_ball = distances_from(Heat_method(CSCD::test::to_surface(ball)), 11);
  const std::vector<double> on_ring = distances_from(Heat_method(CSCD::test::to_surface(ring)), 22);
  std::vector<double> expected = on_ball;
  expected.resize(both.number_of_vertices(), infinity);
  EXPECT_LT(max_difference(expected, distances_from(method, 11)), 1e-9);
  std::copy(on_ring.begin(), on_ring.end(), expected.begin() + offset);
  EXPECT_LT(max_difference(expected, distances_from(method, {Geodesic_source::at_vertex(11),
                                                             Geodesic_source::at_vertex(offset + 22)})),
            1e-9);
  const std::vector<double> nothing = distances_from(method, std::vector<Geodesic_source>{});
  EXPECT_TRUE(std::all_of(nothing.begin(), nothing.end(), [](double d) { return d == infinity; }));
}

TEST(Heat_method, takes_the_nearest_of_several_sources)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(5));
  const Index north = CSCD::test::nearest_vertex(surface, {0, 0, 1});
  const Index east = CSCD::test::nearest_vertex(surface, {1, 0, 0});
  const Heat_method method(surface);
  const std::vector<double> distances =
      distances_from(method, {Geodesic_source::at_vertex(north), Geodesic_source::at_vertex(east)});
  const double error = max_error_in_edges(method, distances, [&](Index vertex) {
    return std::min(distance_on_sphere(surface.point(vertex), surface.point(north)),
                    distance_on_sphere(surface.point(vertex), surface.point(east)));
  });
  EXPECT_LT(error, 1);
  EXPECT_EQ(distances[north], 0);
  EXPECT_EQ(distances[east], 0);
}

TEST(Heat_method, takes_sources_inside_faces)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(4));
  const Heat_method method(surface);
  for (const Index face : {Index(0), Index(777), Index(2500)}) {
    for (const std::array<double, 3>& coordinates :
         {std::array<double, 3>{0.2, 0.5, 0.3}, std::array<double, 3>{0, 0.5, 0.5}, std::array<double, 3>{0, 1, 0}}) {
      Vector_3 point = Vector_3::Zero();
      for (Index k = 0; k < 3; ++k) {
        point += coordinates[k] * surface.point(surface.origin(3 * face + k));
      }
      point.normalize();
      const double error = max_error_in_edges(
          method, distances_from(method, std::vector{Geodesic_source::in_face(surface, face, coordinates)}),
          [&](Index vertex) { return distance_on_sphere(surface.point(vertex), point); });
      EXPECT_LT(error, 0.6);
    }
  }
}

TEST(Heat_method, goes_around_a_slit_and_not_over_it)
{
  const Triangulated_surface surface = CSCD::test::to_bridged_surface(CSCD::test::slit_tube(12, 1, 24));
  // Along the slit, the faces that bridge it join both sides.
  Index source = 0;
  for (Index h = 3 * surface.first_hole_filling_face(); h < surface.number_of_halfedges(); ++h) {
    if (std::fabs(surface.point(surface.origin(h)).x() - 6) < std::fabs(surface.point(source).x() - 6)) {
      source = surface.origin(h);
    }
  }
  const std::vector<double> distances = distances_from(Heat_method(surface), source);
  EXPECT_EQ(distances, distances_from(Heat_method(CSCD::test::lengths_of(surface)), source));
  // The slit is one edge wide: the way to its other side leads round the tube.
  double farthest = 0;
  for (const Index h : surface.outgoing(source)) {
    farthest = std::max(farthest, distances[surface.target(h)]);
  }
  EXPECT_NEAR(farthest, 2 * pi * 23 / 24, 0.3);
}

TEST(Heat_method, gives_the_same_bits_in_batches_of_any_size)
{
  for (const CSCD::test::Shape& shape : {CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.2, 1),
                                         CSCD::test::tube(1500, 1, 6, CSCD::test::Tube_end::flat)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    const Heat_method method(surface);
    for (const std::size_t size : {1u, 2u, 3u, 8u, 13u}) {
      std::vector<std::vector<Geodesic_source>> source_sets;
      for (Index i = 0; i < size; ++i) {
        source_sets.push_back(
            {Geodesic_source::at_vertex(37 * i), Geodesic_source::in_face(surface, 11 * i, {0.5, 0.25, 0.25})});
      }
      source_sets.front().pop_back();
      Heat_method::Workspace workspace;
      std::vector<std::vector<double>> distances;
      method(source_sets, distances, workspace);
      ASSERT_EQ(distances.size(), size);
      for (std::size_t i = 0; i < size; ++i) {
        ASSERT_EQ(distances[i], distances_from(method, source_sets[i]));
      }
    }
  }
}

TEST(Heat_method, may_be_asked_by_several_threads)
{
  const Heat_method method(CSCD::test::to_surface(CSCD::test::torus(3, 1, 16)));
  const std::vector<double> alone = distances_from(method, 7);
  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& result : results) {
    threads.emplace_back([&] { result = distances_from(method, 7); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const std::vector<double>& result : results) {
    EXPECT_EQ(result, alone);
  }
}

TEST(Heat_method, scales_with_the_surface_and_moves_with_it)
{
  const CSCD::test::Shape shape = CSCD::test::noisy(CSCD::test::torus(3, 1, 16), 0.1, 3);
  const std::vector<double> distances = distances_from(Heat_method(CSCD::test::to_surface(shape)), 3);
  for (const double scale : {0x1p-40, 1., 0x1p60}) {
    std::vector<double> scaled =
        distances_from(Heat_method(CSCD::test::to_surface(CSCD::test::scaled(shape, scale))), 3);
    for (double& distance : scaled) {
      distance /= scale;
    }
    EXPECT_EQ(scaled, distances);
  }
  const CSCD::test::Similarity turn{1, CSCD::test::unit({1, 2, 3}), 1, {10, 20, 30}};
  EXPECT_LT(
      max_difference(distances, distances_from(Heat_method(CSCD::test::to_surface(CSCD::test::moved(shape, turn))), 3)),
      1e-9);
}

TEST(Heat_method, handles_degenerate_faces)
{
  const CSCD::test::Shape ball = CSCD::test::sphere(4);
  const std::vector<double> expected = distances_from(Heat_method(CSCD::test::to_surface(ball)), 1000);
  CSCD::test::Shape shape = ball;
  // An edge without length, and a vertex moved onto the edge opposite.
  shape.points[shape.triangles[0][1]] = shape.points[shape.triangles[0][0]];
  const CSCD::test::Triangle& face = shape.triangles[2000];
  shape.points[face[2]] = 0.5 * (shape.points[face[0]] + shape.points[face[1]]);
  const std::vector<double> distances = distances_from(Heat_method(CSCD::test::to_surface(shape)), 1000);
  EXPECT_LT(max_difference(expected, distances), 0.05);
  // All in one point, and all on one line.
  for (const double length : {0., 1.}) {
    CSCD::test::Shape flat = CSCD::test::moved(ball, [length](const CSCD::test::Triple& p) {
      return CSCD::test::Triple{length * p[0], 0, 0};
    });
    for (const double distance : distances_from(Heat_method(CSCD::test::to_surface(flat)), 1000)) {
      ASSERT_TRUE(std::isfinite(distance));
    }
  }
}

TEST(Heat_method, knows_surfaces_of_a_single_vertex)
{
  const CSCD::test::Length_triangulation torus{
      1, {{0, 0, 0}, {0, 0, 0}}, {{1, 1, std::sqrt(2.)}, {1, 1, std::sqrt(2.)}}};
  EXPECT_EQ(distances_from(Heat_method(torus), 0), std::vector<double>{0});
}

TEST(Heat_method, is_smoother_the_longer_heat_flows)
{
  // On the ridge opposite of the source the distance is rounded off, the more the longer.
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(6, 1, 48, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(surface, {3, 0, 1});
  const Index opposite = CSCD::test::nearest_vertex(surface, {3, 0, -1});
  double last = pi;
  for (const double factor : {1., 4., 16.}) {
    const double distance = distances_from(Heat_method(surface, factor), source)[opposite];
    EXPECT_LT(distance, last - 0.01);
    last = distance;
  }
}

} // namespace
