// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of options, and functions that set and check them.

#include "options.h"

#include "other_methods.h"
#include <CSCD/IO/Shape_file.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace cscd {

namespace {

// The groups of the help.
constexpr const char* input_group = "Input";
constexpr const char* skeleton_group = "Skeleton";
constexpr const char* detail_group = "Detail";
constexpr const char* output_group = "Output";
constexpr const char* volume_group = "Volumes";
constexpr const char* tree_group = "Trees";
constexpr const char* expert_group = "Expert";

constexpr const char* argument_of_files = "FILE";

/// \param kinds of input that the rows apply to, if not to all
void append(std::vector<Option>& table, const char* group, std::vector<Option> rows, unsigned kinds = any_input)
{
  for (Option& row : rows) {
    row.group = group;
    row.kinds &= kinds;
    table.push_back(std::move(row));
  }
}

/// The formats of meshes, of points if `endings` has those, and `others`: endings without their dots, each once.
Option format_option(std::string& format, const std::vector<std::string>& endings, std::vector<std::string> others = {})
{
  std::vector<std::string> formats;
  for (const std::string& ending : endings) {
    others.push_back(ending.substr(1));
  }
  for (const std::string& name : others) {
    if (std::find(formats.begin(), formats.end(), name) == formats.end()) {
      formats.push_back(name);
    }
  }
  return Option{"format", &format, "ENDING", "the format, in place of the ending of the file; needed for -"}.checked_by(
      [formats](const std::string& text) {
        const bool is_known =
            std::find(formats.begin(), formats.end(), CSCD::without_compression_ending(text)) != formats.end();
        return is_known ? "" : "must be one of " + boost::algorithm::join(formats, ", ") + ", not " + text;
      });
}

std::vector<std::string> input_endings()
{
  std::vector<std::string> result = CSCD::mesh_endings();
  for (const std::string& ending : CSCD::point_endings()) {
    result.push_back(ending);
  }
  return result;
}

Option quiet_option(bool& is_quiet)
{
  return Option{"quiet", &is_quiet, "", "print nothing but errors"}.with_letter('q');
}

Option skeleton_outputs(std::vector<std::string>& outputs, const char* endings)
{
  return Option{"output", &outputs, "FILE", std::string(endings) + "; - is standard output; may be repeated"}
      .with_letter('o');
}

Option file_option(const char* name, std::string& file, const char* content)
{
  return {name, &file, argument_of_files, content};
}

std::vector<Option> fragment_options(CSCD::internal::Simplification_parameters& options, const char* unit)
{
  return {Option{"min-component", &options.min_component_size, "N",
                 std::string("drop components of fewer ") + unit + " than this, except the largest"}
              .at_least(1),
          {"join", &options.joins_components, "", "join components by the shortest straight edges"}};
}

Option root_option(std::string& root)
{
  return Option{"root", &root, "WHERE", "where the skeleton begins: coordinates, thickest, lowest, or longest (path)"}
      .checked_by(check_root);
}

std::vector<Option> swc_options(CSCD::Swc_options& swc)
{
  return {Option{"swc-type", &swc.type, "T", "type of all nodes in .swc, such as 2 axon, 3 dendrite"}.in(0, 7),
          Option{"soma", &swc.min_soma_radius, "R", "the thickest node is the soma in .swc if its radius is R or more"}
              .at_least(0),
          Option{"swc-scale", &swc.scale, "S", "factor of coordinates and radii in .swc"}.above(0)};
}

template <class Value>
struct Is_optional : std::false_type
{
};
template <class Value>
struct Is_optional<std::optional<Value>> : std::true_type
{
};

[[noreturn]] void refuse(const Option& option, const std::string& fault)
{
  throw Usage_error("--" + option.name + ": " + fault);
}

/// The numbers that `option` allows, in words.
std::string range_in_words(const Option& option)
{
  std::ostringstream out;
  if (option.most < std::numeric_limits<double>::infinity()) {
    out << " from " << option.least << " to " << option.most;
  } else if (option.least > -std::numeric_limits<double>::infinity()) {
    out << (option.excludes_least ? " above " : " that is at least ") << option.least;
  }
  return out.str();
}

template <class Value>
void assign_number(const Option& option, const std::string& text, Value& value)
{
  constexpr bool is_integer = std::is_integral_v<Value>;
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  Value parsed{};
  // A stream would accept a minus in front of an unsigned integer.
  const bool is_number = !text.empty() && (!is_integer || std::isdigit(static_cast<unsigned char>(text[0])) != 0) &&
                         in >> parsed && in.peek() == std::istringstream::traits_type::eof();
  const auto number = double(parsed);
  if (!is_number || number < option.least || number > option.most ||
      (option.excludes_least && number == option.least)) {
    refuse(option, (is_integer ? "must be an integer" : "must be a number") + range_in_words(option) + ", not " + text);
  }
  value = parsed;
}

/// Refuses texts that are empty or that the check of the option finds faulty.
void check_text(const Option& option, const std::string& text)
{
  const std::string fault = text.empty() ? "must not be empty" : option.check ? option.check(text) : "";
  if (!fault.empty()) {
    refuse(option, fault);
  }
}

std::string words_for(unsigned kinds)
{
  std::vector<std::string> words;
  for (const auto& [kind, word] : {std::pair(mesh_input, "meshes"), std::pair(point_input, "points"),
                                   std::pair(volume_input, "volumes"), std::pair(graph_input, "graphs")}) {
    if ((kinds & kind) != 0) {
      words.emplace_back(word);
    }
  }
  return boost::algorithm::join(words, " or ");
}

} // namespace

std::vector<Option> options_of(Skeletonize_options& o)
{
  std::vector<Option> table;
  append(table, input_group,
         {Option{"INPUT", &o.input, "", "file of a mesh, of points or of a volume, or - for standard input"}.required(),
          format_option(o.format, input_endings(), {"graph", "json", "swc"})});
  append(table, skeleton_group,
         {Option{"as", &o.domain, "graph", "skeletonize the edges of the input, which need not be of a surface"}
              .one_of({graph_domain})
              .of(mesh_input | point_input | graph_input)
              .of_other_methods(),
          Option{"neighbors", &o.number_of_neighbors, "K", "neighbors to join each point of a graph to; by default 24"}
              .at_least(1)
              .of(graph_input, "add --as graph"),
          Option{"shape", &o.shape, "auto|surface|tree", "what points sample: the surface of a body, or trees"}
              .one_of({automatic_shape, surface_shape, tree_shape})
              .of(mesh_input | point_input),
          Option{"borders", &o.borders, "auto|bridge|open", "bridge borders, or let components with borders be sheets"}
              .one_of({automatic_borders, bridged_borders, open_borders})
              .of(mesh_input | volume_input),
          Option{"wrap", &o.wrap, "SIZE", "close gaps narrower than this part of the diagonal, join parts that touch"}
              .in(0.001, 0.5) // a wrap has some 1 / size^2 vertices
              .of(mesh_input)
              .of_other_methods(),
          root_option(o.root)});
  append(table, detail_group,
         {Option{"detail", &o.detail, "D", "how small a limb may be to get a branch: 0 none, 1 every bump"}
              .in(0, 1)
              .of(mesh_input | point_input | volume_input)
              .of_method(local_method),
          Option{"spacing", &o.spacing, "S",
                 "leave nodes out of straight branches, for edges of up to so many local radii"}
              .at_least(0)
              .of(mesh_input | point_input | volume_input)
              .of_method(local_method)});
  append(table, detail_group, fragment_options(o.fragments, "vertices or points"));
  append(table, output_group,
         {skeleton_outputs(o.outputs, ".html page, .glb rig, else skeleton"),
          file_option("report", o.report, "counts, times and warnings as JSON"),
          file_option("branches", o.branches, "table of branches as CSV"),
          file_option("nodes", o.nodes, "table of nodes as CSV"),
          file_option("correspondence", o.correspondence, "node and branch of each vertex as CSV")
              .of(any_input & ~volume_input, "write the node of each voxel by -o FILE.nrrd")});
  append(table, output_group, swc_options(o.swc));
  append(table, output_group, {quiet_option(o.is_quiet)});
  append(table, volume_group,
         {{"threshold", &o.volume.threshold, "T", "the body: voxels of at least T; by default all that are not 0"},
          Option{"label", &o.volume.label, "L", "the body: voxels of label L"}.at_least(1),
          {"all-labels", &o.volume.separates_labels, "", "a body and files FILE_L for each label L"},
          {"resume", &o.volume.resumes, "", "with --all-labels: leave out labels whose files are there"},
          Option{"connectivity", &o.volume.connectivity, "6|26", "number of neighbors of a voxel"}.one_of({"6", "26"}),
          {"keep-cavities", &o.volume.keeps_cavities, "", "skeletonize cavities, too, instead of filling them"}},
         volume_input);
  append(
      table, tree_group,
      {file_option("cylinders", o.cylinders, "cylinders of a tree as CSV in the columns of TreeQSM"),
       Option{"breast-height", &o.breast_height, "H", "height above the root at which trunks are measured"}.above(0)},
      point_input);
  append(
      table, expert_group,
      {Option{"method", &o.method, "local|published", "algorithms of CSCD, or of the paper, much slower"}
           .one_of({local_method, published_method})
           .of(any_input & ~graph_input)
           .of_other_methods(),
       Option{"literal", &o.is_literal, "", "published method as printed where the default differs"}.of_method(
           published_method, "add --method published"),
       Option{"seed", &o.seed, "N", "seed of the random choice of sources"}.at_least(0),
       Option{"threads", &o.number_of_threads, "N", "number of threads; the skeleton does not depend on it"}.at_least(
           1),
       Option{"separators", &o.maximum_number_of_sources, "N", "greatest number of sources of separators"}.at_least(
           1)});
  return table;
}

std::vector<Option> options_of(Evaluate_options& o)
{
  std::vector<Option> table;
  append(table, input_group,
         {Option{"INPUT", &o.input, "", "file of a mesh or of points, or - for standard input"}.required(),
          Option{"SKELETON", &o.skeleton, "", "skeleton file; - reads .graph from standard input"}.required(),
          format_option(o.format, input_endings())});
  append(table, detail_group,
         {Option{"radii", &o.radii, "estimated|own", "radii of the reconstructed surfaces"}.one_of(
              {estimated_radii, own_radii}),
          Option{"resolution", &o.resolution, "N", "cells of the reconstructed surfaces along the diagonal"}.in(
              1, 10000)});
  append(table, output_group, {{"json", &o.is_json, "", "write all measures as JSON"}, quiet_option(o.is_quiet)});
  return table;
}

std::vector<Option> options_of(Compare_options& o)
{
  std::vector<Option> table;
  append(table, input_group,
         {Option{"A", &o.first, "", "skeleton file; - reads .graph from standard input"}.required(),
          Option{"B", &o.second, "", "skeleton file; - reads .graph from standard input"}.required()});
  append(
      table, detail_group,
      {Option{"match-distance", &o.match_distance, "D", "tips and junctions nearer than D of the diagonal are the same"}
           .at_least(0)});
  append(table, output_group, {{"json", &o.is_json, "", "write all figures as JSON"}});
  return table;
}

std::vector<Option> options_of(Simplify_options& o)
{
  std::vector<Option> table;
  append(table, input_group,
         {Option{"SKELETON", &o.skeleton, "", "skeleton file; - reads .graph from standard input"}.required(),
          file_option("mesh", o.mesh, "mesh of the skeleton: nodes inside stay inside, radii are estimated if missing"),
          format_option(o.format, CSCD::mesh_endings())});
  append(
      table, skeleton_group,
      {Option{"min-significance", &o.steps.min_significance, "S",
              "prune limbs that reach fewer radii than this beyond the body"}
           .at_least(0),
       Option{"min-length", &o.steps.min_length, "L", "prune limbs shorter than this"}.at_least(0),
       Option{"min-length-over-radius", &o.steps.min_length_over_radius, "X", "prune limbs shorter than so many radii"}
           .at_least(0),
       Option{"spacing", &o.steps.spacing, "D", "distance of nodes along branches; Xr means X local radii"}.at_least(0),
       Option{"spacing-over-radius", &o.steps.spacing_over_radius, "X", "the same in local radii"}.at_least(0)});
  append(table, skeleton_group, fragment_options(o.steps, "nodes"));
  append(table, skeleton_group, {root_option(o.root)});
  append(table, output_group, {skeleton_outputs(o.outputs, "skeleton by its ending").required()});
  append(table, output_group, swc_options(o.swc));
  append(table, output_group, {quiet_option(o.is_quiet)});
  return table;
}

std::vector<Option> options_of(Application_options& o, const std::string& output)
{
  std::vector<Option> table;
  append(table, input_group,
         {Option{"INPUT", &o.input, "", "file of a mesh, or - for standard input"}.required(),
          format_option(o.format, CSCD::mesh_endings())});
  append(table, output_group,
         {Option{"output", &o.output, "FILE", output + "; - is standard output"}.with_letter('o').required(),
          quiet_option(o.is_quiet)});
  return table;
}

std::vector<Option> options_of(Segment_options& o)
{
  std::vector<Option> table = options_of(o, "number of the part of each face, one a line");
  append(table, detail_group,
         {Option{"parts", &o.number_of_parts, "N", "number of parts; by default the shape decides"}.at_least(1)});
  return table;
}

std::vector<Option> options_of(Loops_options& o)
{
  std::vector<Option> table = options_of(o, "loops as .json, page .html, or skeleton by its ending");
  append(table, detail_group,
         {Option{"min-depth", &o.min_depth, "D",
                 "least depth of constrictions: relative extra length of neighboring loops"}
              .at_least(0)});
  return table;
}

void refuse_left_out(const std::string& argument)
{
  throw Usage_error(argument + ": this build has neither the published method nor graphs nor wraps; configure it with "
                               "-DCSCD_WITH_ALL_METHODS=ON");
}

void check_standard_output(std::ptrdiff_t number_of_results)
{
  if (number_of_results > 1) {
    throw Usage_error("only one of the results can go to standard output; name files for the others");
  }
}

bool is_of_method(const Option& option)
{
  return option.group == skeleton_group || option.group == detail_group || option.group == expert_group;
}

std::string python_name(const Option& option)
{
  return option.name == "as" ? "domain" : boost::algorithm::replace_all_copy(option.name, "-", "_");
}

std::string text_of(const Option& option)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::digits10);
  std::visit(
      [&out](const auto* value) {
        using Value = std::decay_t<decltype(*value)>;
        if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
          out << boost::algorithm::join(*value, " ");
        } else if constexpr (Is_optional<Value>::value) {
          value->has_value() ? out << **value : out;
        } else {
          out << std::boolalpha << *value;
        }
      },
      option.value);
  return out.str();
}

void assign(const Option& option, const std::string& text)
{
  if (!option.choices.empty() &&
      std::find(option.choices.begin(), option.choices.end(), text) == option.choices.end()) {
    refuse(option, "must be " + boost::algorithm::join(option.choices, " or ") + ", not " + text);
  }
  if (option.needs_all_methods && !has_all_methods && text != text_of(option)) {
    refuse_left_out("--" + option.name + " " + text);
  }
  std::visit(
      [&](auto* value) {
        using Value = std::decay_t<decltype(*value)>;
        if constexpr (std::is_same_v<Value, bool>) {
          *value = text == "true";
        } else if constexpr (std::is_same_v<Value, std::string>) {
          check_text(option, text);
          *value = text;
        } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
          check_text(option, text);
          value->push_back(text);
        } else if constexpr (Is_optional<Value>::value) {
          assign_number(option, text, value->emplace());
        } else {
          assign_number(option, text, *value);
        }
      },
      option.value);
}

std::vector<Option> given_options(Skeletonize_options& options)
{
  Skeletonize_options unset;
  const std::vector<Option> defaults = options_of(unset);
  std::vector<Option> result = options_of(options);
  std::size_t row = 0;
  const auto is_default = [&](const Option& option) { return text_of(option) == text_of(defaults[row++]); };
  result.erase(std::remove_if(result.begin(), result.end(), is_default), result.end());
  return result;
}

std::vector<std::pair<std::string, std::string*>> other_files(Skeletonize_options& options)
{
  std::vector<std::pair<std::string, std::string*>> result;
  for (const Option& option : options_of(options)) {
    if (option.argument == argument_of_files && std::holds_alternative<std::string*>(option.value)) {
      result.emplace_back("--" + option.name, std::get<std::string*>(option.value));
    }
  }
  return result;
}

std::vector<std::pair<std::string, std::string>> given_files(Skeletonize_options options)
{
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& [option, file] : other_files(options)) {
    if (!file->empty()) {
      result.emplace_back(option, *file);
    }
  }
  return result;
}

std::ptrdiff_t number_of_results_on_standard_output(const Skeletonize_options& options)
{
  const auto files = given_files(options);
  return std::count(options.outputs.begin(), options.outputs.end(), standard_stream) +
         std::count_if(files.begin(), files.end(), [](const auto& file) { return file.second == standard_stream; });
}

void check_applicability(const Skeletonize_options& options, unsigned kinds)
{
  Skeletonize_options copy = options;
  for (const Option& option : given_options(copy)) {
    const std::string remedy = "; leave it out" + (option.remedy.empty() ? "" : " or " + option.remedy);
    if ((option.kinds & kinds) == 0) {
      refuse(option, "does not apply to " + words_for(kinds) + remedy);
    }
    if (!option.method.empty() && option.method != options.method) {
      refuse(option, "does not apply to the " + options.method + " method" + remedy);
    }
  }
}

} // namespace cscd
