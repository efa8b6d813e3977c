// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as graphs of Graphviz.

#ifndef CSCD_IO_WRITE_DOT_H
#define CSCD_IO_WRITE_DOT_H

#include <CSCD/IO/internal/Boost_skeleton.h>
#include <CSCD/IO/internal/Skeleton_content.h>

#include <boost/graph/graphviz.hpp>
#include <boost/property_map/dynamic_property_map.hpp>

#include <ostream>

namespace CSCD {
namespace internal {

inline void write_dot(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  const Boost_skeleton graph = boost_skeleton(skeleton);
  boost::dynamic_properties properties = skeleton_properties(skeleton, graph);
  properties.property("node_id", get(boost::vertex_index, graph));
  boost::write_graphviz_dp(out, graph, properties);
  format.finish();
}

} // namespace internal

/// writes `skeleton` in Graphviz's DOT language by Boost.Graph: nodes `0`, `1`, ... with the attributes `x`, `y`, `z`
/// and, if they have one, `radius`; edges then have `significance`, the greatest double for what is never cut.
/// O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_dot(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_dot(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_DOT_H
