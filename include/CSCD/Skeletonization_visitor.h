// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stages of a skeletonization and the visitor that is informed of them.

#ifndef CSCD_SKELETONIZATION_VISITOR_H
#define CSCD_SKELETONIZATION_VISITOR_H

#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <type_traits>

namespace CSCD {

/// The stages of the pipeline, in the order of their run.
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

/// Called with the part of a stage that is done, in [0, 1]; an exception that it throws ends the stage.
using Progress = std::function<void(double fraction)>;

/// The visitor that does nothing and never stops the work; the default model of `SkeletonizationVisitor`.
/// All functions are called from the thread that started the skeletonization, in a sequence that does not depend on
/// the number of threads.
struct Default_skeletonization_visitor
{
  /// `stage` begins.
  void on_stage_begin(Skeletonization_stage /* stage */) {}
  /// `stage` has ended.
  void on_stage_end(Skeletonization_stage /* stage */) {}
  /// The running stage has done the part `fraction` of its work, in [0, 1]. A stage never reports less than before.
  void progress(double /* fraction */) {}
  /// Whether to continue: `false` makes the computation throw `Cancelled_error` at once. Called after `progress()`.
  bool go_further() { return true; }
};

#ifdef DOXYGEN_RUNNING
/// Is informed of the progress of a skeletonization and can stop it. All calls come from the thread that runs the
/// pipeline.
///
/// | expression | time and meaning |
/// |---|---|
/// | `v.on_stage_begin(stage)`, `v.on_stage_end(stage)` | a `Skeletonization_stage` begins, and is done |
/// | `v.progress(fraction)` | often: the part of the stage that is done, in [0, 1] |
/// | `v.go_further()` | after each call of `progress()`: false stops the work by a `Cancelled_error` |
///
/// Exceptions that it throws are passed on.
///
/// \cgalHasModels{`Default_skeletonization_visitor`}
/// \cgalArchetype{Visitor_archetype.h}
/// \cgalConcept
class SkeletonizationVisitor
{
};
#endif

/// refuses at compile time a type that is not a model of `SkeletonizationVisitor`.
/// \ingroup PkgCSCDConceptChecks
template <class T>
constexpr void check_skeletonization_visitor()
{
  static_assert(CSCD_IS_VALID(T&, t.on_stage_begin(Skeletonization_stage())),
                "CSCD: SkeletonizationVisitor requires v.on_stage_begin(Skeletonization_stage)");
  static_assert(CSCD_IS_VALID(T&, t.on_stage_end(Skeletonization_stage())),
                "CSCD: SkeletonizationVisitor requires v.on_stage_end(Skeletonization_stage)");
  static_assert(CSCD_IS_VALID(T&, t.progress(0.5)), "CSCD: SkeletonizationVisitor requires v.progress(double)");
  static_assert(CSCD_GIVES(bool, T&, t.go_further()),
                "CSCD: SkeletonizationVisitor requires v.go_further(), convertible to bool");
}

/// A visitor of any type, a model of `SkeletonizationVisitor`, which is referred to. Engines that are not templates
/// call its functions by it.
struct Any_skeletonization_visitor
{
  /// Refers to `visitor`; a copy refers to the visitor of the original.
  template <class Visitor, class = std::enable_if_t<!std::is_same_v<Visitor, Any_skeletonization_visitor>>>
  explicit Any_skeletonization_visitor(Visitor& visitor)
      : on_stage_begin([&visitor](Skeletonization_stage stage) { visitor.on_stage_begin(stage); }),
        on_stage_end([&visitor](Skeletonization_stage stage) { visitor.on_stage_end(stage); }),
        progress([&visitor](double fraction) { visitor.progress(fraction); }),
        go_further([&visitor]() -> bool { return visitor.go_further(); })
  {
  }

  std::function<void(Skeletonization_stage)> on_stage_begin; ///< a stage begins
  std::function<void(Skeletonization_stage)> on_stage_end;   ///< it has ended
  Progress progress;                                         ///< a part of it is done
  std::function<bool()> go_further;                          ///< whether to continue
};

namespace internal {

/// Runs the stages of one skeletonization: informs the visitor and measures time. Refers to both.
template <class Visitor>
class Stage_runner
{
public:
  /// The time of each stage.
  using Seconds = std::array<double, number_of_skeletonization_stages>;

  Stage_runner(Visitor& visitor, Seconds& seconds) : m_visitor(visitor), m_seconds(seconds) {}

  /// Calls `run()`. \throw Cancelled_error if the visitor stops the work
  template <class Run>
  void operator()(Skeletonization_stage stage, const Run& run)
  {
    m_visitor.on_stage_begin(stage);
    progress(0);
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    m_seconds[static_cast<std::size_t>(stage)] = seconds.count();
    progress(1);
    m_visitor.on_stage_end(stage);
  }

  /// Reports that a part of the stage is done. \throw Cancelled_error if the visitor stops the work
  void progress(double fraction)
  {
    m_visitor.progress(fraction);
    if (!m_visitor.go_further()) {
      throw Cancelled_error();
    }
  }

private:
  Visitor& m_visitor;
  Seconds& m_seconds;
};

} // namespace internal
} // namespace CSCD

#endif // CSCD_SKELETONIZATION_VISITOR_H
