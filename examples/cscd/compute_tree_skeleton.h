// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for scans of trees.

#ifndef CSCD_PROGRAM_COMPUTE_TREE_SKELETON_H
#define CSCD_PROGRAM_COMPUTE_TREE_SKELETON_H

#include "Input.h"
#include "Skeletonization_result.h"
#include "Skeletonize_options.h"

namespace cscd {

/// Skeletonizes the points of `input` as a scan of trees, and makes them the vertices of its mesh, without faces.
Skeletonization_result compute_tree_skeleton(Input& input, const Skeletonize_options& options);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPUTE_TREE_SKELETON_H
