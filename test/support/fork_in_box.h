// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small surface with a small skeleton, for tests of outputs that show both.

#ifndef CSCD_TEST_SUPPORT_FORK_IN_BOX_H
#define CSCD_TEST_SUPPORT_FORK_IN_BOX_H

#include "convert_shape.h"
#include "shape_operations.h"
#include "simple_shapes.h"
#include <CSCD/Skeleton_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

namespace CSCD::test {

using Box_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// A box around the point `middle`, long in the direction of x.
inline Box_mesh box_mesh(const Triple& middle = {0, 0, 0})
{
  const Triple size{4, 1, 1};
  return to_mesh<Box_mesh>(translated(box("box", size), middle - 0.5 * size));
}

/// The radius of the nodes of the fork, where they have one.
inline constexpr double fork_radius = 0.4;

/// Three branches in a box around `middle`, one of them of two edges: nodes 0 - 1 - 2, and from 2 to 3 and to 4.
/// Vertex i of the mesh belongs to node i % 5.
template <class Skeleton>
Skeleton fork_in_box(const Box_mesh& mesh, const Triple& middle = {0, 0, 0})
{
  std::vector<Triple> places{{-1.6, 0, 0}, {-0.8, 0, 0}, {0, 0, 0}, {1.6, 0.3, 0.3}, {1.6, -0.3, -0.3}};
  for (Triple& place : places) {
    place = middle + place;
  }
  auto skeleton = to_graph<Skeleton>(places, {{0, 1}, {1, 2}, {2, 3}, {2, 4}}, std::vector<double>(5, fork_radius));
  for (const Box_mesh::Vertex_index v : mesh.vertices()) {
    skeleton[v.idx() % places.size()].vertices.push_back(v);
  }
  return skeleton;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_FORK_IN_BOX_H
