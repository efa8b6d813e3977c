// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solutions of closed chains, put back into their equations.

#include <CSCD/Published/solve_cyclic_tridiagonal.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Vector_3;

TEST(solve_cyclic_tridiagonal, fulfils_the_equations)
{
  for (const std::size_t n : {3u, 4u, 5u, 50u}) {
    std::vector<double> coupling;
    std::vector<Vector_3> right_side;
    for (std::size_t i = 0; i < n; ++i) {
      coupling.push_back(1.5 + std::sin(double(i)));
      right_side.emplace_back(std::cos(double(i)), double(i == 0), 1);
    }
    std::vector<double> diagonal;
    for (std::size_t i = 0; i < n; ++i) {
      diagonal.push_back(coupling[i] + coupling[(i + n - 1) % n] + 0.01 * double(i + 1));
    }
    std::vector<double> used_diagonal = diagonal;
    std::vector<double> column;
    std::vector<Vector_3> x = right_side;
    CSCD::internal::solve_cyclic_tridiagonal(used_diagonal, coupling, x, column);
    for (std::size_t i = 0; i < n; ++i) {
      const Vector_3 left_side =
          diagonal[i] * x[i] - coupling[i] * x[(i + 1) % n] - coupling[(i + n - 1) % n] * x[(i + n - 1) % n];
      EXPECT_LT((left_side - right_side[i]).norm(), 1e-10) << "row " << i << " of " << n;
    }
  }
}

} // namespace
