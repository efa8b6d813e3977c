// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as the SWC files of neuroscience.

#ifndef CSCD_IO_WRITE_SWC_H
#define CSCD_IO_WRITE_SWC_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/Spanning_forest.h>
#include <CSCD/IO/internal/skeleton_node_access.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CSCD {

namespace internal {

/// The structure identifier of a node in SWC: 5 a fork, 6 an end, 0 anything else.
inline int swc_type(std::size_t degree)
{
  constexpr int undefined = 0;
  constexpr int fork_point = 5;
  constexpr int end_point = 6;
  return degree > 2 ? fork_point : degree == 1 ? end_point : undefined;
}

} // namespace internal

/// writes `skeleton` in SWC format: a line `id type x y z radius parent` for each node, identifiers counted from 1,
/// parents before children, -1 as the parent of the first node of each component; radius 0 if the nodes have none.
/// SWC holds forests only: of each cycle one edge is left out and stands in a comment line `# loop i j` instead, with
/// the identifiers of its ends. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_swc(std::ostream& out, const Skeleton& skeleton)
{
  const internal::Spanning_forest<Skeleton> forest(skeleton);
  std::vector<std::size_t> id(num_vertices(skeleton));
  for (std::size_t i = 0; i < forest.order().size(); ++i) {
    id[forest.order()[i]] = i + 1;
  }
  internal::Exact_format format(out);
  out << "# id type x y z radius parent\n";
  for (const auto& [u, v] : forest.loops()) {
    out << "# loop " << id[u] << ' ' << id[v] << '\n';
  }
  for (auto v : forest.order()) {
    out << id[v] << ' ' << internal::swc_type(out_degree(v, skeleton)) << ' ';
    internal::write_coordinates(out, skeleton, v);
    out << ' ' << internal::radius(skeleton, v) << ' ';
    if (forest.parent(v) == v) {
      out << "-1\n";
    } else {
      out << id[forest.parent(v)] << '\n';
    }
  }
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SWC_H
