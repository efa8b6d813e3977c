// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stages of a skeletonization and the visitor that is informed of them.

#ifndef CSCD_SKELETONIZATION_VISITOR_H
#define CSCD_SKELETONIZATION_VISITOR_H

#include <array>
#include <cstddef>

namespace CSCD {

/// The stages of the pipeline, in the order in which they run.
enum class Skeletonization_stage
{
  compile_surface, ///< input checked and compiled into flat arrays and coarse levels
  find_separators, ///< one separator sought for each source
  pack_separators, ///< separators weighed, pruned and packed; surface cut along the packed ones
  build_skeleton   ///< nodes placed, skeleton refined, vertices assigned
};

/// Number of values of `Skeletonization_stage`.
inline constexpr std::size_t number_of_skeletonization_stages = 4;

/// The name of `stage` in words, as in a progress bar.
inline const char* name(Skeletonization_stage stage)
{
  constexpr std::array<const char*, number_of_skeletonization_stages> names{"compile surface", "find separators",
                                                                            "pack separators", "build skeleton"};
  return names[static_cast<std::size_t>(stage)];
}

/// The visitor that does nothing and never stops the work; the default model of `SkeletonizationVisitor`.
/// All functions are called from the thread that started the skeletonization, in a sequence that does not depend on
/// the number of threads.
struct Default_skeletonization_visitor
{
  /// `stage` begins.
  void on_stage_begin(Skeletonization_stage /* stage */) {}
  /// `stage` has ended.
  void on_stage_end(Skeletonization_stage /* stage */) {}
  /// The running stage has done the part `fraction` of its work, in [0, 1], never less than what was told before.
  void progress(double /* fraction */) {}
  /// Whether to continue: `false` makes the computation throw `Cancelled_error` at once. Called between batches.
  bool go_further() { return true; }
};

} // namespace CSCD

#endif // CSCD_SKELETONIZATION_VISITOR_H
