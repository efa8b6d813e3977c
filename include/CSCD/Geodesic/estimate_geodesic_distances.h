// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances on a triangle mesh in one call.

#ifndef CSCD_GEODESIC_ESTIMATE_GEODESIC_DISTANCES_H
#define CSCD_GEODESIC_ESTIMATE_GEODESIC_DISTANCES_H

#include <CSCD/Geodesic/Geodesic_distance_estimator.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Traits/input_concepts.h>

#include <array>
#include <type_traits>

namespace CSCD {

/// estimates the geodesic distance of every vertex of a triangle mesh from the nearest one of some sources.
///
/// What is said of accuracy in `Geodesic_distance_estimator` holds; to ask for distances from other sources too, use
/// that class: nearly all the time of this function goes into preparing the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Sources a vertex descriptor, a `Geodesic_distance_estimator<TriangleMesh>::Face_location`, or a range of
///         either
/// \tparam VertexDistanceMap a model of `WritablePropertyMap` with the vertex descriptor as key, to which `double` can
///         be written
/// \param mesh a triangle mesh, open or closed, of any number of components
/// \param sources what distance is measured from
/// \param distances gets 0 for vertices that are sources, infinity for those that no path joins to a source; if the
///        function throws, it is left as it was
/// \param np an optional sequence of named parameters: `vertex_point_map` and `time_step_factor`, as
///        `Geodesic_distance_estimator` has them
/// \throw Input_error if `mesh` cannot be computed with, or a source is not in its face; the message names the element
///        and the remedy
template <class TriangleMesh, class Sources, class VertexDistanceMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_point_range_v<TriangleMesh>, int> = 0>
void estimate_geodesic_distances(const TriangleMesh& mesh, const Sources& sources, VertexDistanceMap distances,
                                 const NamedParameters& np = parameters::default_values())
{
  using Estimator = Geodesic_distance_estimator<TriangleMesh>;
  const Estimator estimator(mesh, np);
  if constexpr (std::is_convertible_v<const Sources&, typename Estimator::Vertex_descriptor>) {
    estimator.estimate(std::array<typename Estimator::Vertex_descriptor, 1>{sources}, distances);
  } else if constexpr (std::is_convertible_v<const Sources&, typename Estimator::Face_location>) {
    estimator.estimate(std::array<typename Estimator::Face_location, 1>{sources}, distances);
  } else {
    estimator.estimate(sources, distances);
  }
}

} // namespace CSCD

#endif // CSCD_GEODESIC_ESTIMATE_GEODESIC_DISTANCES_H
