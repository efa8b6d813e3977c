// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run.

#ifndef CSCD_PROGRAM_WRITE_REPORT_H
#define CSCD_PROGRAM_WRITE_REPORT_H

#include "Skeletonization_result.h"
#include "Skeletonize_options.h"
#include <CSCD/IO/Mesh_repair_report.h>

#include <ostream>

namespace cscd {

/// Writes the report of a run as a JSON object.
void write_report(std::ostream& out, const Skeletonize_options& options, const CSCD::Mesh_repair_report& repairs,
                  const Skeletonization_result& result);

/// Writes a few lines for people: counts, topology, time.
void write_summary(std::ostream& out, const Skeletonize_options& options, const Skeletonization_result& result);

} // namespace cscd

#endif // CSCD_PROGRAM_WRITE_REPORT_H
