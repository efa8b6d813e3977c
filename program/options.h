// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands and their options: one table each. Command line, help, checks, report and the arguments of the Python
// module are made of them.

#ifndef CSCD_PROGRAM_OPTIONS_H
#define CSCD_PROGRAM_OPTIONS_H

#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Options.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cscd {

/// The arguments cannot be obeyed. The message names the argument and the remedy.
struct Usage_error : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

/// The name that means standard input or standard output.
inline constexpr const char* standard_stream = "-";

/// \name Values of options
/// @{
inline constexpr const char* local_method = "local";
inline constexpr const char* published_method = "published";
inline constexpr const char* graph_domain = "graph";
inline constexpr const char* automatic_borders = "auto";
inline constexpr const char* bridged_borders = "bridge";
inline constexpr const char* open_borders = "open";
inline constexpr const char* automatic_shape = "auto";
inline constexpr const char* surface_shape = "surface";
inline constexpr const char* tree_shape = "tree";
inline constexpr const char* thickest_root = "thickest";
inline constexpr const char* lowest_root = "lowest";
inline constexpr const char* longest_root = "longest";
inline constexpr const char* estimated_radii = "estimated";
inline constexpr const char* own_radii = "own";
/// @}

/// The voxels of a volume that belong to a body, and their connectivity.
struct Volume_options : CSCD::Voxel_selection
{
  bool resumes = false;        ///< labels whose files are there are left out
  unsigned connectivity = 26;  ///< or 6: the number of neighbors of a voxel
  bool keeps_cavities = false; ///< as surfaces that get skeletons of their own
};

/// The options of `cscd skeletonize`.
struct Skeletonize_options
{
  std::string input;                ///< a file name, or `standard_stream`
  std::string format;               ///< of the input: an ending without its dot; by that of its name if empty
  std::vector<std::string> outputs; ///< file names, or `standard_stream` for GEL's graph format
  std::string method = local_method;
  std::string domain;               ///< `graph_domain` if the input is treated as a graph, or empty
  unsigned number_of_neighbors = 0; ///< of each point of a graph; 0 for the default
  bool is_literal = false;          ///< of the published method: as printed where the default differs
  std::string shape = automatic_shape;
  std::string root; ///< three coordinates with commas between, the name of a rule, or empty
  std::string borders = automatic_borders;
  std::optional<double> wrap; ///< size of the gaps of a mesh that a wrap around it closes, relative to its diagonal
  double detail = CSCD::Options().detail;
  double spacing = 0;
  unsigned seed = 0;
  unsigned number_of_threads = 0;            ///< 0 for as many as the machine has
  std::size_t maximum_number_of_sources = 0; ///< of separators; 0 for the default of the method
  Volume_options volume;
  CSCD::internal::Simplification_parameters fragments; ///< the treatment of components that are fragments
  CSCD::Swc_options swc;
  std::string branches;       ///< file name for the table of branches, `standard_stream`, or empty
  std::string nodes;          ///< likewise for the table of nodes
  std::string cylinders;      ///< likewise for the cylinders of a scan of trees
  double breast_height = 1.3; ///< in the unit of the input
  std::string correspondence; ///< likewise for the node and branch of every vertex
  std::string report;         ///< likewise for the report as JSON
  bool is_quiet = false;
};

/// The options of `cscd evaluate`.
struct Evaluate_options
{
  std::string input;                   ///< a file name, or `standard_stream`
  std::string format;                  ///< of the input: an ending without its dot; by that of its name if empty
  std::string skeleton;                ///< a file name, or `standard_stream` for GEL's graph format
  std::string radii = estimated_radii; ///< or `own_radii`
  std::size_t resolution = 200;        ///< cells of the reconstructed surfaces along the diagonal of the bounding box
  bool is_json = false;
  bool is_quiet = false;
};

/// The options of `cscd compare`.
struct Compare_options
{
  std::string first;            ///< a file name, or `standard_stream` for GEL's graph format
  std::string second;           ///< likewise
  double match_distance = 0.02; ///< relative to the diagonal of the bounding box of both
  bool is_json = false;
};

/// The options of `cscd simplify`.
struct Simplify_options
{
  std::string skeleton;             ///< a file name, or `standard_stream` for GEL's graph format
  std::vector<std::string> outputs; ///< file names, or `standard_stream` for GEL's graph format
  std::string mesh;                 ///< a file name, `standard_stream`, or empty
  std::string format;               ///< of the mesh: an ending without its dot; by that of its name if empty
  CSCD::internal::Simplification_parameters steps;
  std::string root; ///< three coordinates with commas between, the name of a rule, or empty
  CSCD::Swc_options swc;
  bool is_quiet = false;
};

/// The common options of the commands on the skeleton of a mesh.
struct Application_options
{
  std::string input;  ///< a file name, or `standard_stream`
  std::string format; ///< of the input: an ending without its dot; by that of its name if empty
  std::string output; ///< a file name, or `standard_stream`
  bool is_quiet = false;
};

/// The options of `cscd segment`.
struct Segment_options : Application_options
{
  std::size_t number_of_parts = 0; ///< 0 lets the shape decide
};

/// The options of `cscd loops`.
struct Loops_options : Application_options
{
  double min_depth = CSCD::default_min_constriction_depth;
};

/// \name Kinds of input, to be joined by `|`
/// @{
inline constexpr unsigned mesh_input = 1;
inline constexpr unsigned point_input = 2;
inline constexpr unsigned volume_input = 4;
inline constexpr unsigned graph_input = 8;
inline constexpr unsigned any_input = mesh_input | point_input | volume_input | graph_input;
/// @}

/// The place of the value of an option.
using Option_value =
    std::variant<bool*, unsigned*, std::size_t*, double*, std::optional<int>*, std::optional<CSCD::Voxel_label>*,
                 std::optional<double>*, std::string*, std::vector<std::string>*>;

/// A row of a table of options: name, place of the value, range, and where the option applies.
struct Option
{
  std::string name;     ///< without dashes; in upper case if it is an argument without a name
  Option_value value;   ///< a member of the options of the table
  std::string argument; ///< the word of the help for the value; empty for flags
  std::string help;     ///< a phrase
  std::string group{};  ///< in the help
  char letter = 0;      ///< the short name; 0 for none
  bool is_required = false;
  std::vector<std::string> choices{}; ///< the values that are allowed; if empty, the range decides
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool excludes_least = false;
  std::function<std::string(const std::string&)> check{}; ///< the fault of a text, or empty
  unsigned kinds = any_input;                             ///< of input: the option applies to these
  std::string method{};                                   ///< the only one that has the option; empty if all have it
  std::string remedy{};                                   ///< where the option does not apply, besides leaving it out
  bool needs_all_methods = false;                         ///< other values than the default are of other methods

  /// \name Setters
  /// Each returns the row, so that calls chain.
  /// @{
  Option& one_of(std::vector<std::string> values) { return choices = std::move(values), *this; }
  Option& at_least(double bound) { return least = bound, *this; }
  Option& above(double bound) { return excludes_least = true, at_least(bound); }
  Option& in(double first, double last) { return most = last, at_least(first); }
  Option& checked_by(std::function<std::string(const std::string&)> fault) { return check = std::move(fault), *this; }
  /// The option applies to these kinds of input only. \param other remedy besides leaving it out
  Option& of(unsigned input_kinds, std::string other = "")
  {
    return kinds = input_kinds, remedy = std::move(other), *this;
  }
  /// The option applies to this method only. \param other remedy besides leaving it out
  Option& of_method(std::string name_of_method, std::string other = "")
  {
    return method = std::move(name_of_method), remedy = std::move(other), *this;
  }
  /// A program with the local method alone has the default value only.
  Option& of_other_methods() { return needs_all_methods = true, *this; }
  Option& required() { return is_required = true, *this; }
  Option& with_letter(char short_name) { return letter = short_name, *this; }
  /// @}
};

/// \name The tables
/// The rows refer to `options`, which must outlive them.
/// @{
std::vector<Option> options_of(Skeletonize_options& options);
std::vector<Option> options_of(Evaluate_options& options);
std::vector<Option> options_of(Compare_options& options);
std::vector<Option> options_of(Simplify_options& options);
/// The table of `cscd diameter`. \param output describes the file
std::vector<Option> options_of(Application_options& options,
                               const std::string& output = "one value a line, in the order of the vertices");
std::vector<Option> options_of(Segment_options& options);
std::vector<Option> options_of(Loops_options& options);
/// @}

/// \name Commands
/// \throw Usage_error if the options cannot be obeyed, `CSCD::File_error`, `CSCD::Input_error`
/// @{

/// Reads a mesh, points, a volume or a graph, skeletonizes it and writes the results.
void skeletonize(const Skeletonize_options& options);

/// Reads a mesh and a skeleton, measures the skeleton and writes the measures.
void evaluate(const Evaluate_options& options);

/// Reads two skeletons and writes a comparison.
void compare(const Compare_options& options);

/// Reads a skeleton, simplifies it and writes it.
void simplify(const Simplify_options& options);

/// Reads a mesh, segments it and writes the number of the part of each face, one a line.
void segment(const Segment_options& options);

/// Reads a mesh and writes the shape diameter at each of its vertices, one a line.
void write_diameters(const Application_options& options);

/// Reads a mesh and writes its handle loops, tunnel loops and constrictions, in the format of the output's ending.
void write_loops(const Loops_options& options);
/// @}

/// The fault of the value `root` of `--root`; empty without a fault.
std::string check_root(const std::string& root);

/// \throw Usage_error if there are several results on standard output
void check_standard_output(std::ptrdiff_t number_of_results);

/// Whether the option affects the computation of a skeleton. Such options are arguments in Python.
bool is_of_method(const Option& option);

/// The name of the argument in Python.
std::string python_name(const Option& option);

/// The value as text; empty without a value.
std::string text_of(const Option& option);

/// Sets the value. \throw Usage_error naming the option and its range if `text` is not such a value, or is left out
void assign(const Option& option, const std::string& text);

/// The rows of the table of `options` whose values are not the defaults.
std::vector<Option> given_options(Skeletonize_options& options);

/// All options, with dashes, for other files than those of the skeleton, and the places of the names of the files.
std::vector<std::pair<std::string, std::string*>> other_files(Skeletonize_options& options);

/// The options, with dashes, that name other files than those of the skeleton, and these names.
std::vector<std::pair<std::string, std::string>> given_files(Skeletonize_options options);

/// The number of results that go to standard output.
std::ptrdiff_t number_of_results_on_standard_output(const Skeletonize_options& options);

/// Refuses options that do not apply to the input or the method. One wording: option, reason, remedy.
/// \param kinds the possible kinds of input
/// \throw Usage_error
void check_applicability(const Skeletonize_options& options, unsigned kinds);

} // namespace cscd

#endif // CSCD_PROGRAM_OPTIONS_H
