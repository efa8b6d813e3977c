// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as the poly-lines that CGAL's examples write and read.

#ifndef CSCD_IO_WRITE_POLYLINES_H
#define CSCD_IO_WRITE_POLYLINES_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Vector_3.h>

#include <ostream>
#include <vector>

namespace CSCD {
namespace internal {

inline void write_polylines(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  for (const std::vector<Index>& branch : split_into_branches(node_neighbors(skeleton))) {
    out << branch.size();
    for (const Index v : branch) {
      out << ' ';
      write_coordinates(out, skeleton.points[v]);
    }
    out << '\n';
  }
  format.finish();
}

} // namespace internal

/// writes `skeleton` in the format `.polylines.txt`: a line for each branch, the number of its nodes and then
/// `x y z` of each; closed branches repeat their first node. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_polylines(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_polylines(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_POLYLINES_H
