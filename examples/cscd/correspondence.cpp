// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which node the vertices of the input belong to.

#include "correspondence.h"

#include "types.h"
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Vector_3.h>

#include <vector>

namespace cscd {

std::vector<CSCD::Vertex_label> labels_of_file(const Input& input, const Skeletonization_result& result)
{
  std::vector<CSCD::Vertex_label> labels = CSCD::label_vertices(input.mesh, result.skeleton, result.branches);
  if (input.is_point_set) { // its points are the first vertices of the mesh
    labels.resize(input.points.size());
    return labels;
  }
  return CSCD::internal::labels_of_file(input.as_read.points, CSCD::internal::to_vectors(input.mesh.points()), labels);
}

} // namespace cscd
