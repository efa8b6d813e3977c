// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pipeline, step by step.

#ifndef CSCD_CURVE_SKELETONIZATION_H
#define CSCD_CURVE_SKELETONIZATION_H

#include <CSCD/Local_policies.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Options.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector3.h>
#include <CSCD/concepts.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// Computes the curve skeleton of a surface, one stage after the other.
///
/// \code
/// CSCD::Curve_skeletonization skeletonization(mesh);
/// skeletonization.find_separators();
/// skeletonization.pack_separators();
/// skeletonization.convert_to_skeleton(skeleton);
/// \endcode
///
/// \tparam Traits a model of `SkeletonizationTraits`
/// \tparam Policies a model of `SkeletonizationPolicies` for the surface of `Traits`: the algorithms of the stages
/// \tparam Visitor a model of `SkeletonizationVisitor`, or a reference to one
template <class Traits, class Policies = Local_policies, class Visitor = Default_skeletonization_visitor>
class Curve_skeletonization
{
public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = typename Traits::Point;
  /// The identifier of a vertex of the input mesh or of a point of the input.
  using Input_descriptor = typename Traits::Input_descriptor;
  /// The skeleton type that holds everything the pipeline computes.
  using Skeleton = Skeleton_graph<Point, Input_descriptor>;
  /// @}

  /// Prepares to skeletonize the surface of `traits`, which is referred to and must outlive this object.
  explicit Curve_skeletonization(const Traits& traits, Policies policies = Policies(), Visitor visitor = Visitor())
      : Curve_skeletonization(std::shared_ptr<const Traits>(std::shared_ptr<const Traits>(), &traits),
                              std::move(policies), std::forward<Visitor>(visitor))
  {
  }
  /// Prepares to skeletonize `input`, a mesh or another input that traits can be constructed from, which is not
  /// referred to later: `Curve_skeletonization skeletonization(mesh);`.
  /// \throw Input_error if the input cannot be skeletonized; the message names the element and the remedy
  template <class Input,
            std::enable_if_t<!std::is_same_v<Input, Traits> && std::is_constructible_v<Traits, const Input&>, int> = 0>
  explicit Curve_skeletonization(const Input& input, Policies policies = Policies(), Visitor visitor = Visitor())
      : Curve_skeletonization(std::make_shared<const Traits>(input), std::move(policies),
                              std::forward<Visitor>(visitor))
  {
  }
  /// Temporary traits are refused: the object would refer to them.
  template <class... Arguments>
  explicit Curve_skeletonization(const Traits&& traits, Arguments&&...) = delete;

  /// \name Parameters
  /// Each setter returns the object, so that calls chain.
  /// @{

  /// The seed for the order of trying sources.
  unsigned random_seed() const { return m_settings.random_seed; }
  /// Sets the seed for the order of trying sources. Default 0.
  Curve_skeletonization& set_random_seed(unsigned seed)
  {
    m_settings.random_seed = seed;
    return *this;
  }
  /// The bound on the number of sources.
  std::size_t maximum_number_of_sources() const { return m_settings.maximum_number_of_sources; }
  /// Bounds the number of sources. By default, the shape decides.
  Curve_skeletonization& set_maximum_number_of_sources(std::size_t number)
  {
    m_settings.maximum_number_of_sources = number;
    return *this;
  }
  /// The number of threads for `CGAL::Parallel_tag`.
  unsigned number_of_threads() const { return m_number_of_threads; }
  /// Sets the number of threads for `CGAL::Parallel_tag`; 0, the default, means as many as TBB allows.
  Curve_skeletonization& set_number_of_threads(unsigned number)
  {
    m_number_of_threads = number;
    return *this;
  }
  /// @}

  /// \name Stages
  /// @{

  /// Finds separators all over the surface. The answer does not depend on `ConcurrencyTag` nor on the number of
  /// threads. \return their number \throw Cancelled_error if the visitor stops the work
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  std::size_t find_separators()
  {
    m_separators.clear();
    m_packing.reset();
    m_report = m_input_report;
    Stage_runner run_stage(m_visitor, m_report.seconds);
    run_stage(Skeletonization_stage::find_separators, [&] {
      m_settings.number_of_threads = internal::threads_of_tag<ConcurrencyTag>(m_number_of_threads);
      m_separators = m_policies.find_separators(m_traits->surface(), m_settings, m_report,
                                                [&](double fraction) { run_stage.progress(fraction); });
      m_report.number_of_separators = m_separators.size();
    });
    return m_report.number_of_separators;
  }

  /// Weighs, packs and prunes the separators, and cuts the surface along the remaining ones. May be called again.
  /// \return the number of packed separators
  /// \throw Cancelled_error if the visitor stops the work
  std::size_t pack_separators()
  {
    Stage_runner(m_visitor, m_report.seconds)(Skeletonization_stage::pack_separators, [this] {
      m_separators.resize(m_separators.size() - std::exchange(m_report.number_of_handle_cuts, 0));
      m_packing.emplace(m_policies.pack_separators(m_traits->surface(), m_separators, m_report));
      m_report.number_of_packed_separators = m_packing->packed().size();
      m_report.number_of_open_separators =
          std::size_t(std::count_if(m_packing->packed().begin(), m_packing->packed().end(),
                                    [this](Index separator) { return m_separators[separator].is_open; }));
    });
    return m_report.number_of_packed_separators;
  }

  /// Builds the skeleton and writes it to `skeleton`, which is cleared first.
  /// \tparam OutputSkeleton a model of `CurveSkeletonGraph`, or the plain `CSCD::Skeleton` where descriptors are numbers
  /// \pre `pack_separators()` has been called
  /// \throw Cancelled_error if the visitor stops the work; `skeleton` is then as it was
  template <class OutputSkeleton>
  void convert_to_skeleton(OutputSkeleton& skeleton)
  {
    CGAL_precondition(m_packing.has_value());
    OutputSkeleton result;
    Stage_runner(m_visitor, m_report.seconds)(Skeletonization_stage::build_skeleton, [&] {
      const Embedded_skeleton embedded = m_policies.build_skeleton(m_traits->surface(), std::as_const(m_separators),
                                                                   std::as_const(*m_packing), m_report);
      result = make_output<OutputSkeleton>(embedded);
      m_report.warnings = m_input_report.warnings;
      describe_skeleton(embedded.graph, m_report);
    });
    skeleton = std::move(result);
  }

  /// Runs all stages.
  template <class ConcurrencyTag = CGAL::Sequential_tag, class OutputSkeleton>
  const Skeletonization_report& run(OutputSkeleton& skeleton)
  {
    find_separators<ConcurrencyTag>();
    pack_separators();
    convert_to_skeleton(skeleton);
    return m_report;
  }
  /// @}

  /// \name Inspection
  /// @{

  /// The counts, times and warnings of the stages that have been run.
  const Skeletonization_report& report() const { return m_report; }
  /// The separators that were found, except those that packing removed, and those that it added around handles.
  const std::vector<Separator>& separators() const { return m_separators; }
  /// The packed separators, as positions in `separators()`.
  /// \pre `pack_separators()` has been called
  const std::vector<Index>& packed_separators() const
  {
    CGAL_precondition(m_packing.has_value());
    return m_packing->packed();
  }
  /// The closed curve of `separator` in the coordinates of the input; the first point does not stand again at the end.
  std::vector<Point> polyline(const Separator& separator) const
  {
    std::vector<Point> result;
    for (const Vector3& point : points_of(separator)) {
      result.push_back(internal::make_point<Point>(point));
    }
    return result;
  }
  /// @}

private:
  Curve_skeletonization(std::shared_ptr<const Traits> traits, Policies policies, Visitor visitor)
      : m_traits(std::move(traits)), m_policies(std::move(policies)), m_visitor(std::forward<Visitor>(visitor))
  {
    check_skeletonization_traits<Traits>();
    check_skeletonization_policies<Policies, typename Traits::Surface>();
    check_skeletonization_visitor<std::remove_reference_t<Visitor>>();
    m_traits->describe_input(m_input_report);
    m_report = m_input_report;
  }

  using Stage_runner = internal::Stage_runner<std::remove_reference_t<Visitor>>;

  std::vector<Vector3> points_of(const Separator& separator) const
  {
    return internal::to_input(separator, m_traits->surface().triangulation(), m_traits->normalization());
  }

  template <class OutputSkeleton>
  OutputSkeleton make_output(const Embedded_skeleton& embedded) const
  {
    constexpr bool is_plain = std::is_same_v<OutputSkeleton, CSCD::Skeleton>;
    std::vector<Input_descriptor> descriptors;
    CSCD::Skeleton skeleton =
        internal::to_input(embedded, m_traits->normalization(), [&](Index vertex, const auto& add) {
          for (const auto& descriptor : m_traits->descriptors(vertex)) {
            if constexpr (is_plain) {
              add(Index(descriptor));
            } else {
              add(Index(descriptors.size()));
              descriptors.push_back(descriptor);
            }
          }
        });
    if constexpr (is_plain) {
      for (const Index separator : m_packing->packed()) {
        skeleton.separators.push_back(points_of(m_separators[separator]));
      }
      return skeleton;
    } else {
      check_curve_skeleton_graph<OutputSkeleton>();
      return internal::make_skeleton_graph<OutputSkeleton, Point>(skeleton, descriptors);
    }
  }

  std::shared_ptr<const Traits> m_traits; ///< not owned if the user constructed it
  Policies m_policies;
  Visitor m_visitor;
  Options m_settings;
  unsigned m_number_of_threads = 0;
  std::vector<Separator> m_separators;
  std::optional<typename Policies::Packing> m_packing;
  Skeletonization_report m_input_report;
  Skeletonization_report m_report;
};

/// Deduces the traits of a triangle mesh.
template <class TriangleMesh, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
Curve_skeletonization(const TriangleMesh&) -> Curve_skeletonization<Triangle_mesh_traits<TriangleMesh>>;

namespace internal {

/// The policies that `np` gives; by default the local ones, with the detail and the spacing of nodes that
/// `np` gives.
template <class NamedParameters>
auto skeletonization_policies(const NamedParameters& np)
{
  if constexpr (has_policies_v<NamedParameters>) {
    static_assert(parameters::is_default_parameter<NamedParameters, internal_np::detail_t>::value,
                  "CSCD: detail belongs to the default policies and cannot be given with policies");
    static_assert(parameters::is_default_parameter<NamedParameters, internal_np::node_spacing_t>::value,
                  "CSCD: node_spacing belongs to the default policies and cannot be given with policies");
    return parameters::get_parameter(np, internal_np::policies);
  } else {
    const Options options = to_options<CGAL::Sequential_tag>(np);
    return Local_policies(Detail(options.detail), options.node_spacing);
  }
}

/// Runs all stages on the surface of `traits`, with the options that all inputs have in common.
template <class Traits, class Policies, class Visitor, class Skeleton>
Skeletonization_report run_stages(const Traits& traits, const Policies& policies, const Options& options,
                                  Visitor& visitor, Skeleton& skeleton)
{
  Curve_skeletonization<Traits, Policies, Visitor&> skeletonization(traits, policies, visitor);
  skeletonization.set_random_seed(options.random_seed)
      .set_number_of_threads(options.number_of_threads)
      .set_maximum_number_of_sources(options.maximum_number_of_sources);
  return skeletonization.template run<CGAL::Parallel_if_available_tag>(skeleton);
}

/// Makes surface traits by `make_traits()`, and runs all stages on them.
template <class ConcurrencyTag, class MakeTraits, class Policies, class Skeleton, class NamedParameters>
Skeletonization_report skeletonize(const MakeTraits& make_traits, const Policies& policies, Skeleton& skeleton,
                                   const NamedParameters& np)
{
  return with_visitor(np, [&](auto& visitor) {
    visitor.on_stage_begin(Skeletonization_stage::compile_surface);
    const auto traits = make_traits();
    visitor.on_stage_end(Skeletonization_stage::compile_surface);
    return run_stages(traits, policies, to_options<ConcurrencyTag>(np), visitor, skeleton);
  });
}

/// Skeletonizes meshes by the policies that `np` gives.
template <class ConcurrencyTag>
struct Mesh_skeletonization_by_policies
{
  template <class TriangleMesh, class VertexPointMap, class Skeleton, class NamedParameters>
  static Skeletonization_report run(const TriangleMesh& mesh, const VertexPointMap& point_map, Skeleton& skeleton,
                                    const NamedParameters& np)
  {
    check_triangle_mesh<TriangleMesh>();
    using Traits = Triangle_mesh_traits<TriangleMesh, VertexPointMap>;
    const Options options = to_options<ConcurrencyTag>(np);
    return skeletonize<ConcurrencyTag>(
        [&] { return Traits(mesh, point_map, options.border_treatment, options.number_of_threads); },
        skeletonization_policies(np), skeleton, np);
  }
};

} // namespace internal
} // namespace CSCD

#endif // CSCD_CURVE_SKELETONIZATION_H
