// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for points.

#ifndef CSCD_PROGRAM_COMPUTE_POINT_SKELETON_H
#define CSCD_PROGRAM_COMPUTE_POINT_SKELETON_H

#include "Input.h"
#include "Progress_visitor.h"
#include "Skeletonization_result.h"
#include "Skeletonize_options.h"

namespace cscd {

/// Skeletonizes the points of `input`, and puts the surface that is made of them into its mesh.
Skeletonization_result compute_point_skeleton(Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPUTE_POINT_SKELETON_H
