// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solutions for one and for several right-hand sides, and matrices that have none.

#include "Surface/to_surface.h"
#include "Traits/message_of.h"
#include "support/shapes.h"
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Interleaved_solver.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::Interleaved_solver;
using CSCD::internal::Simd_pack;

TEST(Interleaved_solver, solves_with_either_matrix_and_alike_in_every_lane)
{
  const CSCD::internal::Cotangent_elements elements(
      CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 16), 0.2, 1)));
  const std::vector<Eigen::SparseMatrix<double>> matrices{elements.matrix(1, false), elements.matrix(0.1, true)};
  const Interleaved_solver solver(matrices, "");
  const std::size_t n = solver.size();
  ASSERT_EQ(n, elements.number_of_vertices());
  for (std::size_t m = 0; m < matrices.size(); ++m) {
    std::vector<Simd_pack<8>> together(n);
    for (std::size_t lane = 0; lane < 8; ++lane) {
      Eigen::VectorXd right_side(n);
      std::vector<Simd_pack<1>> alone(n);
      for (Index row = 0; row < n; ++row) {
        // Full in one lane, with a single entry in the others.
        right_side[row] = lane == 0 ? std::sin(double(row)) : double(row == 10 * lane);
        alone[solver.place(row)][0] = together[solver.place(row)][lane] = right_side[row];
      }
      solver.solve(m, alone);
      Eigen::VectorXd solution(n);
      for (Index row = 0; row < n; ++row) {
        solution[row] = alone[solver.place(row)][0];
      }
      const Eigen::VectorXd residual = matrices[m].selfadjointView<Eigen::Lower>() * solution - right_side;
      EXPECT_LT(residual.lpNorm<Eigen::Infinity>(), 1e-12);
      std::vector<Simd_pack<8>> all = together;
      solver.solve(m, all);
      for (std::size_t place = 0; place < n; ++place) {
        ASSERT_EQ(all[place][lane], alone[place][0]);
      }
    }
  }
}

TEST(Interleaved_solver, refuses_a_matrix_that_is_not_positive_definite)
{
  Eigen::SparseMatrix<double> matrix(2, 2);
  matrix.insert(0, 0) = 1;
  matrix.insert(1, 0) = 2;
  matrix.insert(1, 1) = 1;
  EXPECT_EQ(CSCD::test::message_of([&] { Interleaved_solver({matrix}, "indefinite"); }), "indefinite");
  matrix.coeffRef(1, 0) = 1;
  EXPECT_EQ(CSCD::test::message_of([&] { Interleaved_solver({matrix}, "singular"); }), "singular");
}

} // namespace
