// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the computation that meshes and points have in common.

#ifndef CSCD_PROGRAM_RUN_SKELETONIZATION_H
#define CSCD_PROGRAM_RUN_SKELETONIZATION_H

#include "Progress_visitor.h"
#include "Skeletonization_result.h"
#include "Skeletonize_options.h"
#include <CSCD/Curve_skeletonization.h>

#include <CGAL/tags.h>

namespace cscd {

/// Skeletonizes the surface of `traits` into `skeleton` by the algorithms of `policies`. \return the rest of the result
template <class Traits, class Policies, class AnySkeleton>
Skeletonization_result run_skeletonization(const Traits& traits, const Policies& policies,
                                           const Skeletonize_options& options, Progress_visitor& visitor,
                                           AnySkeleton& skeleton)
{
  CSCD::Curve_skeletonization<Traits, Policies, Progress_visitor&> skeletonization(traits, policies, visitor);
  skeletonization.set_random_seed(options.seed).set_number_of_threads(options.number_of_threads);
  if (options.maximum_number_of_sources > 0) {
    skeletonization.set_maximum_number_of_sources(options.maximum_number_of_sources);
  }
  Skeletonization_result result;
  result.report = skeletonization.template run<CGAL::Parallel_if_available_tag>(skeleton);
  for (auto separator : skeletonization.packed_separators()) {
    result.separators.push_back(skeletonization.polyline(skeletonization.separators()[separator]));
  }
  return result;
}

} // namespace cscd

#endif // CSCD_PROGRAM_RUN_SKELETONIZATION_H
