// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as graphs of Graphviz.

#ifndef CSCD_IO_WRITE_DOT_H
#define CSCD_IO_WRITE_DOT_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CSCD {
namespace internal {

/// `value` as an attribute of DOT, whose numerals have no exponent: other numbers are put in quotes.
inline std::string dot_value(double value)
{
  std::ostringstream out;
  const Exact_format format(out);
  out << value;
  const std::string text = out.str();
  return text.find_first_not_of("-.0123456789") == std::string::npos ? text : '"' + text + '"';
}

inline void write_dot(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  out << "graph G {\n";
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    const Vector_3& point = skeleton.points[v];
    out << v << " [";
    if (skeleton.has_radius) {
      out << "radius=" << dot_value(skeleton.radii[v]) << ", ";
    }
    out << "x=" << dot_value(point.x()) << ", y=" << dot_value(point.y()) << ", z=" << dot_value(point.z()) << "];\n";
  }
  const std::vector<double> significances = edge_significances(skeleton);
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    out << skeleton.edges[e][0] << "--" << skeleton.edges[e][1] << ' ';
    if (skeleton.has_radius) {
      out << " [significance=" << dot_value(finite_significance(significances[e])) << ']';
    }
    out << ";\n";
  }
  out << "}\n";
  format.finish();
}

} // namespace internal

/// writes `skeleton` in Graphviz's DOT language: nodes `0`, `1`, ... with the attributes `x`, `y`, `z` and, if they
/// have one, `radius`; edges then have `significance`, the greatest double for what is never cut. O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_dot(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_dot(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_DOT_H
