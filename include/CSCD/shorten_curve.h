// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesics on a triangle mesh from curves along its edges, in one call.

#ifndef CSCD_SHORTEN_CURVE_H
#define CSCD_SHORTEN_CURVE_H

#include <CSCD/Separator/Edge_flip_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/bridge_borders.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// The halfedges between consecutive `vertices` of a curve, each given by its number on `surface`.
/// \throw Input_error if two of them are not neighbors; the message counts them
inline std::vector<Index> halfedges_between(const Triangulated_surface& surface, const std::vector<Index>& vertices,
                                            bool is_closed)
{
  std::vector<Index> halfedges;
  const std::size_t size = vertices.size();
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < size; ++i) {
    const Index target = vertices[i + 1 < size ? i + 1 : 0];
    const Index h = vertices[i] == no_index ? no_index : surface.find_halfedge(vertices[i], target);
    const auto is_hole_filling = [&surface](Index side) { return surface.is_hole_filling(Triangulated_surface::face(side)); };
    if (h == no_index || (is_hole_filling(h) && is_hole_filling(surface.twin(h)))) {
      throw Input_error("vertex " + std::to_string(i) +
                        " of the curve has no edge to the next one: give a curve along edges");
    }
    halfedges.push_back(h);
  }
  return halfedges;
}

} // namespace internal

/// shortens a curve along the edges of a triangle mesh to a geodesic that runs over its faces.
///
/// The geodesic is one into which the curve can be moved without getting longer: locally, it is the shortest way. It
/// passes straight over edges, may turn at saddle vertices, and goes along borders where these are in the way. A closed
/// curve that nothing holds shrinks to a point. Linear in the size of the mesh, which is converted, plus the number of
/// faces that the curve sweeps; to shorten many curves of one mesh, use `internal::Edge_flip_shortening`.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexRange a range of its vertex descriptors
/// \tparam PointOutputIterator an output iterator of the points of the mesh, constructible from three coordinates
/// \param mesh a triangle mesh, open or closed
/// \param vertices those of the curve, in order, each joined to the next by an edge
/// \param is_closed whether the last vertex leads to the first one; else both stay where they are
/// \param points takes the points of the geodesic, one on each edge or vertex that it meets; nothing if it collapses
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what has become of the curve: `held` does not occur
/// \pre the curve does not cross itself, and runs along no edge twice, except straight back
/// \throw Input_error if `mesh` is no oriented manifold of triangles, or has a coordinate that is not finite, or if
///        consecutive vertices have no common edge; the message names the element
template <class TriangleMesh, class VertexRange, class PointOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Shortening_outcome shorten_curve(const TriangleMesh& mesh, const VertexRange& vertices, bool is_closed,
                                 PointOutputIterator points,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const auto point_map = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
  auto collected = internal::collect_triangles(mesh, point_map);
  internal::bridge_borders(collected.triangles, collected.pairing);
  const Triangulated_surface surface(std::move(collected.triangles));
  CGAL_assertion(!surface.defect());

  boost::unordered_map<Vertex_descriptor, Index> number_of;
  for (std::size_t i = 0; i < collected.descriptors.size(); ++i) {
    number_of.emplace(collected.descriptors[i], Index(i));
  }
  std::vector<Index> numbers;
  for (const Vertex_descriptor vertex : vertices) {
    const auto found = number_of.find(vertex);
    numbers.push_back(found == number_of.end() ? no_index : found->second);
  }
  const std::vector<Index> halfedges = internal::halfedges_between(surface, numbers, is_closed);
  internal::Edge_flip_shortening<Triangulated_surface> shorten(surface, surface.first_hole_filling_face());
  internal::Surface_path path;
  const Shortening_outcome outcome = shorten(halfedges, is_closed, path);
  for (const Edge_crossing& crossing : path.points) {
    const Vector_3 point = internal::crossing_point(surface, crossing);
    *points++ = Point(Coordinate(point.x()), Coordinate(point.y()), Coordinate(point.z()));
  }
  return outcome;
}

} // namespace CSCD

#endif // CSCD_SHORTEN_CURVE_H
