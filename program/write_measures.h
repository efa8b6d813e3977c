// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of skeletons, as JSON and as text.

#ifndef CSCD_PROGRAM_WRITE_MEASURES_H
#define CSCD_PROGRAM_WRITE_MEASURES_H

#include "options.h"
#include <CSCD/Measure/Skeleton_measures.h>

#include <ostream>

namespace cscd {

/// Writes the measures as a JSON object; undefined measures are null.
void write_measures_as_json(std::ostream& out, const Evaluate_options& options,
                            const CSCD::Skeleton_measures& measures);

/// Writes the measures as lines of text.
void write_measures(std::ostream& out, const Evaluate_options& options, const CSCD::Skeleton_measures& measures);

/// Writes the comparison as a JSON object.
void write_comparison_as_json(std::ostream& out, const Compare_options& options,
                              const CSCD::Skeleton_comparison& comparison);

/// Writes the comparison as lines of text.
void write_comparison(std::ostream& out, const Compare_options& options, const CSCD::Skeleton_comparison& comparison);

} // namespace cscd

#endif // CSCD_PROGRAM_WRITE_MEASURES_H
