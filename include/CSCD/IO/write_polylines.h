// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as the poly-lines that CGAL's examples write and read.

#ifndef CSCD_IO_WRITE_POLYLINES_H
#define CSCD_IO_WRITE_POLYLINES_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>
#include <CSCD/Skeleton/split_into_branches.h>

#include <ostream>

namespace CSCD {

/// writes `skeleton` in the format `.polylines.txt`: a line for each branch, the number of its nodes and then
/// `x y z` of each; closed branches repeat their first node. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_polylines(std::ostream& out, const Skeleton& skeleton)
{
  internal::Exact_format format(out);
  for (const auto& branch : split_into_branches(skeleton)) {
    out << branch.size();
    for (auto v : branch) {
      out << ' ';
      internal::write_coordinates(out, skeleton, v);
    }
    out << '\n';
  }
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_POLYLINES_H
