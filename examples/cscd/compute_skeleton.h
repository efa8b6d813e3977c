// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation.

#ifndef CSCD_PROGRAM_COMPUTE_SKELETON_H
#define CSCD_PROGRAM_COMPUTE_SKELETON_H

#include "Progress_bar.h"
#include "Skeletonization_result.h"
#include "Skeletonize_options.h"
#include "types.h"

namespace cscd {

/// Skeletonizes `mesh` as `options` demand.
/// \param bar shows the progress, or null
/// \throw CSCD::Input_error if the mesh cannot be skeletonized
Skeletonization_result compute_skeleton(const Mesh& mesh, const Skeletonize_options& options, Progress_bar* bar);

} // namespace cscd

#endif // CSCD_PROGRAM_COMPUTE_SKELETON_H
