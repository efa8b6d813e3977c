// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface that a skeleton describes, as a mesh.

#ifndef CSCD_MEASURE_RECONSTRUCT_SURFACE_H
#define CSCD_MEASURE_RECONSTRUCT_SURFACE_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace CSCD {

/// reconstructs a surface from a skeleton: the one that `evaluate_skeleton()` measures.
///
/// It is closed and oriented, in the coordinates of `surface`, and may cut through itself nowhere; limbs too thin for
/// the resolution are missing. O(n log n + f e) for n points or faces of the input, f faces of the result and e edges.
///
/// \tparam Surface see `evaluate_skeleton()`
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point map, which can be moved
/// \param surface gives coordinates and radii
/// \param skeleton in the coordinates of `surface`
/// \param reconstruction is replaced; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters: those of `evaluate_skeleton()` and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{reconstruction_method}
///     \cgalParamDescription{how a surface is made of a skeleton}
///     \cgalParamType{`Reconstruction_method`}
///     \cgalParamDefault{`Reconstruction_method::convolution`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error where `evaluate_skeleton()` does
template <class Surface, class Skeleton, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters>
void reconstruct_surface(const Surface& surface, const Skeleton& skeleton, TriangleMesh& reconstruction,
                         const NamedParameters& np = parameters::default_values())
{
  using Vertex_point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Vertex_point_map>::value_type;
  internal::check_evaluation_parameters<Surface, NamedParameters, internal_np::reconstruction_method_t>();
  const Reconstruction_method method = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::reconstruction_method), Reconstruction_method::convolution);
  const Indexed_triangles triangles =
      internal::reconstruct_surface(internal::measured_input(surface, np), internal::index_skeleton(skeleton),
                                    internal::evaluation_parameters(np), method);
  std::vector<Point> points;
  points.reserve(triangles.points.size());
  for (const Vector_3& p : triangles.points) {
    points.push_back(internal::make_point<Point>(p));
  }
  TriangleMesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles.faces, mesh);
  reconstruction = std::move(mesh);
}

} // namespace CSCD

#endif // CSCD_MEASURE_RECONSTRUCT_SURFACE_H
