// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of the program and their arguments.

#ifndef CSCD_PROGRAM_COMMANDS_H
#define CSCD_PROGRAM_COMMANDS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
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
/// @}

/// What to do with components of a skeleton that are fragments.
struct Fragment_options
{
  std::size_t min_component_size = 0; ///< in vertices or points, or in nodes of a skeleton from a file; 0 keeps all
  bool joins_components = false;
};

/// What SWC files tell besides the skeleton.
struct Swc_arguments
{
  std::optional<int> type;               ///< of all nodes but the soma; by default by their degrees
  std::optional<double> min_soma_radius; ///< of the thickest node, for it to be the soma; by default there is none
  double scale = 1;                      ///< of coordinates and radii
};

/// Which voxels of a volume are of a body, and how they are connected.
struct Volume_options
{
  std::optional<std::uint32_t> label; ///< of the body; without it and the others all voxels that are not 0 are of it
  std::optional<double> threshold;    ///< voxels of at least this value are of the body
  bool has_all_labels = false;        ///< each label is a body of its own
  unsigned int connectivity = 26;     ///< or 6: how many neighbors a voxel is joined to
  bool keeps_cavities = false;        ///< as surfaces that get skeletons of their own
};

/// What to skeletonize, how, and where the results go.
struct Skeletonize_options
{
  std::string input;                ///< a file name, or `standard_stream`
  std::string format;               ///< of the input: an ending without its dot; by that of its name if empty
  std::vector<std::string> outputs; ///< file names, or `standard_stream` for GEL's graph format
  std::string method = local_method;
  std::string domain;                   ///< what the input is taken for: `graph_domain`, or by what it has if empty
  unsigned int number_of_neighbors = 0; ///< to which points of a graph are joined; 0 for the default
  bool is_literal = false;              ///< of the published method: as printed where the default differs
  std::string shape = automatic_shape;  ///< what points sample: the surface of a body, or trees and other thin shapes
  std::string root;                     ///< three coordinates with commas between, the name of a rule, or empty
  std::string borders;                  ///< what becomes of those of a mesh; `automatic_borders` if empty
  std::optional<double> wrap;           ///< size of the gaps of a mesh that a wrap around it closes, to its diagonal
  std::optional<double> detail; ///< how small a limb may be to get a branch, from 0 to 1; of the local method only
  unsigned int seed = 0;
  unsigned int number_of_threads = 0;        ///< 0 for all that the machine has
  std::size_t maximum_number_of_sources = 0; ///< from which separators are sought; 0 for the default of the method
  Volume_options volume;
  Fragment_options fragments;
  Swc_arguments swc;
  std::string branches;       ///< file name for the table of branches, `standard_stream`, or empty
  std::string nodes;          ///< likewise for the table of nodes
  std::string cylinders;      ///< likewise for the cylinders of a scan of trees
  double breast_height = 1.3; ///< in the unit of the input
  std::string correspondence; ///< likewise for the node and branch of every vertex
  std::string labelled;       ///< likewise for the input with node, branch, radius and distance at its vertices
  std::string report;         ///< file name for the report as JSON, `standard_stream`, or empty
  std::string html;           ///< likewise for the viewer page
  bool is_quiet = false;
};

/// The names of the radii that a skeleton is measured with.
inline constexpr const char* estimated_radii = "estimated";
inline constexpr const char* own_radii = "own";

/// What to measure against what, and how.
struct Evaluate_options
{
  std::string input;                   ///< a file name, or `standard_stream`
  std::string format;                  ///< of the input: an ending without its dot; by that of its name if empty
  std::string skeleton;                ///< a file name, or `standard_stream` for GEL's graph format
  std::string radii = estimated_radii; ///< or `own_radii`
  std::size_t resolution = 200;        ///< cells of the reconstructed surfaces along the diagonal of the bounding box
  std::string convolution_surface;     ///< file name for it as a mesh, or empty
  std::string round_cones;             ///< likewise
  bool is_json = false;
  bool is_quiet = false;
};

/// Which two skeletons to compare, and how.
struct Compare_options
{
  std::string first;            ///< a file name, or `standard_stream` for GEL's graph format
  std::string second;           ///< likewise
  double match_distance = 0.02; ///< relative to the diagonal of the bounding box of both
  bool is_json = false;
};

/// How to simplify which skeleton; 0 is for what is not to be done.
struct Simplify_options
{
  std::string skeleton;             ///< a file name, or `standard_stream` for GEL's graph format
  std::vector<std::string> outputs; ///< file names, or `standard_stream` for GEL's graph format
  std::string mesh;                 ///< a file name, `standard_stream`, or empty
  std::string format;               ///< of the mesh: an ending without its dot; by that of its name if empty
  double min_significance = 0;
  double min_length = 0; ///< in the unit of the skeleton
  double min_length_over_radius = 0;
  double junction_distance = 0; ///< in radii
  double spacing = 0;           ///< in the unit of the skeleton
  double spacing_over_radius = 0;
  std::size_t number_of_smoothing_steps = 0;
  Fragment_options fragments;
  std::string root; ///< three coordinates with commas between, the name of a rule, or empty
  Swc_arguments swc;
  bool is_quiet = false;
};

/// Reads a mesh or points, skeletonizes it and writes the results.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void skeletonize(const Skeletonize_options& options);

/// Reads a mesh and a skeleton, measures the skeleton and writes the measures.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void evaluate(const Evaluate_options& options);

/// Reads two skeletons and writes how alike they are.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void compare(const Compare_options& options);

/// Reads a skeleton, simplifies it and writes it.
/// \throw Usage_error, `CSCD::File_error`, `CSCD::Input_error`
void simplify(const Simplify_options& options);

/// What is wrong with the value `root` of `--root`; empty if nothing is.
std::string check_root(const std::string& root);

/// `text` with control characters, which could stand in a file name and act on a terminal, as escape sequences.
std::string printable(const std::string& text);

} // namespace cscd

#endif // CSCD_PROGRAM_COMMANDS_H
