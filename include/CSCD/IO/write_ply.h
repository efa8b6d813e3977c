// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as vertices and edges of PLY.

#ifndef CSCD_IO_WRITE_PLY_H
#define CSCD_IO_WRITE_PLY_H

#include <CSCD/IO/internal/Skeleton_content.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CSCD {
namespace internal {

inline void write_ply(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  out << "ply\nformat ascii 1.0\nelement vertex " << skeleton.number_of_nodes()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (skeleton.has_radius ? "property double radius\n" : "") << "element edge " << skeleton.edges.size()
      << "\nproperty int vertex1\nproperty int vertex2\n"
      << (skeleton.has_radius ? "property double significance\n" : "") << "end_header\n";
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    write_coordinates(out, skeleton.points[v]);
    if (skeleton.has_radius) {
      out << ' ' << skeleton.radii[v];
    }
    out << '\n';
  }
  const std::vector<double> significances = edge_significances(skeleton);
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    out << skeleton.edges[e][0] << ' ' << skeleton.edges[e][1];
    if (skeleton.has_radius) {
      out << ' ' << finite_significance(significances[e]);
    }
    out << '\n';
  }
  format.finish();
}

} // namespace internal

/// writes `skeleton` in ASCII PLY: elements `vertex` with `x y z` and, if the nodes have one, `radius`, and elements
/// `edge` with `vertex1 vertex2` and, if the nodes have radii, `significance`, the greatest double for what is never
/// cut. O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_ply(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_ply(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_PLY_H
