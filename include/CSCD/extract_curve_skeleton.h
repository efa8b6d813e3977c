// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve skeleton of a triangle mesh in one call.

#ifndef CSCD_EXTRACT_CURVE_SKELETON_H
#define CSCD_EXTRACT_CURVE_SKELETON_H

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/concepts.h>
#include <CSCD/internal/detection.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CSCD {

/// Whether `T` is a graph without faces: it has vertices and edges, as Boost's graphs; for any type.
template <class T>
inline constexpr bool is_spatial_graph_v = CSCD_IS_VALID(const T&, vertices(t)) && CSCD_IS_VALID(const T&, edges(t)) &&
                                           !is_triangle_mesh_v<T> && !is_point_range_v<T>;

namespace internal {

/// The policies that `np` gives; by default the local ones, with the cost and the detail that `np` gives.
template <class NamedParameters>
auto skeletonization_policies(const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  constexpr bool has_cost = !is_default_parameter<NamedParameters, internal_np::separator_cost_t>::value;
  constexpr bool has_detail = !is_default_parameter<NamedParameters, internal_np::detail_t>::value;
  if constexpr (!is_default_parameter<NamedParameters, internal_np::policies_t>::value) {
    static_assert(!has_cost && !has_detail,
                  "CSCD: separator_cost and detail belong to the default policies and cannot be given with policies");
    return get_parameter(np, internal_np::policies);
  } else {
    Local_policies policies;
    if constexpr (has_cost) {
      auto cost = get_parameter(np, internal_np::separator_cost);
      check_separator_cost<decltype(cost)>();
      policies = Local_policies(cost);
    }
    if constexpr (has_detail) {
      policies.set_detail(Detail(get_parameter(np, internal_np::detail)));
    }
    return policies;
  }
}

/// The number of threads that `ConcurrencyTag` and `np` ask for, 0 for as many as TBB allows; any integer type will do.
template <class ConcurrencyTag, class NamedParameters>
unsigned requested_threads(const NamedParameters& np)
{
  constexpr bool is_parallel = std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>;
  const auto number = parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_threads), 0u);
  return is_parallel ? unsigned(number) : 1;
}

/// Runs the pipeline on the surface traits that `make_traits()` returns, with the parameters that meshes and points
/// have in common.
template <class ConcurrencyTag, class Traits, class MakeTraits, class Policies, class Skeleton, class NamedParameters>
Skeletonization_report skeletonize(const MakeTraits& make_traits, const Policies& policies, Skeleton& skeleton,
                                   const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  // A copy of the visitor, or a reference where it was given as one.
  Default_skeletonization_visitor default_visitor;
  using Visitor = typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::visitor_t, NamedParameters,
                                                                     Default_skeletonization_visitor>::reference;
  Visitor visitor = choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);
  using Visitor_reference = std::remove_reference_t<Visitor>&;
  check_skeletonization_visitor<std::remove_reference_t<Visitor>>();

  visitor.on_stage_begin(Skeletonization_stage::compile_surface);
  const Traits traits = make_traits();
  visitor.on_stage_end(Skeletonization_stage::compile_surface);

  Curve_skeletonization<Traits, Policies, Visitor_reference> skeletonization(traits, policies, visitor);
  // Any integer type will do for a number.
  skeletonization.set_random_seed(unsigned(choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), 0u)))
      .set_number_of_threads(requested_threads<ConcurrencyTag>(np))
      .set_maximum_number_of_sources(std::size_t(choose_parameter(
          get_parameter(np, internal_np::maximum_number_of_sources), std::numeric_limits<std::size_t>::max())));
  return skeletonization.template run<ConcurrencyTag>(skeleton);
}

} // namespace internal

/// extracts the curve skeleton of a triangle mesh.
///
/// Every connected component of the mesh gets a connected skeleton; the first Betti number of the skeleton is the genus
/// of the surface. Borders are bridged first, by faces without weight; but a component that is a sheet, and not the
/// surface of a body with openings, is doubled along its wide borders, of which b give a Betti number of 2 g + b - 1,
/// and its skeleton runs along its middle. The result is the same for any number of threads. The cost is near linear in
/// the number of vertices.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Skeleton a model of `CurveSkeletonGraph`: `Skeleton_graph`, or CGAL's
///         `Mean_curvature_flow_skeletonization<TriangleMesh>::Skeleton`
/// \param mesh a triangle mesh, open or closed, of any number of components
/// \param skeleton is cleared first; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{the seed of the order in which vertices are tried as sources}
///     \cgalParamType{unsigned int}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_sources}
///     \cgalParamDescription{bounds the number of sources from which separators are sought}
///     \cgalParamType{std::size_t}
///     \cgalParamDefault{no bound: the shape decides}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{the number of threads for `CGAL::Parallel_tag`}
///     \cgalParamType{unsigned int}
///     \cgalParamDefault{0: as many as TBB allows, one a core unless `tbb::global_control` says otherwise}
///   \cgalParamNEnd
///   \cgalParamNBegin{policies}
///     \cgalParamDescription{the algorithms of the stages; `Published_policies` for the method as published}
///     \cgalParamType{a model of `SkeletonizationPolicies`}
///     \cgalParamDefault{`Local_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{detail}
///     \cgalParamDescription{how small a limb may be to get a branch, from 0 to 1: see `Detail`; not with `policies`}
///     \cgalParamType{double}
///     \cgalParamDefault{0.5}
///   \cgalParamNEnd
///   \cgalParamNBegin{border_treatment}
///     \cgalParamDescription{which components are sheets, with open separators from border to border}
///     \cgalParamType{`Border_treatment`}
///     \cgalParamDefault{`Border_treatment::automatic`}
///   \cgalParamNEnd
///   \cgalParamNBegin{separator_cost}
///     \cgalParamDescription{of two separators that overlap, the one of lower cost is packed; not with `policies`}
///     \cgalParamType{a model of `SeparatorCost`}
///     \cgalParamDefault{`Length_and_planarity_cost`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is informed of progress and may stop the work}
///     \cgalParamType{a model of `SkeletonizationVisitor`, copied unless given as `std::ref(visitor)`}
///     \cgalParamDefault{`Default_skeletonization_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return counts, timings and warnings
/// \throw Input_error if `mesh` cannot be skeletonized; the message names the element and the remedy
/// \throw Cancelled_error if the visitor stops the work
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh, class Skeleton,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_point_range_v<TriangleMesh> && !is_spatial_graph_v<TriangleMesh>, int> = 0>
Skeletonization_report extract_curve_skeleton(const TriangleMesh& mesh, Skeleton& skeleton,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::random_seed_t,
                                   CGAL::internal_np::visitor_t, internal_np::maximum_number_of_sources_t,
                                   internal_np::number_of_threads_t, internal_np::separator_cost_t,
                                   internal_np::detail_t, internal_np::policies_t, internal_np::border_treatment_t>();
  check_triangle_mesh<TriangleMesh>();
  const auto point_map = internal::vertex_point_map(mesh, np);
  using Traits = Triangle_mesh_traits<TriangleMesh, std::decay_t<decltype(point_map)>>;
  const auto treatment = parameters::choose_parameter(parameters::get_parameter(np, internal_np::border_treatment),
                                                      Border_treatment::automatic);
  return internal::skeletonize<ConcurrencyTag, Traits>(
      [&] { return Traits(mesh, point_map, treatment, internal::requested_threads<ConcurrencyTag>(np)); },
      internal::skeletonization_policies(np), skeleton, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CURVE_SKELETON_H
