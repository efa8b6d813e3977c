// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of a triangle mesh, as the skeletonization sees it.

#ifndef CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H
#define CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H

#include <CSCD/Options.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/Surface_adapter.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <utility>

namespace CSCD {

/// The adapter of a triangle mesh to a `Triangulated_solid`; a model of `SkeletonizationTraits`.
///
/// The mesh is checked, its borders are bridged by faces without weight or are rims of sheets, components that are
/// oriented inwards are cavities, which are filled, if they lie in a body, and reversed otherwise, faces that are too
/// large are refined; the result is renumbered and normalized, so that it depends on the shape alone. Its vertices are
/// the vertices of the input that have a face, and inserted ones. Vertices of cavities belong to the nearest.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexPointMap a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`,
///         constructible from three coordinates
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class Triangle_mesh_traits
    : public Surface_adapter<Triangulated_solid, typename boost::property_traits<VertexPointMap>::value_type,
                             typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
{
public:
  /// Compiles `mesh`, which is not referred to later; near linear.
  /// \param treatment which borders are bridged, and which are rims of sheets
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  /// \throw Input_error naming the element and the remedy if the mesh has no faces, faces that are not triangles, edges
  ///        or vertices where it is not an oriented manifold, coordinates that are not finite, or no extent or area
  explicit Triangle_mesh_traits(const TriangleMesh& mesh, const VertexPointMap& point_map,
                                Border_treatment treatment = Border_treatment::automatic,
                                unsigned number_of_threads = 1)
  {
    auto arrays = internal::read_mesh(mesh, point_map);
    this->m_surface.emplace(std::move(arrays.points), std::move(arrays.faces), treatment, number_of_threads);
    this->describe_solid([&](Index number) { return arrays.descriptors[number]; });
  }
  /// Compiles a mesh that need not exist: that of `triangles`, whose vertices are constructed from the numbers of the
  /// points, as in a `CGAL::Surface_mesh`. This takes less than half of the memory. Otherwise as above.
  /// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
  explicit Triangle_mesh_traits(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                Border_treatment treatment = Border_treatment::automatic,
                                unsigned number_of_threads = 1)
  {
    this->m_surface.emplace(std::move(triangles), std::move(pairing), treatment, number_of_threads);
    this->describe_solid([](Index number) { return typename Triangle_mesh_traits::Input_descriptor(number); });
  }
  /// The same, with the point map of `mesh`.
  explicit Triangle_mesh_traits(const TriangleMesh& mesh) : Triangle_mesh_traits(mesh, get(CGAL::vertex_point, mesh)) {}
  /// A temporary mesh is refused: the descriptors would refer to it.
  explicit Triangle_mesh_traits(TriangleMesh&&) = delete;
  Triangle_mesh_traits(TriangleMesh&&, const VertexPointMap&) = delete;
};

} // namespace CSCD

#endif // CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H
