// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for scans of trees; a file of its own, as the code for it takes long to compile.

#include "compute_tree_skeleton.h"

#include "convert_skeleton.h"
#include "types.h"
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_tree_skeleton.h>

#include <cstddef>

namespace cscd {

Skeletonization_result compute_tree_skeleton(Input& input, const Skeletonize_options& options)
{
  Skeletonization_result result;
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  if (options.root.empty()) {
    result.tree = CSCD::extract_tree_skeleton(input.points, skeleton);
  } else {
    const Point root(options.root[0], options.root[1], options.root[2]);
    result.tree = CSCD::extract_tree_skeleton(input.points, skeleton, CSCD::parameters::root(root));
  }
  result.skeleton = convert_skeleton(skeleton);
  input.mesh.clear();
  for (const Point& point : input.points) {
    input.mesh.add_vertex(point);
  }
  return result;
}

} // namespace cscd
