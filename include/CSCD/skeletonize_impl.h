// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default engine, from triangles to the skeleton.

#ifndef CSCD_SKELETONIZE_IMPL_H
#define CSCD_SKELETONIZE_IMPL_H

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Options.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>
#include <CSCD/skeletonize.h>

#include <array>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// The adapter of plain triangles: a model of `SkeletonizationTraits` that identifies vertices by their numbers.
struct Solid_traits
{
  using Point = Vector3;
  using Input_descriptor = Index;
  using Surface = Triangulated_solid;

  const Surface& surface() const { return solid; }
  auto descriptors(Index vertex) const { return solid.input_vertices(vertex); }
  const Normalization& normalization() const { return solid.normalization(); }
  void describe_input(Skeletonization_report& report) const { report = solid.report(); }

  Triangulated_solid solid;
};

} // namespace internal

CSCD_INLINE Skeletonization_report skeletonize(std::vector<Vector3> points, std::vector<std::array<Index, 3>> faces,
                                               const Options& options, const Any_skeletonization_visitor& visitor,
                                               Skeleton& skeleton)
{
  const Local_policies policies(Detail(options.detail), options.node_spacing);
  visitor.on_stage_begin(Skeletonization_stage::compile_surface);
  const internal::Solid_traits traits{
      {std::move(points), std::move(faces), options.border_treatment, options.number_of_threads}};
  visitor.on_stage_end(Skeletonization_stage::compile_surface);
  return internal::run_stages(traits, policies, options, visitor, skeleton);
}

} // namespace CSCD

#endif // CSCD_SKELETONIZE_IMPL_H
