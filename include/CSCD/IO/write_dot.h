// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as graphs of Graphviz.

#ifndef CSCD_IO_WRITE_DOT_H
#define CSCD_IO_WRITE_DOT_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/graphviz.hpp>
#include <boost/property_map/dynamic_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <ostream>

namespace CSCD {

/// writes `skeleton` in Graphviz's DOT language by Boost.Graph: nodes `0`, `1`, ... with the attributes `x`, `y`, `z`
/// and, if they have one, `radius`. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_dot(std::ostream& out, const Skeleton& skeleton)
{
  internal::Exact_format format(out);
  boost::dynamic_properties properties = internal::node_properties(skeleton);
  properties.property("node_id", get(boost::vertex_index, skeleton));
  boost::write_graphviz_dp(out, skeleton, properties);
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_DOT_H
