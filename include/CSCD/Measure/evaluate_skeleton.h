// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How good a skeleton is: one call for all measures.

#ifndef CSCD_MEASURE_EVALUATE_SKELETON_H
#define CSCD_MEASURE_EVALUATE_SKELETON_H

#include <CSCD/Measure/Position_measurement.h>
#include <CSCD/Measure/Skeleton_evaluation.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <type_traits>

namespace CSCD {

/// measures how good a skeleton is for a surface.
///
/// The measures are those of `Skeleton_measures`; `doc/measures.md` gives their formulas. Two surfaces are
/// reconstructed from the skeleton: the convolution surface, by which the method's paper measures (supplement, appendix
/// D), and the union of round cones. Unless told otherwise, radii are estimated from the surface in the same way for
/// every skeleton, so that skeletons of all makers compete on geometry alone. O((n + f) log(n + f) + f e) for n points
/// or faces of the input, f faces of the reconstructions and e edges.
///
/// \tparam Surface a model of `FaceListGraph` of which all faces are triangles; or a range of points, or of what
///         `point_map` gives points for, a `CGAL::Point_set_3` included: then there are no measures of the position
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
///     \cgalParamDefault{`CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{resolution}
///     \cgalParamDescription{the number of cells along the diagonal of the bounding box, by which the reconstructed
///     surfaces are triangulated}
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
/// \return the measures; what is not defined for the input is `undefined_measure`
/// \throw Input_error if there is no surface or skeleton, they are far from each other, a coordinate is not finite, the
///        mesh is no oriented manifold of triangles, or the skeleton's radii are asked for and there are none
template <class Surface, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Skeleton_measures evaluate_skeleton(const Surface& surface, const Skeleton& skeleton,
                                    const NamedParameters& np = parameters::default_values())
{
  internal::check_evaluation_parameters<Surface, NamedParameters>();
  const auto measured = internal::measured_input(surface, np);
  using Measured = std::decay_t<decltype(*measured)>;
  const internal::Skeleton_evaluation<Measured> evaluation(*measured, internal::index_skeleton(skeleton),
                                                           internal::evaluation_parameters(np));
  Skeleton_measures result = evaluation.measure();
  if constexpr (std::is_same_v<Measured, internal::Measured_body>) {
    result.position = internal::Position_measurement(*measured, evaluation.skeleton())();
  }
  return result;
}

} // namespace CSCD

#endif // CSCD_MEASURE_EVALUATE_SKELETON_H
