// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation; a file of its own, as the code for it takes long to compile.

#include "compute_skeleton.h"

#include "Progress_visitor.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/tags.h>

#include <chrono>
#include <cstddef>

namespace cscd {

Skeletonization_result compute_skeleton(const Mesh& mesh, const Skeletonize_options& options, Progress_bar* bar)
{
  using Traits = CSCD::Triangle_mesh_traits<Mesh>;
  using Clock = std::chrono::steady_clock;
  constexpr auto first_stage = CSCD::Skeletonization_stage::compile_surface;

  Progress_visitor visitor(bar);
  visitor.on_stage_begin(first_stage);
  const Clock::time_point start = Clock::now();
  const Traits traits(mesh);
  const std::chrono::duration<double> seconds = Clock::now() - start;

  CSCD::Curve_skeletonization<Traits, CSCD::Local_policies<Traits>, Progress_visitor&> skeletonization(traits, {},
                                                                                                       visitor);
  skeletonization.set_random_seed(options.seed).set_number_of_threads(options.number_of_threads);
  if (options.maximum_number_of_sources > 0) {
    skeletonization.set_maximum_number_of_sources(options.maximum_number_of_sources);
  }
  Skeletonization_result result;
  result.report = options.number_of_threads == 1
                      ? skeletonization(result.skeleton)
                      : skeletonization.operator()<CGAL::Parallel_if_available_tag>(result.skeleton);
  result.report.seconds[static_cast<std::size_t>(first_stage)] = seconds.count();
  for (auto separator : skeletonization.packed_separators()) {
    result.separators.push_back(skeletonization.polyline(skeletonization.separators()[separator]));
  }
  return result;
}

} // namespace cscd
