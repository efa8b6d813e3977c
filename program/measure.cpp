// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `cscd evaluate` and `cscd compare`: from arguments to measures, as JSON and as text.

#include "types.h"
#include "write_report.h"
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/version.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using Json = nlohmann::ordered_json;

// The parts of the documents, in the namespace where the library of JSON looks for them.
namespace CSCD {

static void to_json(Json& json, const Skeleton_counts& c)
{
  json = {CSCD_JSON_PAIRS(c, number_of_nodes, number_of_edges, number_of_components, betti_number, number_of_tips,
                          number_of_junctions, number_of_isolated_nodes, length, mean_turning),
          {"largest_turning", c.max_turning}};
}

static void to_json(Json& json, const Position_measures& p)
{
  json = {CSCD_JSON_PAIRS(p, number_of_surface_components, genus, number_of_borders, fraction_of_nodes_inside,
                          fraction_of_length_inside),
          {"largest_distance_outside", p.max_distance_outside},
          CSCD_JSON_PAIRS(p, deviation_by_length, offset_by_length)};
}

static void to_json(Json& json, const Surface_limb& limb)
{
  json = {CSCD_JSON_PAIRS(limb, tip, height, has_tip)};
}

static void to_json(Json& json, const Limb_measures& l)
{
  json = {{"number_of_limbs", l.limbs.size()},
          CSCD_JSON_PAIRS(l, number_of_limbs_without_tip, number_of_tips_without_limb, limbs)};
}

static void to_json(Json& json, const Reconstruction_error& e)
{
  json = {CSCD_JSON_PAIRS(e, mean, mean_square, maximum, reverse_mean, reverse_maximum, unresolved_fraction, cell_size,
                          number_of_faces)};
}

static void to_json(Json& json, const Skeleton_distance& d)
{
  json = {CSCD_JSON_PAIRS(d, mean, maximum, fraction_matched)};
}

static void to_json(Json& json, const Match_count& m)
{
  json = {CSCD_JSON_PAIRS(m, number_in_first, number_in_second, number_matched), {"fraction", m.fraction()}};
}

} // namespace CSCD

namespace cscd {

namespace {

using CSCD::internal::counted;

/// `value` with a fixed number of digits; a dash if it is not defined.
std::string fixed(double value, int digits = 2)
{
  if (std::isnan(value)) {
    return "-";
  }
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

/// A part of the whole, in percent.
std::string percent(double fraction, int digits = 2)
{
  constexpr double hundred = 100;
  return fixed(hundred * fraction, digits);
}

/// A line of the table of distances, in thousandths.
void write_error(std::ostream& out, const char* name, const CSCD::Reconstruction_error& error)
{
  constexpr double thousand = 1000;
  constexpr int width = 9;
  out << name;
  for (const double value :
       {error.mean, std::sqrt(error.mean_square), error.maximum, error.reverse_mean, error.reverse_maximum}) {
    out << std::setw(width) << fixed(thousand * value);
  }
  out << '\n';
}

void write_position(std::ostream& out, const CSCD::Position_measures& p)
{
  out << "inside: " << percent(p.fraction_of_nodes_inside) << " % of the nodes, "
      << percent(p.fraction_of_length_inside) << " % of the length"
      << "\noff center: by " << percent(p.offset_by_length)
      << " % of the distance to the surface; that distance deviates by " << percent(p.deviation_by_length)
      << " % around the skeleton\n";
}

void write_limbs(std::ostream& out, const CSCD::Limb_measures& l)
{
  out << "limbs: " << l.limbs.size() << ", of which " << l.number_of_limbs_without_tip << " without a tip; "
      << counted(l.number_of_tips_without_limb, "tip") << " without a limb (recall " << fixed(l.tip_recall)
      << ", precision " << fixed(l.tip_precision) << ")\n";
}

/// A line of the table of matches.
void write_match(std::ostream& out, const char* name, const CSCD::Match_count& match)
{
  out << name << match.number_matched << " of " << match.number_in_first << " and " << match.number_in_second
      << " match\n";
}

void write_distance(std::ostream& out, const char* name, const CSCD::Skeleton_distance& distance)
{
  constexpr double thousand = 1000;
  constexpr int width = 9;
  out << name << std::setw(width) << fixed(thousand * distance.mean) << std::setw(width)
      << fixed(thousand * distance.maximum) << std::setw(width) << percent(distance.fraction_matched, 1) << " %\n";
}

void write_measures(std::ostream& out, const Evaluate_options& options, const CSCD::Skeleton_measures& measures)
{
  const CSCD::Position_measures& p = measures.position;
  const bool is_point_set = p.number_of_surface_components == 0;
  out << printable(options.input) << ": "
      << (is_point_set ? counted(measures.number_of_points, "point")
                       : counted(measures.number_of_points, "vertex", "vertices"));
  if (!is_point_set) {
    out << ", " << counted(p.number_of_surface_components, "component") << ", genus " << p.genus;
  }
  out << '\n' << printable(options.skeleton) << ": " << in_words(measures.counts) << '\n';
  if (!is_point_set) {
    out << "topology: " << (measures.has_topology_of_surface() ? "that of the surface\n" : "not that of the surface\n");
    write_position(out, p);
    write_limbs(out, measures.limbs);
  }
  out << "turning: " << fixed(measures.counts.mean_turning) << " rad per radius, at most "
      << fixed(measures.counts.max_turning) << " rad at a node\n"
      << "distances in thousandths of the diagonal, with " << options.radii << " radii:\n"
      << "                         mean      rms      max  reverse      max\n";
  write_error(out, "convolution surface ", measures.convolution);
  write_error(out, "round cones         ", measures.round_cones);
}

void write_comparison_as_json(std::ostream& out, const Compare_options& options,
                              const CSCD::Skeleton_comparison& comparison)
{
  const Json document{{"version", CSCD_VERSION},
                      CSCD_JSON_PAIRS(options, first, second),
                      CSCD_JSON_PAIRS(comparison, diagonal, match_distance),
                      {"mean_distance", comparison.mean_distance()},
                      {"hausdorff_distance", comparison.hausdorff_distance()},
                      CSCD_JSON_PAIRS(comparison, from_first_to_second, from_second_to_first, tips, junctions)};
  out << dump_json(document) << '\n';
}

void write_comparison(std::ostream& out, const Compare_options& options, const CSCD::Skeleton_comparison& comparison)
{
  out << printable(options.first) << " and " << printable(options.second) << ":\n";
  write_match(out, "tips:      ", comparison.tips);
  write_match(out, "junctions: ", comparison.junctions);
  out << "distances in thousandths of the diagonal, and the length within " << percent(comparison.match_distance)
      << " % of it:\n"
      << "                       mean      max   within\n";
  write_distance(out, "first to second   ", comparison.from_first_to_second);
  write_distance(out, "second to first   ", comparison.from_second_to_first);
}

} // namespace

void write_measures_as_json(std::ostream& out, const Evaluate_options& options, const CSCD::Skeleton_measures& measures)
{
  const bool is_point_set = measures.position.number_of_surface_components == 0;
  const Json document{{"version", CSCD_VERSION},
                      CSCD_JSON_PAIRS(options, input, skeleton, radii),
                      CSCD_JSON_PAIRS(measures, number_of_points, diagonal),
                      {"has_topology_of_surface", measures.has_topology_of_surface()},
                      CSCD_JSON_PAIRS(measures, counts, position),
                      CSCD_JSON_PAIRS(measures.limbs, tip_recall, tip_precision),
                      {"limbs", is_point_set ? Json() : Json(measures.limbs)},
                      CSCD_JSON_PAIRS(measures, convolution, round_cones, mean_distance_from_round_cones)};
  out << dump_json(document) << '\n';
}

Skeleton read_skeleton_argument(const std::string& filename)
{
  return CSCD::internal::to_skeleton(
      read_file(filename, filename == standard_stream ? "graph" : "", CSCD::internal::skeleton_content));
}

CSCD::Skeleton_measures measure_skeleton(const Input& input, const Skeleton& skeleton, const Evaluate_options& options)
{
  CSCD::Checked_triangles measured;
  if (input.is_point_set) {
    measured.triangles.points.assign(input.points.begin(),
                                     input.points.begin() + std::ptrdiff_t(input.number_of_points));
  } else {
    measured = CSCD::check_triangles(std::vector(input.points), std::vector(input.faces));
  }
  return CSCD::internal::evaluate_skeleton(std::move(measured), Skeleton(skeleton),
                                           {options.radii == own_radii, options.resolution});
}

void evaluate(const Evaluate_options& options)
{
  check_skeleton_argument(options.skeleton);
  if (options.input == standard_stream && options.skeleton == standard_stream) {
    throw Usage_error("only one of INPUT and SKELETON can be standard input");
  }
  const Input input = read_input(options.input, options.format, options.is_quiet);
  const Skeleton skeleton = read_skeleton_argument(options.skeleton);
  const CSCD::Skeleton_measures measures = measure_skeleton(input, skeleton, options);
  if (options.is_json) {
    write_measures_as_json(std::cout, options, measures);
  } else {
    write_measures(std::cout, options, measures);
  }
}

void compare(const Compare_options& options)
{
  check_skeleton_argument(options.first);
  check_skeleton_argument(options.second);
  if (options.first == standard_stream && options.second == standard_stream) {
    throw Usage_error("only one of the skeletons can be standard input");
  }
  Skeleton first = read_skeleton_argument(options.first);
  Skeleton second = read_skeleton_argument(options.second);
  const CSCD::Skeleton_comparison comparison =
      CSCD::internal::compare_skeletons(std::move(first), std::move(second), options.match_distance);
  if (options.is_json) {
    write_comparison_as_json(std::cout, options, comparison);
  } else {
    write_comparison(std::cout, options, comparison);
  }
}

} // namespace cscd
