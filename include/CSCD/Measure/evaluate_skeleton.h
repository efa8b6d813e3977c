// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How good a skeleton is: one call for all measures.

#ifndef CSCD_MEASURE_EVALUATE_SKELETON_H
#define CSCD_MEASURE_EVALUATE_SKELETON_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <cstddef>
#include <vector>

namespace CSCD {
namespace internal {

/// Where radii come from, and how fine the reconstructed surfaces are.
struct Evaluation_parameters
{
  bool uses_skeleton_radii = false;
  std::size_t resolution = 200; ///< cells of the lattice along the diagonal of the bounding box
};

/// Reads a mesh, or a range of points, which have no triangles; refuses at compile time named parameters that do not
/// apply to it.
template <class Surface, class NamedParameters>
Checked_triangles measured_input(const Surface& surface, const NamedParameters& np)
{
  if constexpr (is_triangle_mesh_v<Surface>) {
    check_triangle_mesh<Surface>();
    check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t, internal_np::resolution_t,
                           internal_np::use_skeleton_radii_t>();
    return collect_triangles(surface, vertex_point_map(surface, np));
  } else {
    check_named_parameters<NamedParameters, CGAL::internal_np::point_t, internal_np::resolution_t,
                           internal_np::use_skeleton_radii_t>();
    return {{coordinates_of(surface, point_map(surface, np)), {}}, {}, {}};
  }
}

/// Estimates the radius of each node from points of the surface alone. Each point is assigned to the nearest point of
/// the skeleton, at distance d and at parameter t of an edge; it counts for the source of the edge with weight 1 - t
/// and for the target with weight t. The radius of a node is the weighted mean of the distances; nodes without points
/// are interpolated from their neighbors.
/// O(p log e) for p points and e well-spread edges.
/// \throw Input_error if too many edges are near each other, or they make too many cycles
/// \pre there are points and nodes
std::vector<double> estimate_radii(const std::vector<Vector3>& points, const Skeleton& skeleton);

/// \param input a mesh, or points without triangles, in the coordinates of `skeleton`
Skeleton_measures evaluate_skeleton(Checked_triangles&& input, Skeleton&& skeleton,
                                    const Evaluation_parameters& parameters);

} // namespace internal

/// measures how good a skeleton is for a surface.
///
/// The measures are those of `Skeleton_measures`; `doc/measures.md` gives their formulas. Two surfaces are
/// reconstructed from the skeleton: the convolution surface, as in the method's paper (supplement, appendix D), and the
/// union of round cones. By default, radii are estimated from the surface in the same way for every skeleton, so that
/// skeletons of all makers compete on geometry alone. O((n + f) log(n + f) + f e) for n points or faces of the input, f
/// faces of the reconstructions and e edges.
///
/// \tparam Surface a model of `FaceListGraph` whose faces are all triangles; or a range of points or of elements that
///         `point_map` maps to points, a `CGAL::Point_set_3` included, without measures of the position
/// \tparam Skeleton a model of `CurveSkeletonGraph`: `Skeleton_graph`, or CGAL's
///         `Mean_curvature_flow_skeletonization<TriangleMesh>::Skeleton`
/// \param surface an oriented manifold with or without borders, or points
/// \param skeleton in the coordinates of `surface`
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices, if `surface` is a mesh}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements, if `surface` is a range}
///     \cgalParamType{a model of `ReadablePropertyMap` with the value type of the range as key}
///     \cgalParamDefault{`surface.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{resolution}
///     \cgalParamDescription{the number of cells along the diagonal of the bounding box, for the triangulation of the
///     reconstructed surfaces}
///     \cgalParamType{std::size_t in [1, 10000]}
///     \cgalParamDefault{200}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_skeleton_radii}
///     \cgalParamDescription{whether the radii of the skeleton's nodes are used, not estimated ones}
///     \cgalParamType{bool}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the measures; those not defined for the input are `undefined_measure`
/// \throw Input_error if the surface or the skeleton is empty, they are far from each other, a coordinate is not
///        finite, the mesh is not an oriented manifold of triangles, the skeleton's radii are to be used and it has
///        none, or the skeleton is too large: more than 2^18 nodes and edges, or 2048 cycles where radii are estimated
template <class Surface, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Skeleton_measures evaluate_skeleton(const Surface& surface, const Skeleton& skeleton,
                                    const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::Evaluation_parameters settings;
  settings.uses_skeleton_radii =
      choose_parameter(get_parameter(np, internal_np::use_skeleton_radii), settings.uses_skeleton_radii);
  settings.resolution = std::size_t(choose_parameter(get_parameter(np, internal_np::resolution), settings.resolution));
  return internal::evaluate_skeleton(internal::measured_input(surface, np), internal::index_skeleton(skeleton),
                                     settings);
}

} // namespace CSCD

#endif // CSCD_MEASURE_EVALUATE_SKELETON_H
