// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as poly-lines of Wavefront OBJ.

#ifndef CSCD_IO_WRITE_OBJ_H
#define CSCD_IO_WRITE_OBJ_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>
#include <CSCD/Skeleton/split_into_branches.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <ostream>

namespace CSCD {

/// writes `skeleton` in OBJ format: a line `v x y z` for each node, then a line `l i j k ...` for each branch, with
/// nodes counted from 1; an isolated node is a line `p i`. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_obj(std::ostream& out, const Skeleton& skeleton)
{
  internal::Exact_format format(out);
  for (auto v : boost::make_iterator_range(vertices(skeleton))) {
    out << "v ";
    internal::write_coordinates(out, skeleton, v);
    out << '\n';
  }
  for (const auto& branch : split_into_branches(skeleton)) {
    out << (branch.size() == 1 ? 'p' : 'l');
    for (auto v : branch) {
      out << ' ' << v + 1;
    }
    out << '\n';
  }
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_OBJ_H
