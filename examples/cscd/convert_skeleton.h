// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of points as the program holds them.

#ifndef CSCD_PROGRAM_CONVERT_SKELETON_H
#define CSCD_PROGRAM_CONVERT_SKELETON_H

#include "types.h"
#include <CSCD/Skeleton_graph.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <cstddef>

namespace cscd {

/// The same skeleton with numbers of points as vertices of a mesh.
inline Skeleton convert_skeleton(const CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  Skeleton result;
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    auto& converted = result[add_vertex(result)];
    converted.point = skeleton[node].point;
    converted.radius = skeleton[node].radius;
    for (std::size_t number : skeleton[node].vertices) {
      converted.vertices.emplace_back(static_cast<Mesh::size_type>(number));
    }
  }
  for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
    add_edge(source(edge, skeleton), target(edge, skeleton), result);
  }
  return result;
}

} // namespace cscd

#endif // CSCD_PROGRAM_CONVERT_SKELETON_H
