// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for points by their neighborhoods; a file of its own, as the code for it takes long to compile.

#include "compute_point_cloud_skeleton.h"

#include "Numbered_points.h"
#include "convert_skeleton.h"
#include "published_policies.h"
#include "run_skeletonization.h"
#include <CSCD/Traits/Point_set_traits.h>

namespace cscd {

Skeletonization_result compute_point_cloud_skeleton(Input& input, const Skeletonize_options& options,
                                                    Progress_visitor& visitor)
{
  using Traits = CSCD::Point_set_traits<Numbered_points::Numbers, Numbered_points::Point_map>;
  const Numbered_points points(input.points, input.normals);
  const auto traits = points.make_traits<Traits>();
  Numbered_points::Skeleton skeleton;
  Skeletonization_result result =
      run_skeletonization(traits, published_policies(options), options, visitor, skeleton);
  result.skeleton = convert_skeleton(skeleton);
  result.is_of_points = true;
  input.mesh = points.make_mesh(traits);
  return result;
}

} // namespace cscd
