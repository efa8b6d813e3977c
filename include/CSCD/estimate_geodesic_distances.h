// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances on a triangle mesh: in one call, or prepared once and estimated from many sources.

#ifndef CSCD_ESTIMATE_GEODESIC_DISTANCES_H
#define CSCD_ESTIMATE_GEODESIC_DISTANCES_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Published/Prepared_distances.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// Geodesic distances on a triangle mesh by the heat method (K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in
/// heat", 2013) on its intrinsic Delaunay triangulation. The mesh is prepared once; then every set of sources costs two
/// pairs of triangular solves, and eight sets together as much as three alone.
///
/// An estimate is exact to a few tenths of the mean edge length where the surface is smooth, and rounded off over two
/// or three edges where shortest paths from different sides meet; doc/results.md has figures. Distances of any number
/// of edges are right.
/// The members that estimate are const and may be called by several threads at once.
/// \tparam TriangleMesh a model of `FaceListGraph`
template <class TriangleMesh>
class Geodesic_distance_estimator
{
public:
  /// \name Types
  /// @{

  /// The vertices of the mesh.
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// The faces of the mesh.
  using Face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// A point of a face by barycentric coordinates, as in CGAL's package Polygon Mesh Processing: the coordinates of the
  /// source and the target of `halfedge(face, mesh)`, and of the third vertex.
  using Face_location = std::pair<Face_descriptor, std::array<double, 3>>;
  /// @}

  /// Prepares `mesh`, open or closed, of any number of components; O(n^1.5), and usually nearly linear.
  /// The mesh is referred to, and must not be changed while this object is used.
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{the points of the vertices of `mesh`}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
  ///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{time_step_factor}
  ///     \cgalParamDescription{the time of heat flow in squared mean edge lengths: longer is smoother and less exact}
  ///     \cgalParamType{double, positive}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throw Input_error naming the element and the remedy if the mesh has no faces, faces that are not triangles, edges
  ///        or vertices where it is not an oriented manifold, or coordinates that are not finite, or if its triangles
  ///        are too uneven for the computation
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_distance_estimator(const TriangleMesh& mesh,
                                       const NamedParameters& np = parameters::default_values())
      : Geodesic_distance_estimator(
            mesh, internal::collect_triangles(mesh, internal::vertex_point_map(mesh, np)),
            double(parameters::choose_parameter(parameters::get_parameter(np, internal_np::time_step_factor), 1.)))
  {
    internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                     internal_np::time_step_factor_t>();
  }
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_distance_estimator(TriangleMesh&&, const NamedParameters& = parameters::default_values()) = delete;

  /// Writes the distance of every vertex from the nearest one of `sources` to `distances`: 0 for sources, infinity for
  /// vertices that no path joins to a source.
  /// \param sources a range of vertices or of `Face_location`s
  /// \param distances a model of `WritablePropertyMap` with the vertex descriptor as key and a value assignable from
  ///        `double`
  /// \throw Input_error if a `Face_location` has coordinates that are not finite, are negative, or have not the sum 1
  template <class SourceRange, class VertexDistanceMap>
  void estimate(const SourceRange& sources, VertexDistanceMap distances) const
  {
    m_distances.estimate_each({collect_sources(sources)},
                              [&](const std::vector<double>& field) { write(sources, field, distances); });
  }

  /// Writes the distances from each of `source_sets` by itself to the one of `distance_maps` with the same number:
  /// exactly the values that one call of `estimate()` for each of them writes, in about a third of the time.
  /// \param source_sets a range of ranges of vertices or of `Face_location`s
  /// \param distance_maps a range of maps
  /// \pre there are as many maps as sets
  /// \throw Input_error as `estimate()`, before anything is written
  template <class SourceSetRange, class DistanceMapRange>
  void estimate_each(const SourceSetRange& source_sets, const DistanceMapRange& distance_maps) const
  {
    std::vector<std::vector<internal::Distance_source>> collected;
    for (const auto& sources : source_sets) {
      collected.push_back(collect_sources(sources));
    }
    CGAL_precondition(collected.size() ==
                      std::size_t(std::distance(std::begin(distance_maps), std::end(distance_maps))));
    auto sources = std::begin(source_sets);
    auto map = std::begin(distance_maps);
    m_distances.estimate_each(collected, [&](const std::vector<double>& field) { write(*sources++, field, *map++); });
  }

private:
  using Vertex_number_map =
      typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Index>>::const_type;
  using Face_number_map = typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<Index>>::const_type;
  using Collected_triangles = internal::Collected_triangles<Vertex_descriptor>;

  Geodesic_distance_estimator(const TriangleMesh& mesh, Collected_triangles&& collected, double time_step_factor)
      : m_mesh(&mesh), m_vertex_numbers(internal::vertex_numbers(mesh, collected.descriptors)),
        m_face_numbers(get(CGAL::dynamic_face_property_t<Index>(), mesh)),
        m_normalization(normalize_extent(collected.triangles.points)),
        m_distances(std::move(collected.triangles), std::move(collected.pairing), time_step_factor)
  {
    CGAL_precondition(time_step_factor > 0);
    Index number_of_faces = 0;
    for (const Face_descriptor face : faces(mesh)) {
      put(m_face_numbers, face, number_of_faces++);
    }
  }

  template <class SourceRange>
  std::vector<internal::Distance_source> collect_sources(const SourceRange& sources) const
  {
    std::vector<internal::Distance_source> result;
    for (const auto& source : sources) {
      if constexpr (std::is_convertible_v<decltype(source), Vertex_descriptor>) {
        const Index vertex = get(m_vertex_numbers, Vertex_descriptor(source));
        if (vertex != no_index) {
          result.push_back({vertex, no_index, {}});
        }
      } else {
        const Face_location& location = source;
        check(location);
        // Triangles are collected from the target of the face's halfedge on.
        result.push_back({no_index,
                          get(m_face_numbers, location.first),
                          {location.second[1], location.second[2], location.second[0]}});
      }
    }
    return result;
  }

  static void check(const Face_location& location)
  {
    // More than rounding, less than an error in a typed number.
    constexpr double tolerance = 1e-6;
    const auto [a, b, c] = location.second;
    if (!(std::min({a, b, c}) >= -tolerance && std::fabs(a + b + c - 1) <= tolerance)) {
      throw Input_error("a source has barycentric coordinates that are negative or whose sum is not 1: correct them");
    }
  }

  template <class SourceRange, class VertexDistanceMap>
  void write(const SourceRange& sources, const std::vector<double>& field, VertexDistanceMap distances) const
  {
    for (const Vertex_descriptor vertex : vertices(*m_mesh)) {
      const Index i = get(m_vertex_numbers, vertex);
      put(distances, vertex,
          i == no_index ? std::numeric_limits<double>::infinity() : m_normalization.unit * std::max(field[i], 0.));
    }
    if constexpr (std::is_convertible_v<decltype(*std::begin(sources)), Vertex_descriptor>) {
      for (const Vertex_descriptor source : sources) {
        // Also a vertex without a face.
        put(distances, source, 0.);
      }
    }
  }

  const TriangleMesh* m_mesh;
  Vertex_number_map m_vertex_numbers; // `no_index` for a vertex without a face
  Face_number_map m_face_numbers;
  Normalization m_normalization;
  internal::Prepared_distances m_distances;
};

/// estimates the geodesic distance of every vertex of a triangle mesh from the nearest one of some sources.
///
/// The accuracy is that of `Geodesic_distance_estimator`. Use that class for distances from several sets of sources:
/// nearly all the time of this function goes into preparing the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Sources a vertex descriptor, a `Geodesic_distance_estimator<TriangleMesh>::Face_location`, or a range of
///         either
/// \tparam VertexDistanceMap a model of `WritablePropertyMap` with the vertex descriptor as key and a value assignable
///         from `double`
/// \param mesh a triangle mesh, open or closed, of any number of components
/// \param sources the vertices or points of faces at distance 0
/// \param distances gets 0 for sources, infinity for vertices that no path joins to a source; if the function throws,
///        it is left as it was
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

#endif // CSCD_ESTIMATE_GEODESIC_DISTANCES_H
