// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesics on a triangle mesh from curves along its edges, in one call.

#ifndef CSCD_SHORTEN_CURVE_H
#define CSCD_SHORTEN_CURVE_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

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
    const auto is_hole_filling = [&surface](Index side) {
      return surface.is_hole_filling(Triangulated_surface::face(side));
    };
    if (h == no_index || (is_hole_filling(h) && is_hole_filling(surface.twin(h)))) {
      throw Input_error("vertex " + std::to_string(i) +
                        " of the curve has no edge to the next one: give a curve along edges");
    }
    halfedges.push_back(h);
  }
  return halfedges;
}

} // namespace internal

/// Shortens curves along the edges of a triangle mesh to geodesics that run over its faces. The mesh is converted once;
/// then a curve takes time in proportion to the number of faces that it sweeps.
///
/// The geodesic is one that the curve can be moved into without getting longer: locally, it is the shortest path. It
/// passes straight over edges, may turn at saddle vertices, and goes along borders where these are in the way. A closed
/// curve that nothing holds shrinks to a point.
/// \tparam TriangleMesh a model of `FaceListGraph`
template <class TriangleMesh>
class Curve_shortening
{
public:
  /// The vertices of the mesh.
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// Converts `mesh`, open or closed, which must not be changed while this object is used; linear.
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
  /// \throw Input_error if `mesh` is not an oriented manifold of triangles, or has a coordinate that is not finite; the
  ///        message names the element
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Curve_shortening(const TriangleMesh& mesh, const NamedParameters& np = parameters::default_values())
      : Curve_shortening(mesh, internal::collect_triangles(mesh, internal::vertex_point_map(mesh, np)))
  {
    internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t>();
  }
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Curve_shortening(TriangleMesh&&, const NamedParameters& = parameters::default_values()) = delete;

  Curve_shortening(const Curve_shortening&) = delete;
  Curve_shortening& operator=(const Curve_shortening&) = delete;

  /// Shortens one curve.
  /// \tparam Point a point type, constructible from three coordinates
  /// \tparam VertexRange a range of vertex descriptors
  /// \tparam PointOutputIterator an output iterator of `Point`
  /// \param vertices the vertices of the curve, in order, each joined to the next by an edge
  /// \param is_closed whether the last vertex leads to the first one; else both stay where they are
  /// \param points gets the points of the geodesic, one on each edge or vertex that it meets; nothing if it collapses
  /// \return the outcome for the curve: `held` does not occur
  /// \pre the curve does not cross itself, and runs along no edge twice, except straight back
  /// \throw Input_error if consecutive vertices have no common edge; the message names the vertex
  template <class Point, class VertexRange, class PointOutputIterator>
  Shortening_outcome shorten(const VertexRange& vertices, bool is_closed, PointOutputIterator points)
  {
    std::vector<Index> numbers;
    for (const Vertex_descriptor vertex : vertices) {
      numbers.push_back(get(m_numbers, vertex));
    }
    internal::Surface_path path;
    const Shortening_outcome outcome =
        m_shorten(internal::halfedges_between(m_surface, numbers, is_closed), is_closed, path);
    for (const Edge_crossing& crossing : path.points) {
      *points++ = internal::make_point<Point>(internal::crossing_point(m_surface, crossing));
    }
    return outcome;
  }

private:
  using Collected_triangles = internal::Collected_triangles<Vertex_descriptor>;
  using Vertex_number_map =
      typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Index>>::const_type;

  Curve_shortening(const TriangleMesh& mesh, Collected_triangles&& collected)
      : m_numbers(internal::vertex_numbers(mesh, collected.descriptors)), m_surface(closed(collected)),
        m_shorten(internal::Intrinsic_triangulation(m_surface, m_surface.first_hole_filling_face()),
                  m_surface.first_hole_filling_face())
  {
  }

  static Triangulated_surface closed(Collected_triangles& collected)
  {
    internal::bridge_borders(collected.triangles, collected.pairing);
    Triangulated_surface surface(std::move(collected.triangles));
    CGAL_postcondition(!surface.has_defect());
    return surface;
  }

  Vertex_number_map m_numbers; // `no_index` for a vertex without a face
  Triangulated_surface m_surface;
  internal::Edge_flip_shortening m_shorten;
};

/// shortens a curve along the edges of a triangle mesh to a geodesic that runs over its faces, see `Curve_shortening`,
/// which takes less time for several curves of one mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexRange a range of its vertex descriptors
/// \tparam PointOutputIterator an output iterator of the points of the mesh, constructible from three coordinates
/// \param mesh a triangle mesh, open or closed
/// \param vertices, is_closed, points as for `Curve_shortening::shorten()`
/// \param np an optional sequence of named parameters: `vertex_point_map`, as `Curve_shortening` has it
/// \return the outcome for the curve: `held` does not occur
/// \pre the curve does not cross itself, and runs along no edge twice, except straight back
/// \throw Input_error as `Curve_shortening` and its member `shorten()`
template <class TriangleMesh, class VertexRange, class PointOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
Shortening_outcome shorten_curve(const TriangleMesh& mesh, const VertexRange& vertices, bool is_closed,
                                 PointOutputIterator points, const NamedParameters& np = parameters::default_values())
{
  using Point_map = std::decay_t<decltype(internal::vertex_point_map(mesh, np))>;
  using Point = typename boost::property_traits<Point_map>::value_type;
  return Curve_shortening<TriangleMesh>(mesh, np).template shorten<Point>(vertices, is_closed, points);
}

} // namespace CSCD

#endif // CSCD_SHORTEN_CURVE_H
