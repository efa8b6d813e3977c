// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the coordinates and vertices of a surface back to those of the input.

#ifndef CSCD_TRAITS_TO_INPUT_H
#define CSCD_TRAITS_TO_INPUT_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>

#include <vector>

namespace CSCD::internal {

/// The skeleton `embedded` in the coordinates of the input.
/// \param for_each_input_vertex `for_each_input_vertex(v, add)` calls `add(number)` for the vertices of the input that
///        vertex `v` of the surface represents
template <class ForEachInputVertex>
Skeleton to_input(const Embedded_skeleton& embedded, const Normalization& normalization,
                  const ForEachInputVertex& for_each_input_vertex)
{
  const Skeleton_builder& builder = embedded.graph;
  Skeleton result;
  for (Index node = 0; node < builder.size(); ++node) {
    result.points.push_back(normalization.to_input(builder[node].position));
    result.radii.push_back(embedded.radius[node] * normalization.unit);
    result.is_opening.push_back(builder[node].is_opening ? 1 : 0);
  }
  result.edges = builder.edges();
  result.is_joined.assign(result.edges.size(), 0);
  result.significance = significance_levels(result);
  result.vertices.resize(builder.size());
  for (Index vertex = 0; vertex < embedded.node_of_vertex.size(); ++vertex) {
    std::vector<Index>& of_node = result.vertices[embedded.node_of_vertex[vertex]];
    for_each_input_vertex(vertex, [&of_node](Index number) { of_node.push_back(number); });
  }
  return result;
}

/// The curve of `separator` in the coordinates of the input.
template <class Triangulation>
std::vector<Vector3> to_input(const Separator& separator, const Triangulation& triangulation,
                              const Normalization& normalization)
{
  std::vector<Vector3> points;
  curve_points(triangulation, separator, points);
  for (Vector3& point : points) {
    point = normalization.to_input(point);
  }
  return points;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_TO_INPUT_H
