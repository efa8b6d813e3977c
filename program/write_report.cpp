// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run, as JSON and as text.

#include "write_report.h"

#include "options.h"
#include <CSCD/IO/internal/json_branches.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/version.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

using Json = nlohmann::ordered_json;

// The rows of arrays, in the namespace where the library of JSON looks for them.
namespace CSCD {

static void to_json(Json& json, const Reconstruction_repair& repair)
{
  json = {CSCD_JSON_PAIRS(repair, center, length)};
}

static void to_json(Json& json, const Tree_gap& gap)
{
  json = {CSCD_JSON_PAIRS(gap, from, to, length)};
}

static void to_json(Json& json, const Tree_measures& tree)
{
  json = {CSCD_JSON_PAIRS(tree, height, length, volume, trunk_volume, diameter_at_breast_height)};
}

static void to_json(Json& json, const Tree_branch& branch)
{
  json = {{"parent", branch.parent == no_branch ? Json() : Json(branch.parent)},
          CSCD_JSON_PAIRS(branch, object, order, strahler_order, length, radius_at_base, radius_at_tip,
                          number_of_sections, number_of_circles, nodes)};
}

} // namespace CSCD

namespace cscd {

namespace {

using CSCD::internal::counted;

/// Numbers by the outcomes that they count.
template <std::size_t size, class Numbers>
Json by_outcome(const std::array<const char*, size>& names, const Numbers& numbers)
{
  Json result = Json::object();
  for (std::size_t i = 0; i < size; ++i) {
    result[names[i]] = numbers[i];
  }
  return result;
}

/// The reasons why sources have no accepted cut point.
Json rejections(const CSCD::Skeletonization_report& r)
{
  constexpr std::array<const char*, CSCD::number_of_cut_loop_outcomes> names{
      "found", "no_cut_point", "distance_below_chord", "one_direction", "not_connected", "meets_at_once", "narrow"};
  Json result = by_outcome(names, r.number_of_rejections);
  result.erase(names.front()); // not a rejection
  return result;
}

Json counts_of(const CSCD::Skeletonization_report& r)
{
  return {{"number_of_sites", r.number_of_input_vertices},
          CSCD_JSON_PAIRS(r, number_of_isolated_vertices, number_of_surface_components, number_of_bridged_borders,
                          number_of_cavities, number_of_sheets, number_of_wide_borders, number_of_inserted_vertices,
                          number_of_degenerate_faces, number_of_levels),
          {"genus", r.genus ? Json(*r.genus) : Json()},
          CSCD_JSON_PAIRS(r, number_of_sources, number_of_sources_without_cut),
          {"number_of_rejections", rejections(r)},
          CSCD_JSON_PAIRS(r, number_of_collapsed_loops, number_of_held_loops, number_of_unfinished_loops,
                          number_of_bumps, number_of_tunnels, number_of_separators, number_of_plane_sections,
                          number_of_straightened_loops, number_of_packed_separators, number_of_open_separators,
                          number_of_handle_cuts, number_of_nodes, number_of_edges, number_of_skeleton_components,
                          betti_number, number_of_tips, number_of_junctions, number_of_openings,
                          number_of_nodes_outside, number_of_edges_outside)};
}

Json reconstruction_part(const CSCD::Reconstruction_report& r)
{
  return {CSCD_JSON_PAIRS(r, number_of_points, number_of_duplicates, number_of_thinned_points, is_averaged,
                          number_of_neighbors, spacing, noise, is_smoothed, number_of_outliers, number_of_unused_points,
                          number_of_border_edges, number_of_holes),
          {"number_of_joined_gaps", r.joined_gaps.size()},
          {"number_of_cut_handles", r.cut_handles.size()},
          CSCD_JSON_PAIRS(r, joined_gaps, cut_handles)};
}

Json by_stage(const std::array<double, CSCD::number_of_skeletonization_stages>& seconds)
{
  Json result;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    result[CSCD::name(static_cast<CSCD::Skeletonization_stage>(i))] = seconds[i];
  }
  return result;
}

/// The given options that affect the computation of the skeleton.
Json options_part(Skeletonize_options options)
{
  Json result = Json::object();
  for (const Option& option : given_options(options)) {
    if (is_of_method(option)) {
      const std::string text = text_of(option);
      result[option.name] = Json::accept(text) ? Json::parse(text) : Json(text);
    }
  }
  return result;
}

Json tree_document(const Skeletonize_options& options, const Skeletonization_result& result)
{
  const CSCD::Tree_report& r = *result.tree;
  constexpr std::array<const char*, CSCD::number_of_circle_outcomes> names_of_sections{
      "fitted", "few_points", "short_arc", "scattered", "too_wide"};
  return {{"version", CSCD_VERSION},
          {"input", options.input},
          {"method", tree_shape},
          {"options", options_part(options)},
          CSCD_JSON_PAIRS(r, number_of_points, number_of_duplicates, number_of_thinned_points, number_of_debris,
                          number_of_objects, spacing, number_of_nodes, number_of_edges),
          {"number_of_branches", result.branches.branches.size()},
          {"number_of_limbs", r.branches.size()},
          {"number_of_sections", by_outcome(names_of_sections, r.number_of_sections)},
          {"breast_height", options.breast_height},
          {"trees", result.trees},
          {"limbs", r.branches},
          {"branches", CSCD::internal::json_branches(result.branches.branches)},
          CSCD_JSON_PAIRS(r, gaps, seconds, warnings)};
}

void write_tree_summary(std::ostream& out, const Skeletonize_options& options, const Skeletonization_result& result)
{
  const CSCD::Tree_report& report = *result.tree;
  constexpr int digits = 3; // of the time
  double length = 0;
  std::size_t order = 0;
  for (const CSCD::Tree_branch& branch : report.branches) {
    length += branch.length;
    order = std::max(order, branch.order);
  }
  out << printable(options.input) << ": " << counted(report.number_of_points, "point") << ", "
      << counted(report.number_of_objects, "tree") << "\nskeleton: " << counted(report.number_of_nodes, "node") << ", "
      << counted(report.branches.size(), "limb") << " of orders 0 to " << order << ", length " << length << ", "
      << counted(report.gaps.size(), "gap");
  if (result.trees.size() == 1) {
    const CSCD::Tree_measures& tree = result.trees.front();
    out << "\ntree: height " << tree.height << ", volume " << tree.volume;
    if (!std::isnan(tree.diameter_at_breast_height)) {
      out << ", diameter at breast height " << tree.diameter_at_breast_height;
    }
  }
  out << "\ntime: " << std::fixed << std::setprecision(digits) << report.seconds << " s\n";
}

Json report_document(const Skeletonize_options& options, const std::vector<std::string>& repairs,
                     const Skeletonization_result& result)
{
  if (result.tree) {
    return tree_document(options, result);
  }
  const CSCD::Skeletonization_report& report = result.report;
  Json document{{"version", CSCD_VERSION},
                {"input", options.input},
                {"domain", !options.domain.empty() ? options.domain
                           : result.is_of_points   ? "points"
                           : result.volume         ? "volume"
                                                   : "mesh"},
                {"method", options.method},
                {"options", options_part(options)},
                {"seed", options.seed},
                {"number_of_threads", report.number_of_threads},
                {"repairs", repairs}};
  if (options.wrap) {
    document["wrap"] = *options.wrap;
  }
  if (options.domain == graph_domain) {
    document["method"] = graph_domain;
  } else if (options.method == local_method) {
    document["detail"] = options.detail;
  } else {
    document["literal"] = options.is_literal;
  }
  document.update(counts_of(report));
  if (result.volume) {
    document["volume"] = {{"label", result.volume->label},
                          {"connectivity", options.volume.connectivity},
                          CSCD_JSON_PAIRS((*result.volume), number_of_voxels, number_of_cavities),
                          {"are_cavities_kept", options.volume.keeps_cavities}};
  }
  if (report.reconstruction) {
    document["reconstruction"] = reconstruction_part(*report.reconstruction);
  }
  if (result.fragments) {
    document["fragments"] = {{"number_of_removed_components", result.fragments->number_of_removed_components},
                             {"number_of_removed_sites", result.fragments->number_of_removed_vertices},
                             {"number_of_joined_edges", result.fragments->number_of_joined_edges}};
  }
  document["branches"] = CSCD::internal::json_branches(result.branches.branches);
  document["openings"] = Json::array();
  for (std::size_t node = 0; node < result.skeleton.is_opening.size(); ++node) {
    if (result.skeleton.is_opening[node] != 0) {
      document["openings"].push_back(
          {{"node", node}, {"center", result.skeleton.points[node]}, {"radius", result.skeleton.radii[node]}});
    }
  }
  document["seconds"] = by_stage(report.seconds);
  document["warnings"] = report.warnings;
  return document;
}

} // namespace

std::string dump_json(const Json& json)
{
  constexpr int indentation = 2;
  return json.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

void write_report(std::ostream& out, const Skeletonize_options& options, const std::vector<std::string>& repairs,
                  const Skeletonization_result& result)
{
  out << dump_json(report_document(options, repairs, result)) << '\n';
}

void write_summary(std::ostream& out, const Skeletonize_options& options, const Skeletonization_result& result)
{
  if (result.tree) {
    write_tree_summary(out, options, result);
    return;
  }
  const CSCD::Skeletonization_report& report = result.report;
  constexpr int digits = 3; // of the time
  out << printable(options.input) << ": ";
  if (result.volume) {
    out << "label " << result.volume->label << ", " << counted(result.volume->number_of_voxels, "voxel") << ", "
        << counted(result.volume->number_of_cavities, "cavity", "cavities")
        << (options.volume.keeps_cavities ? " kept, " : " filled, ");
  }
  out << (result.is_of_points
              ? counted(report.number_of_input_vertices, "point") + (result.has_normals ? " with normals" : "")
              : counted(report.number_of_input_vertices, "vertex", "vertices"))
      << ", " << counted(report.number_of_surface_components, "component");
  if (report.genus) {
    out << ", genus " << *report.genus;
  }
  const double seconds = std::accumulate(report.seconds.begin(), report.seconds.end(), 0.0);
  const CSCD::Skeleton_counts counts{
      report.number_of_nodes, report.number_of_edges, report.number_of_skeleton_components,
      report.betti_number,    report.number_of_tips,  report.number_of_junctions};
  out << "\nskeleton: " << in_words(counts) << "\ntime: " << std::fixed << std::setprecision(digits) << seconds
      << " s on " << counted(report.number_of_threads, "thread") << '\n';
}

std::string in_words(const CSCD::Skeleton_counts& counts)
{
  return counted(counts.number_of_nodes, "node") + ", " + counted(counts.number_of_edges, "edge") + ", " +
         counted(counts.number_of_components, "component") + ", " + counted(counts.betti_number, "cycle") + ", " +
         counted(counts.number_of_tips, "tip") + ", " + counted(counts.number_of_junctions, "junction");
}

std::string printable(const std::string& text)
{
  constexpr char delete_character = 0x7f;
  std::ostringstream result;
  for (const char c : text) {
    if (c == '\t') {
      result << "\\t";
    } else if (c == '\n') {
      result << "\\n";
    } else if (static_cast<unsigned char>(c) < ' ' || c == delete_character) {
      result << "\\x" << std::hex << std::setw(2) << std::setfill('0') << int(c);
    } else {
      result << c;
    }
  }
  return result.str();
}

} // namespace cscd
