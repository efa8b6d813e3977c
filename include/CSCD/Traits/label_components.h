// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers the connected components of a surface.

#ifndef CSCD_TRAITS_LABEL_COMPONENTS_H
#define CSCD_TRAITS_LABEL_COMPONENTS_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// The component of every face.
struct Face_components
{
  std::vector<Index> component; ///< of every face, in the order of the components' first faces
  Index number = 0;             ///< of components
};

/// Numbers the components of faces that are connected through edges; linear.
inline Face_components label_components(const Halfedge_pairing& pairing)
{
  const Index number_of_faces = pairing.number_of_halfedges() / 3;
  Face_components result{std::vector<Index>(number_of_faces, no_index), 0};
  std::vector<Index> stack;
  for (Index seed = 0; seed < number_of_faces; ++seed) {
    if (result.component[seed] != no_index) {
      continue;
    }
    result.component[seed] = result.number;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index face = stack.back();
      stack.pop_back();
      for (Index halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge) {
        const Index twin = pairing.twin(halfedge);
        if (twin != no_index && result.component[twin / 3] == no_index) {
          result.component[twin / 3] = result.number;
          stack.push_back(twin / 3);
        }
      }
    }
    ++result.number;
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_LABEL_COMPONENTS_H
