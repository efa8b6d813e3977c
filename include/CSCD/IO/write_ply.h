// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as vertices and edges of PLY.

#ifndef CSCD_IO_WRITE_PLY_H
#define CSCD_IO_WRITE_PLY_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <ostream>

namespace CSCD {

/// writes `skeleton` in ASCII PLY: elements `vertex` with `x y z` and, if the nodes have one, `radius`, and elements
/// `edge` with `vertex1 vertex2`. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_ply(std::ostream& out, const Skeleton& skeleton)
{
  internal::Exact_format format(out);
  out << "ply\nformat ascii 1.0\nelement vertex " << num_vertices(skeleton)
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (has_radius_v<Skeleton> ? "property double radius\n" : "") << "element edge " << num_edges(skeleton)
      << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for (auto v : boost::make_iterator_range(vertices(skeleton))) {
    internal::write_coordinates(out, skeleton, v);
    if constexpr (has_radius_v<Skeleton>) {
      out << ' ' << internal::radius(skeleton, v);
    }
    out << '\n';
  }
  for (auto e : boost::make_iterator_range(edges(skeleton))) {
    out << source(e, skeleton) << ' ' << target(e, skeleton) << '\n';
  }
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_PLY_H
