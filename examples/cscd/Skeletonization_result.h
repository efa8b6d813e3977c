// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a skeletonization gives to the program.

#ifndef CSCD_PROGRAM_SKELETONIZATION_RESULT_H
#define CSCD_PROGRAM_SKELETONIZATION_RESULT_H

#include "types.h"
#include <CSCD/Skeletonization_report.h>

#include <vector>

namespace cscd {

/// A skeleton, how it came about, and the closed curves by which the surface was cut.
struct Skeletonization_result
{
  Skeleton skeleton;
  CSCD::Skeletonization_report report;
  std::vector<std::vector<Point>> separators;
};

} // namespace cscd

#endif // CSCD_PROGRAM_SKELETONIZATION_RESULT_H
