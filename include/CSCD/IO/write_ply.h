// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as vertices and edges of PLY.

#ifndef CSCD_IO_WRITE_PLY_H
#define CSCD_IO_WRITE_PLY_H

#include <CSCD/IO/internal/Skeleton_content.h>

#include <cstddef>
#include <ostream>

namespace CSCD {
namespace internal {

inline void write_ply(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  out << "ply\nformat ascii 1.0\nelement vertex " << skeleton.number_of_nodes()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (skeleton.has_radius ? "property double radius\n" : "") << "element edge " << skeleton.edges.size()
      << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    write_coordinates(out, skeleton.points[v]);
    if (skeleton.has_radius) {
      out << ' ' << skeleton.radii[v];
    }
    out << '\n';
  }
  for (const auto& [source, target] : skeleton.edges) {
    out << source << ' ' << target << '\n';
  }
  format.finish();
}

} // namespace internal

/// writes `skeleton` in ASCII PLY: elements `vertex` with `x y z` and, if the nodes have one, `radius`, and elements
/// `edge` with `vertex1 vertex2`. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_ply(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_ply(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_PLY_H
