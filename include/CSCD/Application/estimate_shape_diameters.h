// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How thick a body is at each vertex or face of its surface, from its skeleton.

#ifndef CSCD_APPLICATION_ESTIMATE_SHAPE_DIAMETERS_H
#define CSCD_APPLICATION_ESTIMATE_SHAPE_DIAMETERS_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// How often shape diameters are averaged with those around them, unless another number is given. Some steps level the
/// jumps between the vertices of neighboring nodes.
inline constexpr std::size_t default_number_of_diameter_smoothing_steps = 3;

namespace internal {

/// A surface, a skeleton in the same coordinates, and which node each vertex belongs to.
struct Skeletonized_surface
{
  Triangulated_surface surface; ///< without points that have no face
  CSCD::Skeleton skeleton;
  std::vector<Index> node;   ///< for each vertex of the surface
  std::vector<Index> number; ///< of each vertex among the points of the mesh
};

/// Faces and nodes keep their order, points without a face are left out. Linear.
/// \throw Input_error as `check_triangles()` does, or if a vertex with a face belongs to no node
inline Skeletonized_surface make_skeletonized_surface(Assigned_surface&& assigned, CSCD::Skeleton skeleton)
{
  Checked_triangles checked = check_triangles(std::move(assigned.points), std::move(assigned.triangles));
  Skeletonized_surface result{Triangulated_surface(std::move(checked.triangles), std::move(checked.pairing)),
                              std::move(skeleton),
                              {},
                              std::move(checked.input_number)};
  for (const Index number : result.number) {
    result.node.push_back(assigned.node_of_vertex[number]);
    if (result.node.back() == no_index) {
      throw Input_error("vertex " + std::to_string(number) +
                        " has a face and belongs to no node: use the skeleton of this mesh");
    }
  }
  return result;
}

/// Copies `mesh`, with the `vertex_point_map` of `np`, and `skeleton`; expectedly linear.
template <class TriangleMesh, class Skeleton, class NamedParameters>
Skeletonized_surface collect_skeletonized_surface(const TriangleMesh& mesh, const Skeleton& skeleton,
                                                  const NamedParameters& np)
{
  check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t>();
  check_triangle_mesh<TriangleMesh>();
  return make_skeletonized_surface(assigned_surface(mesh, skeleton, np), index_skeleton(skeleton));
}

/// Twice the distances of the points of a mesh from the parts of the skeleton that they belong to, smoothed; 0 for
/// vertices without a face. \param number of the points
std::vector<double> shape_diameters(const Skeletonized_surface& input, std::size_t number,
                                    std::size_t number_of_smoothing_steps);

/// The means of these over the corners of the faces.
std::vector<double> face_shape_diameters(const Skeletonized_surface& input, std::size_t number_of_smoothing_steps);

} // namespace internal

/// estimates the shape diameter at each vertex of a mesh: how thick the body is there.
///
/// It is twice the distance from the vertex to the part of the skeleton that it belongs to, which is its node and the
/// edges of that node, averaged along the surface: in each step, every vertex takes half of its own value and half of
/// the mean of its neighbors. Near linear. See the supplement of the method's paper, appendix I.1.
///
/// \tparam TriangleMesh a model of `FaceListGraph` whose faces are all triangles
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes list vertex descriptors of the mesh
/// \tparam VertexDiameterMap a model of `WritablePropertyMap` with vertex descriptors as keys and `double` as value
/// \param mesh an oriented manifold with or without borders
/// \param skeleton of `mesh`: each vertex with a face is in the list of a node
/// \param diameters gets the shape diameters, in the unit of the mesh; 0 for vertices without a face
/// \param np an optional sequence of named parameters
/// \param number_of_smoothing_steps how often to average
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if the mesh is not an oriented manifold of triangles, or `skeleton` is not its skeleton
template <class TriangleMesh, class Skeleton, class VertexDiameterMap,
          class NamedParameters = parameters::Default_named_parameters>
void estimate_vertex_shape_diameters(const TriangleMesh& mesh, const Skeleton& skeleton, VertexDiameterMap diameters,
                                     const NamedParameters& np = parameters::default_values(),
                                     std::size_t number_of_smoothing_steps = default_number_of_diameter_smoothing_steps)
{
  const std::vector<double> values = internal::shape_diameters(
      internal::collect_skeletonized_surface(mesh, skeleton, np), num_vertices(mesh), number_of_smoothing_steps);
  auto value = values.begin();
  for (const auto vertex : boost::make_iterator_range(vertices(mesh))) {
    put(diameters, vertex, *value++);
  }
}

/// estimates the shape diameter at each face of a mesh, the mean of those of its vertices: what
/// `CGAL::sdf_values_postprocessing()` and `CGAL::segmentation_from_sdf_values()` take. Parameters and errors are those
/// of `estimate_vertex_shape_diameters()`.
/// \tparam FaceDiameterMap a model of `WritablePropertyMap` with face descriptors as keys and `double` as value
/// \param diameters gets the shape diameters, in the unit of the mesh
template <class TriangleMesh, class Skeleton, class FaceDiameterMap,
          class NamedParameters = parameters::Default_named_parameters>
void estimate_face_shape_diameters(const TriangleMesh& mesh, const Skeleton& skeleton, FaceDiameterMap diameters,
                                   const NamedParameters& np = parameters::default_values(),
                                   std::size_t number_of_smoothing_steps = default_number_of_diameter_smoothing_steps)
{
  const std::vector<double> values = internal::face_shape_diameters(
      internal::collect_skeletonized_surface(mesh, skeleton, np), number_of_smoothing_steps);
  std::size_t number = 0;
  for (const auto face : boost::make_iterator_range(faces(mesh))) {
    put(diameters, face, values[number++]);
  }
}

} // namespace CSCD

#endif // CSCD_APPLICATION_ESTIMATE_SHAPE_DIAMETERS_H
