// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for meshes.

#ifndef CSCD_PROGRAM_COMPUTE_MESH_SKELETON_H
#define CSCD_PROGRAM_COMPUTE_MESH_SKELETON_H

#include "Input.h"
#include "Progress_visitor.h"
#include "Skeletonization_result.h"
#include "Skeletonize_options.h"

namespace cscd {

/// Skeletonizes the mesh of `input`.
Skeletonization_result compute_mesh_skeleton(const Input& input, const Skeletonize_options& options,
                                             Progress_visitor& visitor);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPUTE_MESH_SKELETON_H
