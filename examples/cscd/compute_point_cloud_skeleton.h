// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published computation for points.

#ifndef CSCD_PROGRAM_COMPUTE_POINT_CLOUD_SKELETON_H
#define CSCD_PROGRAM_COMPUTE_POINT_CLOUD_SKELETON_H

#include "Input.h"
#include "Progress_visitor.h"
#include "Skeletonization_result.h"
#include "Skeletonize_options.h"

namespace cscd {

/// Skeletonizes the points of `input` as published, and puts the triangles that join them into its mesh.
Skeletonization_result compute_point_cloud_skeleton(Input& input, const Skeletonize_options& options,
                                                    Progress_visitor& visitor);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPUTE_POINT_CLOUD_SKELETON_H
