// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves the linear systems of closed chains.

#ifndef CSCD_PUBLISHED_SOLVE_CYCLIC_TRIDIAGONAL_H
#define CSCD_PUBLISHED_SOLVE_CYCLIC_TRIDIAGONAL_H

#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Replaces `right_side` by the solution of a closed chain: row i has `diagonal[i]`, and -`coupling[i]` for its
/// successor, -`coupling[i - 1]` for its predecessor. Linear.
/// Eliminates from the first row to the last, with the last column carried along as a further right-hand side.
/// \param diagonal is overwritten
/// \pre there are at least three rows, and each diagonal entry is greater than the sum of its row's couplings, which are
///      not negative
inline void solve_cyclic_tridiagonal(std::vector<double>& diagonal, const std::vector<double>& coupling,
                                     std::vector<Vector_3>& right_side, std::vector<double>& last_column)
{
  const std::size_t n = diagonal.size();
  CGAL_precondition(n >= 3 && coupling.size() == n && right_side.size() == n);
  // Rows 0 to n - 2 say: x_i = right_side_i + coupling_i / diagonal_i x_{i+1} + last_column_i x_{n-1}.
  last_column.assign(n, 0.);
  last_column[0] = coupling[n - 1];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (i > 0) {
      diagonal[i] -= coupling[i - 1] * coupling[i - 1] / diagonal[i - 1];
      right_side[i] += coupling[i - 1] * right_side[i - 1];
      last_column[i] = coupling[i - 1] * last_column[i - 1];
    }
    right_side[i] /= diagonal[i];
    last_column[i] /= diagonal[i];
  }
  // Backwards, with x_{n-1} still unknown.
  for (std::size_t i = n - 1; i-- > 0;) {
    const double part = coupling[i] / diagonal[i];
    if (i + 2 == n) {
      last_column[i] += part;
    } else {
      right_side[i] += part * right_side[i + 1];
      last_column[i] += part * last_column[i + 1];
    }
  }
  right_side[n - 1] += coupling[n - 2] * right_side[n - 2] + coupling[n - 1] * right_side[0];
  right_side[n - 1] /= diagonal[n - 1] - coupling[n - 2] * last_column[n - 2] - coupling[n - 1] * last_column[0];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    right_side[i] += last_column[i] * right_side[n - 1];
  }
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SOLVE_CYCLIC_TRIDIAGONAL_H
