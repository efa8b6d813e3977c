// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes simplicial what consists of two triangles with the same corners.

#ifndef CSCD_TRAITS_SPLIT_PILLOWS_H
#define CSCD_TRAITS_SPLIT_PILLOWS_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/Surface_components.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Splits the second face of every component of two faces at its centre. Such a pillow is what a single triangle
/// becomes when its border is bridged; refined as it is, it would get several edges between the same vertices. Linear.
/// \return the number of inserted vertices
/// \pre `triangles` is closed; `pairing` and `components` are those of its faces, and are kept so
inline std::size_t split_pillows(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                 Surface_components& components)
{
  std::vector<Index> number_of_faces(components.number(), 0);
  for (Index component : components.component) {
    ++number_of_faces[component];
  }
  if (std::find(number_of_faces.begin(), number_of_faces.end(), Index(2)) == number_of_faces.end()) {
    return 0;
  }
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> component_of_face;
  std::vector<char> is_visited(components.number(), 0);
  const std::size_t number_of_points = triangles.points.size();
  std::size_t first_bridging_face = 0;
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    const auto [a, b, c] = triangles.faces[f];
    const Index component = components.component[f];
    if (number_of_faces[component] == 2 && is_visited[component]) {
      const Index center = Index(triangles.points.size());
      triangles.points.push_back((triangles.points[a] + triangles.points[b] + triangles.points[c]) / 3);
      faces.insert(faces.end(), {{a, b, center}, {b, c, center}, {c, a, center}});
    } else {
      faces.push_back(triangles.faces[f]);
    }
    is_visited[component] = 1;
    component_of_face.resize(faces.size(), component);
    first_bridging_face = f < triangles.first_bridging_face ? faces.size() : first_bridging_face;
  }
  triangles.faces = std::move(faces);
  triangles.first_bridging_face = first_bridging_face;
  components.component = std::move(component_of_face);
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  return triangles.points.size() - number_of_points;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_SPLIT_PILLOWS_H
