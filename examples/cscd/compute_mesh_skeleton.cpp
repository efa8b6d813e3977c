// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for meshes; a file of its own, as the code for it takes long to compile.

#include "compute_mesh_skeleton.h"

#include "published_policies.h"
#include "run_skeletonization.h"
#include "types.h"
#include <CSCD/Local_policies.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <utility>

namespace cscd {

Skeletonization_result compute_mesh_skeleton(const Input& input, const Skeletonize_options& options,
                                             Progress_visitor& visitor)
{
  using Traits = CSCD::Triangle_mesh_traits<Mesh>;
  const Traits traits(input.mesh);
  Skeleton skeleton;
  Skeletonization_result result =
      options.method == published_method
          ? run_skeletonization(traits, published_policies(options), options, visitor, skeleton)
          : run_skeletonization(traits, CSCD::Local_policies(), options, visitor, skeleton);
  result.skeleton = std::move(skeleton);
  return result;
}

} // namespace cscd
