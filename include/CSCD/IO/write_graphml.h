// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as GraphML.

#ifndef CSCD_IO_WRITE_GRAPHML_H
#define CSCD_IO_WRITE_GRAPHML_H

#include <CSCD/IO/internal/Boost_skeleton.h>
#include <CSCD/IO/internal/Skeleton_content.h>

#include <boost/graph/graphml.hpp>
#include <boost/property_map/dynamic_property_map.hpp>

#include <ostream>

namespace CSCD {
namespace internal {

inline void write_graphml(std::ostream& out, const Skeleton_content& skeleton)
{
  Exact_format format(out);
  const Boost_skeleton graph = boost_skeleton(skeleton);
  const boost::dynamic_properties properties = skeleton_properties(skeleton, graph);
  constexpr bool has_ordered_vertices = true;
  boost::write_graphml(out, graph, properties, has_ordered_vertices);
  format.finish();
}

} // namespace internal

/// writes `skeleton` as GraphML by Boost.Graph: nodes `n0`, `n1`, ... with the properties `x`, `y`, `z` and, if they
/// have one, `radius`; edges then have `significance`, the greatest double for what is never cut. O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_graphml(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_graphml(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_GRAPHML_H
