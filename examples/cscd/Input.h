// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program skeletonizes.

#ifndef CSCD_PROGRAM_INPUT_H
#define CSCD_PROGRAM_INPUT_H

#include "types.h"
#include <CSCD/IO/Mesh_repair_report.h>

#include <vector>

namespace cscd {

/// A mesh, or points, if the file has no faces.
struct Input
{
  bool is_point_set = false;
  Mesh mesh; ///< for points, the surface that is made of them: its first vertices are the points
  CSCD::Mesh_repair_report repairs;
  std::vector<Point> points;
  std::vector<Vector> normals; ///< of the points, or empty
};

} // namespace cscd

#endif // CSCD_PROGRAM_INPUT_H
