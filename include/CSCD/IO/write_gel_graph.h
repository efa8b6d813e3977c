// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as graphs of the GEL library.

#ifndef CSCD_IO_WRITE_GEL_GRAPH_H
#define CSCD_IO_WRITE_GEL_GRAPH_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <ostream>

namespace CSCD {

/// writes `skeleton` in GEL's `.graph` format: a line `n x y z` for each node, then a line `c i j` for each edge, with
/// nodes counted from 0. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_gel_graph(std::ostream& out, const Skeleton& skeleton)
{
  internal::Exact_format format(out);
  for (auto v : boost::make_iterator_range(vertices(skeleton))) {
    out << "n ";
    internal::write_coordinates(out, skeleton, v);
    out << '\n';
  }
  for (auto e : boost::make_iterator_range(edges(skeleton))) {
    out << "c " << source(e, skeleton) << ' ' << target(e, skeleton) << '\n';
  }
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_GEL_GRAPH_H
