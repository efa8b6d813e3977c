// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default engine, from triangles to the skeleton.

#ifndef CSCD_SKELETONIZE_IMPL_H
#define CSCD_SKELETONIZE_IMPL_H

#include <CSCD/Local/Covering_search.h>
#include <CSCD/Options.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/embed_skeleton.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>
#include <CSCD/skeletonize.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD {

CSCD_INLINE Skeletonization_report skeletonize(std::vector<Vector3> points, std::vector<std::array<Index, 3>> faces,
                                               const Options& options, const Any_skeletonization_visitor& visitor,
                                               Skeleton& skeleton)
{
  const Detail detail(options.detail);
  visitor.on_stage_begin(Skeletonization_stage::compile_surface);
  const Triangulated_solid solid(std::move(points), std::move(faces), options.border_treatment,
                                 options.number_of_threads);
  Skeletonization_report report = solid.report();
  visitor.on_stage_end(Skeletonization_stage::compile_surface);

  internal::Stage_runner<const Any_skeletonization_visitor> run_stage(visitor, report.seconds);
  std::vector<Separator> separators;
  run_stage(Skeletonization_stage::find_separators, [&] {
    separators =
        internal::find_local_separators(solid, options, report, [&](double fraction) { run_stage.progress(fraction); });
    report.number_of_separators = separators.size();
  });
  std::unique_ptr<internal::Separator_packing> packing;
  run_stage(Skeletonization_stage::pack_separators, [&] {
    packing = internal::pack_local_separators(solid, detail, separators, report);
    report.number_of_packed_separators = packing->packed().size();
    report.number_of_open_separators =
        std::size_t(std::count_if(packing->packed().begin(), packing->packed().end(),
                                  [&](Index separator) { return separators[separator].is_open; }));
  });
  Skeleton result;
  run_stage(Skeletonization_stage::build_skeleton, [&] {
    const Embedded_skeleton embedded = internal::embed_skeleton(solid, separators, packing->packed(),
                                                                packing->cut_graph(), options.node_spacing, report);
    result = internal::to_input(embedded, solid.normalization(), [&](Index vertex, const auto& add) {
      for (const Index input : solid.input_vertices(vertex)) {
        add(input);
      }
    });
    for (const Index separator : packing->packed()) {
      result.separators.push_back(
          internal::to_input(separators[separator], solid.triangulation(), solid.normalization()));
    }
    describe_skeleton(embedded.graph, report);
  });
  skeleton = std::move(result);
  return report;
}

} // namespace CSCD

#endif // CSCD_SKELETONIZE_IMPL_H
