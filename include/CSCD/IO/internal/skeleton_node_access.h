// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the writers ask of a node of a skeleton.

#ifndef CSCD_IO_INTERNAL_SKELETON_NODE_ACCESS_H
#define CSCD_IO_INTERNAL_SKELETON_NODE_ACCESS_H

#include <CSCD/Skeleton_graph.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <ostream>

namespace CSCD::internal {

/// The position of node `v`.
template <class Skeleton>
std::array<double, 3> coordinates(const Skeleton& skeleton, typename boost::graph_traits<Skeleton>::vertex_descriptor v)
{
  const auto& point = skeleton[v].point;
  return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
}

/// The radius of node `v`; 0 if the nodes of `Skeleton` carry none.
template <class Skeleton>
double radius(const Skeleton& skeleton, typename boost::graph_traits<Skeleton>::vertex_descriptor v)
{
  if constexpr (has_radius_v<Skeleton>) {
    return skeleton[v].radius;
  } else {
    return 0;
  }
}

/// Writes the position of node `v` as `x y z`.
template <class Skeleton>
void write_coordinates(std::ostream& out, const Skeleton& skeleton,
                       typename boost::graph_traits<Skeleton>::vertex_descriptor v)
{
  const std::array<double, 3> p = coordinates(skeleton, v);
  out << p[0] << ' ' << p[1] << ' ' << p[2];
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SKELETON_NODE_ACCESS_H
