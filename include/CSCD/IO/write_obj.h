// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as poly-lines of Wavefront OBJ.

#ifndef CSCD_IO_WRITE_OBJ_H
#define CSCD_IO_WRITE_OBJ_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Vector_3.h>

#include <ostream>
#include <vector>

namespace CSCD {
namespace internal {

inline void write_obj(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  for (const Vector_3& point : skeleton.points) {
    out << "v ";
    write_coordinates(out, point);
    out << '\n';
  }
  for (const std::vector<Index>& branch : split_into_branches(node_neighbors(skeleton))) {
    out << (branch.size() == 1 ? 'p' : 'l');
    for (const Index v : branch) {
      out << ' ' << v + 1;
    }
    out << '\n';
  }
  format.finish();
}

} // namespace internal

/// writes `skeleton` in OBJ format: a line `v x y z` for each node, then a line `l i j k ...` for each branch, with
/// nodes counted from 1; an isolated node is a line `p i`. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_obj(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_obj(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_OBJ_H
