// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eigenvectors, also of values that are equal up to rounding.

#include <CSCD/Vector_3.h>
#include <CSCD/internal/principal_axes.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace {

using CSCD::Vector_3;
using CSCD::internal::Moment_matrix;

TEST(principal_axes, are_orthonormal_where_values_are_equal_up_to_rounding)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const double gap : {0., 1e-17, 1e-16, 3e-16, 1e-15, 1e-14, 1e-3}) {
    for (int i = 0; i < 1000; ++i) {
      const Vector_3 axis = Vector_3(coordinate(random), coordinate(random), coordinate(random)).normalized();
      const Vector_3 second = axis.unitOrthogonal();
      for (const double value : {0.1, 3.}) { // of the axis: the least, the greatest
        Moment_matrix matrix{};
        matrix += Moment_matrix::product(value * axis, axis);
        matrix += Moment_matrix::product((1 + gap) * second, second);
        const Vector_3 third = axis.cross(second);
        matrix += Moment_matrix::product(third, third);
        const auto [values, vectors] = CSCD::internal::principal_axes(matrix);
        EXPECT_NEAR(std::abs(vectors[value < 1 ? 0 : 2].dot(axis)), 1, 1e-6);
        for (std::size_t a = 0; a < 3; ++a) {
          for (std::size_t b = 0; b <= a; ++b) {
            ASSERT_NEAR(vectors[a].dot(vectors[b]), a == b ? 1 : 0, 1e-6) << gap << ", vectors " << a << " and " << b;
          }
        }
      }
    }
  }
}

} // namespace
