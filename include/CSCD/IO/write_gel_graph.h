// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as graphs of the GEL library.

#ifndef CSCD_IO_WRITE_GEL_GRAPH_H
#define CSCD_IO_WRITE_GEL_GRAPH_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector_3.h>

#include <ostream>

namespace CSCD {
namespace internal {

inline void write_gel_graph(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  for (const Vector_3& point : skeleton.points) {
    out << "n ";
    write_coordinates(out, point);
    out << '\n';
  }
  for (const auto& [source, target] : skeleton.edges) {
    out << "c " << source << ' ' << target << '\n';
  }
  format.finish();
}

} // namespace internal

/// writes `skeleton` in GEL's `.graph` format: a line `n x y z` for each node, then a line `c i j` for each edge, with
/// nodes counted from 0. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_gel_graph(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_gel_graph(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_GEL_GRAPH_H
