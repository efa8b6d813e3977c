// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for points on the surface made of them; a file of its own, as the code for it takes long to compile.

#include "compute_point_skeleton.h"

#include "Numbered_points.h"
#include "compute_tree_skeleton.h"
#include "convert_skeleton.h"
#include "run_skeletonization.h"
#include <CSCD/Local_policies.h>
#include <CSCD/Traits/Reconstructed_surface_traits.h>
#include <CSCD/exceptions.h>

#include <string>
#include <vector>

namespace cscd {

namespace {

using Traits = CSCD::Reconstructed_surface_traits<Numbered_points::Numbers, Numbered_points::Point_map>;

Skeletonization_result compute_surface_skeleton(const Traits& traits, const Skeletonize_options& options,
                                                Progress_visitor& visitor)
{
  Numbered_points::Skeleton skeleton;
  Skeletonization_result result =
      run_skeletonization(traits, CSCD::Local_policies(), options, visitor, skeleton);
  result.skeleton = convert_skeleton(skeleton);
  result.is_of_points = true;
  return result;
}

/// The skeleton of points that may be no surface, with the reason in front of the warnings.
Skeletonization_result compute_recognized_tree_skeleton(Input& input, const Skeletonize_options& options,
                                                        const std::string& reason)
{
  Skeletonization_result result = compute_tree_skeleton(input, options);
  std::vector<std::string>& warnings = result.tree->warnings;
  warnings.insert(warnings.begin(), reason + ": taken for a scan of trees; --shape surface or tree decides");
  return result;
}

} // namespace

Skeletonization_result compute_point_skeleton(Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  const Numbered_points points(input.points, input.normals);
  try {
    const auto traits = points.make_traits<Traits>();
    if (options.shape == surface_shape || !traits.is_surface_doubtful()) {
      Skeletonization_result result = compute_surface_skeleton(traits, options, visitor);
      input.mesh = points.make_mesh(traits);
      return result;
    }
  } catch (const CSCD::Surface_error&) {
    if (options.shape == surface_shape) {
      throw;
    }
    return compute_recognized_tree_skeleton(input, options, "the points do not sample a surface");
  }
  return compute_recognized_tree_skeleton(input, options, "the points hardly sample the surface of a body");
}

} // namespace cscd
