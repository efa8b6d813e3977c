// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts that people see in a body, from its skeleton.

#ifndef CSCD_APPLICATION_SEGMENT_MESH_H
#define CSCD_APPLICATION_SEGMENT_MESH_H

#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Vector3.h>

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD {
namespace internal {

/// The part of each face, numbered in the order of their first faces; see `segment_mesh()`.
std::vector<Index> segment_surface(const Skeletonized_surface& input, std::size_t number_of_parts);

} // namespace internal

/// segments a mesh into the parts that people would see, by its skeleton.
///
/// The surface is first cut into slices, one for each node of the skeleton. Then neighboring parts are merged, pair by
/// pair, the most probable pair first. The probability depends on the length and concavity of their boundary, the
/// thicknesses and sizes on both sides, and the course of the skeleton across it. It is a logistic function that was
/// fitted to segmentations by people; see `doc/applications.md`. Expectedly near linear in the number of faces, and
/// O(s^2 log s) in the number s of nodes.
///
/// \tparam TriangleMesh a model of `FaceListGraph` whose faces are all triangles
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes list vertex descriptors of the mesh
/// \tparam FaceLabelMap a model of `WritablePropertyMap` with face descriptors as keys and `std::size_t` as value
/// \param mesh an oriented manifold with or without borders
/// \param skeleton of `mesh`: each vertex with a face is in the list of a node
/// \param labels gets the numbers of the parts, from 0
/// \param np an optional sequence of named parameters
/// \param number_of_parts how many parts there should be; 0 lets the shape decide. There are at least as many as the
///        mesh has components, and at most as many as slices. Fewer parts are unions of more parts.
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the number of parts
/// \throw Input_error if the mesh is not an oriented manifold of triangles, or `skeleton` is not its skeleton
template <class TriangleMesh, class Skeleton, class FaceLabelMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t segment_mesh(const TriangleMesh& mesh, const Skeleton& skeleton, FaceLabelMap labels,
                         const NamedParameters& np = parameters::default_values(), std::size_t number_of_parts = 0)
{
  const std::vector<Index> parts =
      internal::segment_surface(internal::collect_skeletonized_surface(mesh, skeleton, np), number_of_parts);
  std::size_t number = 0;
  for (const auto face : boost::make_iterator_range(faces(mesh))) {
    put(labels, face, std::size_t(parts[number++]));
  }
  return std::size_t(*std::max_element(parts.begin(), parts.end())) + 1;
}

} // namespace CSCD

#endif // CSCD_APPLICATION_SEGMENT_MESH_H
