// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run.

#ifndef CSCD_PROGRAM_WRITE_REPORT_H
#define CSCD_PROGRAM_WRITE_REPORT_H

#include "options.h"
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <boost/preprocessor/punctuation/comma_if.hpp>
#include <boost/preprocessor/seq/for_each_i.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace cscd {

/// A body in a volume.
struct Volume_body
{
  CSCD::Voxel_label label = 0;
  std::size_t number_of_voxels = 0;
  std::size_t number_of_cavities = 0;
};

/// A skeleton, and the report of its computation.
struct Skeletonization_result
{
  CSCD::Skeleton skeleton;
  CSCD::Skeletonization_report report;
  std::optional<CSCD::Tree_report> tree; ///< if the input was treated as a scan of trees: the report that counts
  bool is_of_points = false;             ///< or else of a mesh
  bool has_normals = false;              ///< whether the points came with normals
  std::vector<CSCD::Index> roots;        ///< of the skeleton, by choice, or of a scan of trees; empty without any
  CSCD::Skeleton_branches branches;
  std::optional<Volume_body> volume;                    ///< if the surface is that of voxels
  std::vector<CSCD::Tree_measures> trees;               ///< the objects of a scan of trees
  std::optional<CSCD::Simplification_report> fragments; ///< the treatment of fragments, if requested

  /// The warnings for the user: one sentence each.
  const std::vector<std::string>& warnings() const { return tree ? tree->warnings : report.warnings; }
};

/// `text` with control characters, which could stand in a file name and act on a terminal, as escape sequences.
std::string printable(const std::string& text);

/// Pairs for a JSON object: the name and the value of each of these members of `object`.
#define CSCD_JSON_PAIRS(object, ...)                                                                                   \
  BOOST_PP_SEQ_FOR_EACH_I(CSCD_JSON_PAIR, object, BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))
#define CSCD_JSON_PAIR(repetition, object, i, member)                                                                  \
  BOOST_PP_COMMA_IF(i)                                                                                                 \
  {                                                                                                                    \
    BOOST_PP_STRINGIZE(member), object.member                                                                          \
  }

/// `json` as text. Bytes that are not UTF-8, as in file names, are replaced.
std::string dump_json(const nlohmann::ordered_json& json);

/// Writes the report of a run as a JSON object. \param repairs of the input, a sentence each
void write_report(std::ostream& out, const Skeletonize_options& options, const std::vector<std::string>& repairs,
                  const Skeletonization_result& result);

/// The counts with their nouns, separated by commas.
std::string in_words(const CSCD::Skeleton_counts& counts);

/// Writes a few lines of text: counts, topology, time.
void write_summary(std::ostream& out, const Skeletonize_options& options, const Skeletonization_result& result);

} // namespace cscd

#endif // CSCD_PROGRAM_WRITE_REPORT_H
