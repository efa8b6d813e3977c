// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve skeleton of a triangle mesh in one call.

#ifndef CSCD_EXTRACT_CURVE_SKELETON_H
#define CSCD_EXTRACT_CURVE_SKELETON_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Options.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/input_concepts.h>
#include <CSCD/skeletonize.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CSCD {

namespace internal {

/// Skeletonizes meshes by algorithms of the user's choice; defined by `Curve_skeletonization.h`, which
/// `Published_policies.h` includes.
template <class ConcurrencyTag>
struct Mesh_skeletonization_by_policies;

/// Extracts the skeleton of `mesh` by the default engine.
template <class TriangleMesh, class VertexPointMap, class Skeleton, class Visitor>
Skeletonization_report extract_curve_skeleton(const TriangleMesh& mesh, const VertexPointMap& point_map,
                                              Skeleton& skeleton, const Options& options, Visitor& visitor)
{
  check_triangle_mesh<TriangleMesh>();
  check_curve_skeleton_graph<Skeleton>();
  auto arrays = read_mesh(mesh, point_map);
  CSCD::Skeleton plain_skeleton;
  Skeletonization_report report = skeletonize(std::move(arrays.points), std::move(arrays.faces), options,
                                              Any_skeletonization_visitor(visitor), plain_skeleton);
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  skeleton = make_skeleton_graph<Skeleton, Point>(plain_skeleton, arrays.descriptors);
  return report;
}

} // namespace internal

/// extracts the curve skeleton of a triangle mesh.
///
/// Every connected component of the mesh gets a connected skeleton; the first Betti number of the skeleton is the genus
/// of the surface. Borders are bridged first, by faces without weight; but a component that is a sheet, and not the
/// surface of a body with openings, is doubled along its wide borders. Its skeleton runs along its middle, and b wide
/// borders give it the Betti number 2 g + b - 1. The result is the same for any number of threads. The cost is near
/// linear in the number of vertices.
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
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{accepted and not used: coordinates are computed with as `double`}
///     \cgalParamType{any}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{the seed for the order of trying vertices as sources}
///     \cgalParamType{unsigned int}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_sources}
///     \cgalParamDescription{bounds the number of sources that start a search for a separator}
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
///   \cgalParamNBegin{node_spacing}
///     \cgalParamDescription{the length that edges may have, in radii of the body, where nodes are left out of straight
///                           branches; not with `policies`}
///     \cgalParamType{double}
///     \cgalParamDefault{0: only nodes that no vertex belongs to are left out}
///   \cgalParamNEnd
///   \cgalParamNBegin{border_treatment}
///     \cgalParamDescription{which components are sheets, with open separators from border to border}
///     \cgalParamType{`Border_treatment`}
///     \cgalParamDefault{`Border_treatment::automatic`}
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
          std::enable_if_t<!is_point_range_v<TriangleMesh> && !is_spatial_graph_v<TriangleMesh> &&
                               !std::is_same_v<NamedParameters, Options>,
                           int> = 0>
Skeletonization_report extract_curve_skeleton(const TriangleMesh& mesh, Skeleton& skeleton,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::geom_traits_t, CGAL::internal_np::vertex_point_t,
                                   CGAL::internal_np::random_seed_t, CGAL::internal_np::visitor_t,
                                   internal_np::maximum_number_of_sources_t, internal_np::number_of_threads_t,
                                   internal_np::detail_t, internal_np::node_spacing_t, internal_np::policies_t,
                                   internal_np::border_treatment_t>();
  const auto point_map = internal::vertex_point_map(mesh, np);
  if constexpr (internal::has_policies_v<NamedParameters>) {
    return internal::Mesh_skeletonization_by_policies<ConcurrencyTag>::run(mesh, point_map, skeleton, np);
  } else {
    return internal::with_visitor(np, [&](auto& visitor) {
      return internal::extract_curve_skeleton(mesh, point_map, skeleton, internal::to_options<ConcurrencyTag>(np),
                                              visitor);
    });
  }
}

/// The same with plain options in place of named parameters.
template <class TriangleMesh, class Skeleton,
          std::enable_if_t<!is_point_range_v<TriangleMesh> && !is_spatial_graph_v<TriangleMesh>, int> = 0>
Skeletonization_report extract_curve_skeleton(const TriangleMesh& mesh, Skeleton& skeleton, const Options& options)
{
  Default_skeletonization_visitor visitor;
  return internal::extract_curve_skeleton(mesh, get(CGAL::vertex_point, mesh), skeleton, options, visitor);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CURVE_SKELETON_H
