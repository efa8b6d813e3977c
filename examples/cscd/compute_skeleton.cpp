// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation.

#include "compute_skeleton.h"

#include "Progress_visitor.h"
#include "compute_mesh_skeleton.h"
#include "compute_point_cloud_skeleton.h"
#include "compute_point_skeleton.h"
#include "compute_tree_skeleton.h"
#include <CSCD/Skeletonization_visitor.h>

namespace cscd {

Skeletonization_result compute_skeleton(Input& input, const Skeletonize_options& options, Progress_bar* bar)
{
  Progress_visitor visitor(bar);
  visitor.on_stage_begin(CSCD::Skeletonization_stage::compile_surface);
  if (!input.is_point_set) {
    return compute_mesh_skeleton(input, options, visitor);
  }
  if (options.shape == tree_shape) {
    return compute_tree_skeleton(input, options);
  }
  return options.method == published_method ? compute_point_cloud_skeleton(input, options, visitor)
                                            : compute_point_skeleton(input, options, visitor);
}

} // namespace cscd
