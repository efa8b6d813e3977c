// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of a source on a triangle mesh in one call.

#ifndef CSCD_EXTRACT_CUT_LOCUS_H
#define CSCD_EXTRACT_CUT_LOCUS_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Published/Cut_locus_extraction.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// The numbers of `sources` among the vertices with `descriptors`; linear in the size of `mesh`.
/// \throw Input_error if `sources` is empty, or one is not among them
template <class TriangleMesh, class VertexDescriptor>
std::vector<Index> find_sources(const TriangleMesh& mesh, const std::vector<VertexDescriptor>& descriptors,
                                const std::vector<VertexDescriptor>& sources)
{
  if (sources.empty()) {
    throw Input_error("there is no source: give at least one vertex");
  }
  const auto numbers = vertex_numbers(mesh, descriptors);
  std::vector<Index> result;
  for (const VertexDescriptor source : sources) {
    result.push_back(get(numbers, source));
    if (result.back() == no_index) {
      throw Input_error("a source has no faces: choose a vertex of the surface");
    }
  }
  return result;
}

} // namespace internal

/// extracts the cut locus of some vertices of a triangle mesh: the points of the surface with more than one shortest
/// path to the nearest source, and the ends of such curves.
///
/// As the practical method of the supplement (appendix G.1), on the intrinsic Delaunay triangulation of the mesh:
/// vertices are sought where the Laplacian of the distance is strongly negative and gradients run against each other;
/// they are joined along the ORG tree, the spanning tree that follows the ridges of the distance; loops around handles
/// are closed, so that on a closed connected surface of genus g the cut locus of one source has first Betti number 2 g,
/// and of k sources 2 g + k - 1; branches are made one vertex wide, and short ones dropped. It runs along edges of that
/// triangulation; on a sphere it is a point. Borders count as closed by discs. O(n log n) for n vertices, once the
/// distances are known.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Graph a `Cut_locus_graph` of the point type of the mesh and its `face_descriptor`
/// \param mesh a triangle mesh, open or closed, of any number of components; components without a source have no cut
///        locus
/// \param sources the vertices at distance 0; neighbors count as one source
/// \param cut_locus is cleared first; if the function throws, it is left as it was. It has a connected component for
///        each component of the mesh with a source, and the farthest point of that component is in it
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{distance_map}
///     \cgalParamDescription{the distances of the vertices of `mesh` from the sources, infinite without a path}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a number as value}
///     \cgalParamDefault{distances are estimated by the heat method}
///   \cgalParamNEnd
///   \cgalParamNBegin{laplacian_threshold}
///     \cgalParamDescription{at a cut point the Laplacian of the distance, times the spacing of the vertices, is not
///       greater; scale-free}
///     \cgalParamType{double}
///     \cgalParamDefault{-0.5}
///   \cgalParamNEnd
///   \cgalParamNBegin{angle_threshold}
///     \cgalParamDescription{at a cut point gradients around the vertex converge by this angle at least, in radians}
///     \cgalParamType{double}
///     \cgalParamDefault{pi / 3}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_branch_length}
///     \cgalParamDescription{shorter branches are dropped; relative to the distance of the farthest point}
///     \cgalParamType{double}
///     \cgalParamDefault{0.03}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if `mesh` is not an oriented manifold of triangles with finite coordinates, if `sources` is empty
///        or one has no faces, or if distances are missing; the message names the element and the remedy
template <class TriangleMesh, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_point_range_v<TriangleMesh>, int> = 0>
void extract_cut_locus(const TriangleMesh& mesh,
                       const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& sources,
                       Graph& cut_locus, const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t, internal_np::distance_map_t,
                                   internal_np::laplacian_threshold_t, internal_np::angle_threshold_t,
                                   internal_np::minimum_branch_length_t>();
  check_triangle_mesh<TriangleMesh>();
  auto collected = internal::collect_triangles(mesh, internal::vertex_point_map(mesh, np));
  const Normalization normalization = normalize_extent(collected.triangles.points);
  const std::vector<Index> source_numbers = internal::find_sources(mesh, collected.descriptors, sources);
  std::vector<double> distances;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::distance_map_t>::value) {
    const auto map = parameters::get_parameter(np, internal_np::distance_map);
    for (const auto vertex : collected.descriptors) {
      const double distance = CGAL::to_double(get(map, vertex)) / normalization.unit;
      distances.push_back(internal::checked_distance(distance, "vertex", distances.size()));
    }
  }
  const auto result = internal::extract_cut_locus_of_surface(
      std::move(collected.triangles), std::move(collected.pairing), source_numbers, std::move(distances),
      internal::cut_locus_settings(np, internal::Cut_locus_settings()));
  using Face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  const auto face_range = faces(mesh);
  const std::vector<Face_descriptor> face_descriptors(face_range.begin(), face_range.end());
  const auto to_input_location = [&face_descriptors](const std::pair<Index, std::array<double, 3>>& at) {
    const auto& [face, weights] = at;
    // Triangles are collected from the target of the face's halfedge on.
    return std::pair<Face_descriptor, std::array<double, 3>>(face_descriptors[face],
                                                             {weights[2], weights[0], weights[1]});
  };
  internal::write_cut_locus(result, normalization, to_input_location, cut_locus);
}

/// extracts the cut locus of the vertex `source`; as above.
template <class TriangleMesh, class Graph, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!is_point_range_v<TriangleMesh>, int> = 0>
void extract_cut_locus(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                       Graph& cut_locus, const NamedParameters& np = parameters::default_values())
{
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  extract_cut_locus(mesh, std::vector<Vertex_descriptor>{source}, cut_locus, np);
}

} // namespace CSCD

#endif // CSCD_EXTRACT_CUT_LOCUS_H
