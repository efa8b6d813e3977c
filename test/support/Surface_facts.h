// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The topology of a mesh, counted without any code of the library.

#ifndef CSCD_TEST_SUPPORT_SURFACE_FACTS_H
#define CSCD_TEST_SUPPORT_SURFACE_FACTS_H

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>

namespace CSCD::test {

/// Counts of a mesh.
struct Surface_facts
{
  std::size_t number_of_vertices = 0;          ///< vertices with a face
  std::size_t number_of_isolated_vertices = 0; ///< vertices without
  std::size_t number_of_components = 0;
  std::size_t number_of_border_cycles = 0;
  std::size_t genus = 0; ///< summed over the components, every border closed by a disc
};

template <class Mesh>
std::size_t count_border_cycles(const Mesh& mesh)
{
  const auto is_seen = get(CGAL::dynamic_halfedge_property_t<bool>(), mesh);
  for (const auto h : halfedges(mesh)) {
    put(is_seen, h, false);
  }
  std::size_t count = 0;
  for (const auto first : halfedges(mesh)) {
    if (!is_border(first, mesh) || get(is_seen, first)) {
      continue;
    }
    ++count;
    for (auto h = first; !get(is_seen, h); h = next(h, mesh)) {
      put(is_seen, h, true);
    }
  }
  return count;
}

/// \pre every face of `mesh` is a triangle, and every vertex that has faces has one fan of them
template <class Mesh>
Surface_facts surface_facts(const Mesh& mesh)
{
  Surface_facts facts;
  for (const auto v : vertices(mesh)) {
    const bool is_isolated = halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge();
    ++(is_isolated ? facts.number_of_isolated_vertices : facts.number_of_vertices);
  }
  const auto number_of_faces = std::size_t(std::distance(faces(mesh).begin(), faces(mesh).end()));
  const auto number_of_halfedges = std::size_t(std::distance(halfedges(mesh).begin(), halfedges(mesh).end()));
  const auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  facts.number_of_components = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  facts.number_of_border_cycles = count_border_cycles(mesh);
  // V - E + F = 2 C - 2 g for a closed surface; each border adds a face.
  const std::size_t vertices_and_faces = facts.number_of_vertices + number_of_faces + facts.number_of_border_cycles;
  facts.genus = (2 * facts.number_of_components + number_of_halfedges / 2 - vertices_and_faces) / 2;
  return facts;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SURFACE_FACTS_H
