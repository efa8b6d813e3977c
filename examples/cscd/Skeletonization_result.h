// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a skeletonization gives to the program.

#ifndef CSCD_PROGRAM_SKELETONIZATION_RESULT_H
#define CSCD_PROGRAM_SKELETONIZATION_RESULT_H

#include "types.h"
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Tree/Tree_report.h>

#include <optional>
#include <string>
#include <vector>

namespace cscd {

/// A skeleton, how it came about, and, if it is that of a surface, the closed curves by which this was cut.
struct Skeletonization_result
{
  Skeleton skeleton;
  CSCD::Skeletonization_report report;
  std::optional<CSCD::Tree_report> tree; ///< if the input was taken for a scan of trees: the report that counts
  std::vector<std::vector<Point>> separators;

  /// What the user should know: one sentence each.
  const std::vector<std::string>& warnings() const { return tree ? tree->warnings : report.warnings; }
};

} // namespace cscd

#endif // CSCD_PROGRAM_SKELETONIZATION_RESULT_H
