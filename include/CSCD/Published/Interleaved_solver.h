// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves a factored sparse system for several right-hand sides side by side.

#ifndef CSCD_PUBLISHED_INTERLEAVED_SOLVER_H
#define CSCD_PUBLISHED_INTERLEAVED_SOLVER_H

#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <string>
#include <vector>

namespace CSCD::internal {

/// One number of each of `size` problems that are solved together, a power of two: 8 of them fill a cache line.
template <std::size_t size>
struct alignas(size * sizeof(double)) Simd_pack
{
  using Array = Eigen::Array<double, int(size), 1>;

  auto array() { return Eigen::Map<Array, Eigen::Aligned>(values); }
  auto array() const { return Eigen::Map<const Array, Eigen::Aligned>(values); }

  double& operator[](std::size_t lane) { return values[lane]; }
  double operator[](std::size_t lane) const { return values[lane]; }

  double values[size];
};

/// The factors of symmetric positive definite matrices with a common pattern, for many right-hand sides.
///
/// Eigen factors (LDL^T with approximate minimum degree ordering). The triangular solves are not Eigen's, which treat
/// several right-hand sides one after the other, each of which waits for the factor to come from memory. Here the
/// numbers of several right-hand sides lie side by side, and one pass over the factor serves all.
/// All members are const and may be called by several threads at once.
class Interleaved_solver
{
public:
  /// Factors `matrices`, of which the lower triangles are read.
  /// \pre they are not empty, and have the same size and pattern
  /// \throw Input_error if one of them is not positive definite within rounding; the message is `message`
  Interleaved_solver(const std::vector<Eigen::SparseMatrix<double>>& matrices, const std::string& message)
  {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> factorization;
    factorization.analyzePattern(matrices.front());
    for (const Eigen::SparseMatrix<double>& matrix : matrices) {
      CGAL_precondition(matrix.nonZeros() == matrices.front().nonZeros());
      factorization.factorize(matrix);
      const auto& pivots = factorization.vectorD();
      if (factorization.info() != Eigen::Success || !pivots.allFinite() || !(pivots.minCoeff() > 0)) {
        throw Input_error(message);
      }
      const auto& lower = factorization.matrixL().nestedExpression();
      if (m_row.empty()) {
        copy_pattern(lower);
      }
      m_factors.push_back({{lower.valuePtr(), lower.valuePtr() + m_row.size()}, {}});
      const Eigen::VectorXd inverses = pivots.cwiseInverse();
      m_factors.back().inverse_pivots.assign(inverses.data(), inverses.data() + inverses.size());
    }
    const auto& places = factorization.permutationP().indices();
    m_place.assign(places.data(), places.data() + places.size());
  }

  std::size_t size() const { return m_place.size(); }

  /// The place of `row` in the order of elimination, in which right-hand sides and solutions are given.
  Index place(Index row) const { return m_place[row]; }

  /// Replaces the right-hand sides `x`, in the order of elimination, by the solutions for the matrix of this number.
  /// Linear in the number of nonzeros of the factor; the solutions of a lane do not depend on the other lanes.
  /// \pre `x.size() == size()`
  template <std::size_t lanes>
  void solve(std::size_t matrix, std::vector<Simd_pack<lanes>>& x) const
  {
    CGAL_precondition(x.size() == size());
    const double* value = m_factors[matrix].values.data();
    for (std::size_t column = 0; column < size(); ++column) {
      const typename Simd_pack<lanes>::Array from = x[column].array();
      // Right-hand sides with few entries reach few columns.
      if ((from != 0).any()) {
        for (std::size_t entry = m_column_begin[column]; entry < m_column_begin[column + 1]; ++entry) {
          x[m_row[entry]].array() -= value[entry] * from;
        }
      }
    }
    const double* inverse_pivot = m_factors[matrix].inverse_pivots.data();
    for (std::size_t column = size(); column-- > 0;) {
      typename Simd_pack<lanes>::Array sum = inverse_pivot[column] * x[column].array();
      for (std::size_t entry = m_column_begin[column]; entry < m_column_begin[column + 1]; ++entry) {
        sum -= value[entry] * x[m_row[entry]].array();
      }
      x[column].array() = sum;
    }
  }

private:
  struct Factor
  {
    std::vector<double> values; // of the entries below the diagonal, column by column
    std::vector<double> inverse_pivots;
  };

  template <class LowerTriangle>
  void copy_pattern(const LowerTriangle& lower)
  {
    CGAL_assertion(lower.isCompressed());
    m_column_begin.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
    m_row.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
  }

  std::vector<Index> m_place;
  std::vector<Index> m_column_begin; // in the entries, and their number at the end
  std::vector<Index> m_row;          // of every entry
  std::vector<Factor> m_factors;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_INTERLEAVED_SOLVER_H
