// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run.

#ifndef CSCD_PROGRAM_WRITE_REPORT_H
#define CSCD_PROGRAM_WRITE_REPORT_H

#include "options.h"
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace cscd {

/// The place where a limb ends at a border of the mesh.
struct Opening
{
  std::size_t node = 0;
  std::array<double, 3> center{};
  double radius = 0;
};

/// A body in a volume.
struct Volume_body
{
  std::uint32_t label = 0;
  std::size_t number_of_voxels = 0;
  std::size_t number_of_cavities = 0;
};

/// The report of a run, without the skeleton.
struct Run_report
{
  CSCD::Skeletonization_report report;
  std::optional<CSCD::Tree_report> tree; ///< if the input was treated as a scan of trees: the report that counts
  bool is_of_points = false;             ///< or else of a mesh
  bool has_normals = false;              ///< whether the points came with normals
  std::vector<CSCD::Index> roots;        ///< of the skeleton, by choice, or of a scan of trees; empty without any
  CSCD::Skeleton_branches branches;
  std::vector<Opening> openings;
  std::optional<Volume_body> volume;                    ///< if the surface is that of voxels
  std::vector<CSCD::Tree_measures> trees;               ///< the objects of a scan of trees
  std::optional<CSCD::Simplification_report> fragments; ///< the treatment of fragments, if requested

  /// The warnings for the user: one sentence each.
  const std::vector<std::string>& warnings() const { return tree ? tree->warnings : report.warnings; }
};

/// `text` with control characters, which could stand in a file name and act on a terminal, as escape sequences.
std::string printable(const std::string& text);

/// `json` as text. Bytes that are not UTF-8, as in file names, are replaced.
std::string dump_json(const nlohmann::ordered_json& json);

/// The report of a run as a JSON object. \param repairs of the input, a sentence each
nlohmann::ordered_json report_document(const Skeletonize_options& options, const std::vector<std::string>& repairs,
                                       const Run_report& result);

/// Writes report_document().
void write_report(std::ostream& out, const Skeletonize_options& options, const std::vector<std::string>& repairs,
                  const Run_report& result);

/// Writes a few lines of text: counts, topology, time.
void write_summary(std::ostream& out, const Skeletonize_options& options, const Run_report& result);

} // namespace cscd

#endif // CSCD_PROGRAM_WRITE_REPORT_H
