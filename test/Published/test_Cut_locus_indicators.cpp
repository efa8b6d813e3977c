// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured at a vertex: exact for linear functions, large where fronts meet, of no scale.

#include "Published/to_surface_with_borders.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::internal::Cut_criterion;
using CSCD::internal::Cut_locus_indicators;
using CSCD::internal::Tangent_frames;
using CSCD::test::pi;
using CSCD::test::Shape;
using CSCD::test::Triple;

/// A shape with a function on its vertices, and what is measured of it.
class Measured_shape
{
public:
  template <class Function>
  Measured_shape(const Shape& shape, const Function& function)
      : m_values(CSCD::test::sampled(shape, function)), m_surface(CSCD::test::to_surface_with_borders(shape)),
        m_frames(m_surface), m_measures(m_frames, m_values)
  {
  }

  const Cut_locus_indicators<Triangulated_surface>* operator->() const { return &m_measures; }
  const CSCD::Vector_3& point(Index v) const { return m_surface.point(v); }
  Index size() const { return m_surface.number_of_vertices(); }

private:
  std::vector<double> m_values;
  Triangulated_surface m_surface;
  Tangent_frames<Triangulated_surface> m_frames;
  Cut_locus_indicators<Triangulated_surface> m_measures;
};

TEST(Cut_locus_indicators, of_a_linear_function)
{
  const Shape grid = CSCD::test::flat_grid(8, 8, 0.25);
  const Measured_shape measured(grid, [](const Triple& p) { return 0.6 * p[0] + 0.8 * p[1]; });
  for (Index v = 0; v < measured.size(); ++v) {
    EXPECT_NEAR(std::abs(measured->gradient(v)), 1, 1e-12);
    EXPECT_NEAR(measured->convergence(v), 0, 1e-6);
    const CSCD::Vector_3 p = measured.point(v);
    if (p.x() > 0 && p.x() < 2 && p.y() > 0 && p.y() < 2) {
      EXPECT_NEAR(measured->laplacian(v), 0, 1e-12);
    }
    EXPECT_FALSE(measured->is_cut(v, Cut_criterion()));
  }
}

TEST(Cut_locus_indicators, where_two_fronts_meet_or_part)
{
  // Gradients that make the angle a with the ridge: they converge by 2 a, and the Laplacian jumps by 2 sin(a).
  for (const double a : {pi / 2, pi / 4, pi / 8}) {
    for (const double size : {1e-6, 1., 1e6}) {
      const Shape grid = CSCD::test::flat_grid(8, 8, size);
      const auto distance = [&](double sign) {
        return [&, sign](const Triple& p) {
          return 100 * size + std::cos(a) * p[0] - sign * std::sin(a) * std::fabs(p[1] - 4 * size);
        };
      };
      const Index on_ridge = 4 * 9 + 4;
      const Measured_shape ridge(grid, distance(1));
      EXPECT_NEAR(ridge->convergence(on_ridge), 2 * a, 1e-6);
      EXPECT_NEAR(ridge->convergence(on_ridge, ridge->gradients()), 2 * a, 1e-6);
      // Squares have the dual area 1; the mean edge is longer than their side.
      EXPECT_NEAR(ridge->laplacian(on_ridge), -2 * std::sin(a) * ridge->frames().mean_edge_length() / size, 1e-6);
      EXPECT_EQ(ridge->is_cut(on_ridge, Cut_criterion()), a >= pi / 6);
      const Measured_shape valley(grid, distance(-1));
      EXPECT_NEAR(valley->convergence(on_ridge), 0, 1e-6);
      EXPECT_NEAR(valley->convergence(on_ridge, valley->gradients()), 0, 1e-6);
      EXPECT_GT(valley->laplacian(on_ridge), 0);
    }
  }
}

TEST(Cut_locus_indicators, at_the_antipode_of_a_sphere_and_at_its_source)
{
  const Measured_shape sphere(CSCD::test::sphere(4), [](const Triple& p) { return std::acos(p[2]); });
  std::size_t number = 0;
  for (Index v = 0; v < sphere.size(); ++v) {
    if (sphere->is_cut(v, Cut_criterion())) {
      ++number;
      EXPECT_LT(sphere.point(v).z(), -0.99);
    }
  }
  EXPECT_GT(number, 0u);
}

TEST(Cut_locus_indicators, of_distances_that_are_not_known)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Measured_shape measured(CSCD::test::flat_grid(4, 4, 1),
                                [&](const Triple& p) { return p[0] > 2.5 ? infinity : -std::fabs(p[0] - 1); });
  for (Index v = 0; v < measured.size(); ++v) {
    EXPECT_TRUE(std::isfinite(measured->laplacian(v)));
    EXPECT_TRUE(std::isfinite(measured->convergence(v)));
    EXPECT_TRUE(std::isfinite(measured->convergence(v, measured->gradients())));
    EXPECT_TRUE(measured.point(v).x() < 2.5 || !measured->is_cut(v, Cut_criterion()));
  }
}

TEST(Cut_locus_indicators, around_a_vertex_of_many_faces)
{
  const Measured_shape cone(CSCD::test::double_cone(2000), [](const Triple& p) { return p[0]; });
  const Index tip = 2000;
  EXPECT_EQ(cone.point(tip).x(), 4);
  EXPECT_GT(cone->convergence(tip), pi / 3);
  EXPECT_LT(cone->laplacian(tip), -0.5);
}

TEST(Cut_locus_indicators, of_faces_without_area)
{
  Shape shape = CSCD::test::flat_grid(2, 2, 1);
  shape.points[4] = shape.points[3];
  const Measured_shape measured(shape, [](const Triple& p) { return p[0]; });
  for (Index v = 0; v < measured.size(); ++v) {
    EXPECT_TRUE(std::isfinite(measured->laplacian(v)));
    EXPECT_TRUE(std::isfinite(std::abs(measured->gradient(v))));
  }
}

} // namespace
