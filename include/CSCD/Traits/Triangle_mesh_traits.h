// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of a triangle mesh, as the skeletonization sees it.

#ifndef CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H
#define CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H

#include <CSCD/Surface/compile_surface.h>
#include <CSCD/Traits/Triangulated_solid.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// The surface traits of a triangle mesh, a model of `SkeletonizationTraits` and of
/// `TriangulatedSolidSkeletonizationTraits`.
///
/// The mesh is checked, its borders are bridged by faces without weight, components that look inwards are turned, faces
/// that are too large are refined; the result is renumbered and normalized, so that it depends on the shape alone, and
/// compiled once into flat arrays. Sites are its vertices: those of the input that have a face, and inserted ones.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexPointMap a readable map from its vertices to points with coordinates `x()`, `y()`, `z()`, constructible
///         from three coordinates
template <class TriangleMesh,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class Triangle_mesh_traits
    : public internal::Compiled_surface_traits<typename boost::property_traits<VertexPointMap>::value_type>
{
  using Base = internal::Compiled_surface_traits<typename boost::property_traits<VertexPointMap>::value_type>;

public:
  /// \name Types
  /// @{

  /// The points of the input.
  using Point = typename Base::Point;
  /// The number of a site.
  using Index = typename Base::Index;
  /// What identifies a site of the input.
  using Input_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// @}

  /// Compiles `mesh`, which is not referred to later; near linear.
  /// \throw Input_error naming the element and the remedy if the mesh has no faces, faces that are no triangles, edges or
  ///        vertices where it is no oriented manifold, coordinates that are not finite, or no extent or area
  explicit Triangle_mesh_traits(const TriangleMesh& mesh, const VertexPointMap& point_map)
  {
    const auto start = std::chrono::steady_clock::now();
    compile(mesh, point_map);
    m_seconds_to_compile = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// The same, with the point map of `mesh`.
  explicit Triangle_mesh_traits(const TriangleMesh& mesh) : Triangle_mesh_traits(mesh, get(CGAL::vertex_point, mesh)) {}
  /// The descriptors of the sites would refer to a mesh that is gone.
  explicit Triangle_mesh_traits(TriangleMesh&&) = delete;
  Triangle_mesh_traits(TriangleMesh&&, const VertexPointMap&) = delete;

  Triangle_mesh_traits(const Triangle_mesh_traits&) = delete;
  Triangle_mesh_traits& operator=(const Triangle_mesh_traits&) = delete;
  ~Triangle_mesh_traits() = default;

  /// \name Sites of the input
  /// @{

  /// Whether the site is a vertex of the input, not an inserted one.
  bool is_input_vertex(Index site) const { return Base::input_point(site) != no_index; }
  /// The vertex of the input that the site is.
  /// \pre `is_input_vertex(site)`
  Input_descriptor descriptor(Index site) const
  {
    CGAL_precondition(is_input_vertex(site));
    return m_descriptors[Base::input_point(site)];
  }
  /// The vertices of the input for which the site stands: one, none for an inserted site.
  CGAL::Iterator_range<const Input_descriptor*> descriptors(Index site) const
  {
    const Input_descriptor* first = is_input_vertex(site) ? &m_descriptors[Base::input_point(site)] : nullptr;
    return {first, first == nullptr ? first : first + 1};
  }
  /// The number of sites for which `is_input_vertex()` holds.
  std::size_t number_of_input_vertices() const { return m_descriptors.size(); }
  /// The number of vertices without a face: they are no sites.
  std::size_t number_of_isolated_vertices() const { return m_number_of_isolated_vertices; }
  /// @}

  /// What is doubtful about the input or was mended, one sentence each.
  std::vector<std::string> warnings() const
  {
    std::vector<std::string> result;
    const auto warn = [&result](std::size_t count, const char* what) {
      if (count > 0) {
        result.push_back(std::to_string(count) + ' ' + what);
      }
    };
    warn(m_number_of_isolated_vertices, "vertices without a face: they belong to no node");
    warn(Base::number_of_bridged_borders(), "borders: bridged by faces without weight");
    warn(Base::number_of_degenerate_faces(), "faces with (nearly) no area");
    warn(Base::number_of_reversed_components(), "components that looked inwards: turned");
    return result;
  }

  /// The wall-clock seconds that the constructor took.
  double seconds_to_compile() const { return m_seconds_to_compile; }

private:
  void compile(const TriangleMesh& mesh, const VertexPointMap& point_map)
  {
    auto collected = internal::collect_triangles(mesh, point_map);
    auto compiled = internal::compile_surface(std::move(collected.triangles), std::move(collected.pairing));
    m_descriptors = std::move(collected.descriptors);
    m_number_of_isolated_vertices = collected.number_of_isolated_vertices;
    Base::set_surface(std::move(compiled));
  }

  std::vector<Input_descriptor> m_descriptors; // of the points of the input
  std::size_t m_number_of_isolated_vertices = 0;
  double m_seconds_to_compile = 0;
};

} // namespace CSCD

#endif // CSCD_TRAITS_TRIANGLE_MESH_TRAITS_H
