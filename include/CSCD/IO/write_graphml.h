// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as GraphML.

#ifndef CSCD_IO_WRITE_GRAPHML_H
#define CSCD_IO_WRITE_GRAPHML_H

#include <CSCD/IO/internal/Skeleton_content.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CSCD {
namespace internal {

/// Writes the declarations of the properties `key0`, `key1`, ...: with radii `radius` and `significance` come first.
inline void write_graphml_keys(std::ostream& out, bool has_radius)
{
  int number = 0;
  const auto write_key = [&](const char* owner, const char* name) {
    out << "  <key id=\"key" << number++ << "\" for=\"" << owner << "\" attr.name=\"" << name
        << "\" attr.type=\"double\" />\n";
  };
  if (has_radius) {
    write_key("node", "radius");
    write_key("edge", "significance");
  }
  for (const char* name : {"x", "y", "z"}) {
    write_key("node", name);
  }
}

inline void write_graphml(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
         "xsi:schemaLocation=\"http://graphml.graphdrawing.org/xmlns "
         "http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd\">\n";
  write_graphml_keys(out, skeleton.has_radius);
  out << "  <graph id=\"G\" edgedefault=\"undirected\" parse.nodeids=\"canonical\" parse.edgeids=\"canonical\" "
         "parse.order=\"nodesfirst\">\n";
  const auto write_value = [&](int key, double value) {
    out << "      <data key=\"key" << key << "\">" << value << "</data>\n";
  };
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    out << "    <node id=\"n" << v << "\">\n";
    if (skeleton.has_radius) {
      write_value(0, skeleton.radii[v]);
    }
    for (int i = 0; i < 3; ++i) {
      write_value((skeleton.has_radius ? 2 : 0) + i, skeleton.points[v][i]);
    }
    out << "    </node>\n";
  }
  const std::vector<double> significances = edge_significances(skeleton);
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    out << "    <edge id=\"e" << e << "\" source=\"n" << skeleton.edges[e][0] << "\" target=\"n" << skeleton.edges[e][1]
        << "\">\n";
    if (skeleton.has_radius) {
      write_value(1, finite_significance(significances[e]));
    }
    out << "    </edge>\n";
  }
  out << "  </graph>\n</graphml>\n";
  format.finish();
}

} // namespace internal

/// writes `skeleton` as GraphML: nodes `n0`, `n1`, ... with the properties `x`, `y`, `z` and, if they have one,
/// `radius`; edges then have `significance`, the greatest double for what is never cut. O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_graphml(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_graphml(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_GRAPHML_H
