// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation of the skeleton, the nodes of the vertices of the input, and wraps around meshes.

#ifndef CSCD_PROGRAM_COMPUTE_SKELETON_H
#define CSCD_PROGRAM_COMPUTE_SKELETON_H

#include "types.h"
#include <CSCD/IO/write_correspondence.h>

#include <vector>

namespace cscd {

/// Skeletonizes `input` as `options` demand. If it is a point set, its mesh becomes the surface made of the points.
/// \param progress is informed, or is empty
/// \throw CSCD::Input_error if it cannot be skeletonized
Skeletonization_result compute_skeleton(Input& input, const Skeletonize_options& options,
                                        const Stage_progress& progress);

/// The label of each vertex or point of the file, in its order.
/// \pre `input` has kept the contents of the file
std::vector<CSCD::Vertex_label> labels_of_file(const Input& input, const Skeletonization_result& result);

/// Replaces the mesh of `input` by the surface that CGAL's alpha wrapping puts around it: closed, without parts that
/// cut each other, and solid where the inside is reached by narrow holes only. It does not keep the vertices.
/// \param size holes, gaps and hollows that are narrower are closed; relative to the diagonal of the bounding box
/// \throw CSCD::Input_error if nothing can be wrapped
void wrap_mesh(Input& input, double size);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPUTE_SKELETON_H
