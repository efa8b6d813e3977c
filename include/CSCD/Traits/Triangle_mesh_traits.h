// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of a triangle mesh, as the skeletonization sees it.

#ifndef CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H
#define CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace CSCD {

/// The adapter of a triangle mesh to a `Triangulated_solid`; a model of `SkeletonizationTraits`.
///
/// The mesh is checked, its borders are bridged by faces without weight or are rims of sheets, components that are
/// oriented inwards are cavities, which are filled, if they lie in a body, and reversed otherwise, faces that are too
/// large are refined; the result is renumbered and normalized, so that it depends on the shape alone. Its vertices are
/// the vertices of the input that have a face, and inserted ones. \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexPointMap a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`,
///         constructible from three coordinates
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class Triangle_mesh_traits
{
public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  /// The identifier of a vertex of the input.
  using Input_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// The surface that the pipeline runs on.
  using Surface = Triangulated_solid;
  /// @}

  /// Compiles `mesh`, which is not referred to later; near linear.
  /// \param treatment which borders are bridged, and which are rims of sheets
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  /// \throw Input_error naming the element and the remedy if the mesh has no faces, faces that are not triangles, edges
  ///        or vertices where it is not an oriented manifold, coordinates that are not finite, or no extent or area
  explicit Triangle_mesh_traits(const TriangleMesh& mesh, const VertexPointMap& point_map,
                                Border_treatment treatment = Border_treatment::bridge, unsigned number_of_threads = 1)
  {
    auto arrays = internal::read_mesh(mesh, point_map);
    m_solid.emplace(std::move(arrays.points), std::move(arrays.faces), treatment, number_of_threads);
    sort(arrays.descriptors);
  }
  /// Compiles a mesh that need not exist: that of `triangles`, whose vertices are constructed from the numbers of the
  /// points, as in a `CGAL::Surface_mesh`. This takes less than half of the memory. Otherwise as above.
  /// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
  explicit Triangle_mesh_traits(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                Border_treatment treatment = Border_treatment::bridge, unsigned number_of_threads = 1)
  {
    std::vector<Input_descriptor> descriptors;
    descriptors.reserve(triangles.points.size());
    for (Index vertex = 0; vertex < triangles.points.size(); ++vertex) {
      descriptors.emplace_back(vertex);
    }
    m_solid.emplace(std::move(triangles), std::move(pairing), treatment, number_of_threads);
    sort(descriptors);
  }
  /// The same, with the point map of `mesh`.
  explicit Triangle_mesh_traits(const TriangleMesh& mesh) : Triangle_mesh_traits(mesh, get(CGAL::vertex_point, mesh)) {}
  /// A temporary mesh is refused: the descriptors would refer to it.
  explicit Triangle_mesh_traits(TriangleMesh&&) = delete;
  Triangle_mesh_traits(TriangleMesh&&, const VertexPointMap&) = delete;

  /// The surface of the mesh.
  const Triangulated_solid& surface() const { return *m_solid; }

  /// \name Back to the input
  /// @{

  /// The vertices of the input that belong to `vertex`: its own, unless it was inserted, and vertices of cavities that
  /// are nearest to it.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index vertex) const { return m_rows[vertex]; }
  /// A point of the surface in the coordinates of the input.
  Point to_input_point(const Vector3& point) const
  {
    return CSCD::to_input_point<Point>(surface().normalization(), point);
  }
  /// A length on the surface in the unit of the input.
  double to_input_length(double length) const { return length * surface().normalization().unit; }
  /// Describes the input in `report`.
  void describe_input(Skeletonization_report& report) const { report = m_solid->report(); }
  /// @}

private:
  /// Sorts the vertices of the input by their vertices of the surface.
  void sort(const std::vector<Input_descriptor>& descriptors)
  {
    const Index n = surface().triangulation().number_of_vertices();
    m_rows = internal::Compressed_rows<Input_descriptor>(n, [&](const auto& add) {
      for (Index vertex = 0; vertex < n; ++vertex) {
        for (const Index input : m_solid->input_vertices(vertex)) {
          add(vertex, descriptors[input]);
        }
      }
    });
  }

  std::optional<Triangulated_solid> m_solid;
  internal::Compressed_rows<Input_descriptor> m_rows; // by vertices of the surface
};

} // namespace CSCD

#endif // CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H
