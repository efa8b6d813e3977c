// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program cscd: skeletons of meshes and point sets from the command line, and how good they are.

#include "applications.h"
#include "commands.h"
#include "memory.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/exceptions.h>
#include <CSCD/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

enum Exit_status
{
  done = 0,
  bad_usage = 1,
  bad_input = 2,
  internal_failure = 3
};

constexpr const char* skeletonize_examples =
    R"(  cscd skeletonize bunny.off -o bunny.graph          the skeleton as a graph
  cscd skeletonize bunny.off --html bunny.html       a page to look at it
  cscd skeletonize bunny.stl -o b.swc -o b.vtp --report b.json
  cscd skeletonize bunny.off -o bunny.glb --root lowest     a rig: the mesh with joints and weights
  cscd skeletonize cloud.xyz -o cloud.graph          points are made a surface first
  cscd skeletonize oak.xyz --shape tree -o oak.swc --report oak.json     a scan of a tree
  cscd skeletonize soup.obj --as graph -o soup.graph     no surface: the edges as a graph
  cscd skeletonize vessels.nii.gz --threshold 150 -o vessels.swc -o nodes.nrrd
  cscd skeletonize labels.nrrd --all-labels -o cell.swc     cell_1.swc, cell_2.swc and so on
  cat bunny.ply | cscd skeletonize - --format ply -o - > bunny.graph
)";

constexpr const char* evaluate_examples =
    R"(  cscd evaluate bunny.off bunny.graph                how good a skeleton is, made by any program
)";

constexpr const char* compare_examples =
    R"(  cscd compare bunny.graph other.swc                 how alike two skeletons are
)";

constexpr const char* simplify_examples =
    R"(  cscd simplify bunny.json -o less.json --min-significance 1     leave out what hardly stands out
  cscd simplify neuron.swc -o one.swc --join --min-component 20 --spacing 0.5r
)";

constexpr const char* diameter_examples =
    R"(  cscd diameter bunny.off -o bunny.txt               how thick the body is at each vertex, one value a line
)";

constexpr const char* segment_examples =
    R"(  cscd segment bunny.off -o bunny.seg                the part of each face, one number a line
  cscd segment bunny.off -o bunny.seg --parts 5
)";

constexpr const char* loops_examples =
    R"(  cscd loops bunny.off -o loops.json                 closed geodesics around handles, tunnels and constrictions
  cscd loops bunny.off -o necks.vtp --constrictions
)";

constexpr const char* explanations = R"(
Input: triangle or polygon meshes: .off .obj .ply .stl .vtp .vtk .glb .gltf .ngmesh; points: .xyz .pwn .pts .txt
.csv .asc .pcd .las, or .ply .off .vtp .vtk without faces; volumes, by cscd skeletonize alone: .nrrd .nhdr .nii .nii.gz
.mha .mhd .tif .tiff; meshes and points also with .gz or .zst behind. What has to be repaired is named on standard error.
Output: .graph .json .obj .ply .polylines.txt .swc .vtp .graphml; a file appears only when it is complete.
Rigs, by cscd skeletonize alone: .glb with the mesh and weights.
Skeletons to measure or simplify: .graph .json .obj .ply .polylines.txt .swc .vtp.
Exit status: 0 done, 1 bad usage, 2 bad input or a file that cannot be read or written, 3 internal failure.)";

/// Puts the examples of a command, or of all, before the rest of its help.
class Examples_first : public CLI::Formatter
{
public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
  {
    const std::string command = app->get_parent() != nullptr ? app->get_name() : "";
    std::string examples = "Examples:\n";
    for (const auto& [its_command, its_examples] :
         {std::pair("skeletonize", skeletonize_examples), std::pair("evaluate", evaluate_examples),
          std::pair("compare", compare_examples), std::pair("simplify", simplify_examples),
          std::pair("diameter", diameter_examples), std::pair("segment", segment_examples),
          std::pair("loops", loops_examples)}) {
      if (command.empty() || command == its_command) {
        examples += its_examples;
      }
    }
    return examples + "\n" + CLI::Formatter::make_help(app, name, mode);
  }
};

/// The values of `--format`: endings without their dots.
std::vector<std::string> formats_of(std::vector<std::string> endings)
{
  for (std::string& ending : endings) {
    ending.erase(0, 1);
  }
  return endings;
}

/// Those of meshes and points, each once, and `others`.
std::vector<std::string> formats_of_inputs(const std::vector<std::string>& others = {})
{
  std::vector<std::string> result = formats_of(CSCD::mesh_endings());
  result.insert(result.end(), others.begin(), others.end());
  for (const std::string& format : formats_of(CSCD::point_endings())) {
    if (std::find(result.begin(), result.end(), format) == result.end()) {
      result.push_back(format);
    }
  }
  return result;
}

/// Lets `option` take `formats`, each also with the ending of a compressed file.
void check_format(CLI::Option* option, const std::vector<std::string>& formats)
{
  const CLI::IsMember is_known(formats);
  const auto check = [is_known](const std::string& format) {
    return is_known(CSCD::without_compression_ending(format));
  };
  option->check(check, is_known.get_description());
}

/// Refuses what is no integer that is at least 1. CLI11's own check names bounds of 300 digits.
std::string check_count(const std::string& text)
{
  const bool is_count =
      text.find_first_not_of("0123456789") == std::string::npos && text.find_first_not_of('0') != std::string::npos;
  return is_count ? "" : "must be an integer that is at least 1, not " + text;
}

/// Refuses an empty name.
std::string check_name(const std::string& text)
{
  return text.empty() ? "must not be empty" : "";
}

/// Refuses what is no number that is at least 0, with an r behind it if it may be one of radii.
std::string check_length(const std::string& text, bool may_be_relative)
{
  const bool is_relative = may_be_relative && !text.empty() && text.back() == 'r';
  const std::string number = text.substr(0, text.size() - (is_relative ? 1 : 0));
  double value = 0;
  const bool is_length = CLI::detail::lexical_cast(number, value) && value >= 0 && std::isfinite(value);
  return is_length ? "" : "must be a number that is at least 0, not " + text;
}

void add_fragments(CLI::App& command, cscd::Fragment_options& options, const std::string& unit)
{
  command
      .add_option("--min-component", options.min_component_size,
                  "leave out components of less than N " + unit + ", but for the largest")
      ->check(check_count)
      ->type_name("N");
  command.add_flag("--join", options.joins_components, "join components into one by the shortest straight edges");
}

void add_root_and_swc(CLI::App& command, std::string& root, cscd::Swc_arguments& swc)
{
  command
      .add_option("--root", root,
                  "where the skeleton begins, for SWC and orders of branches: the node next to a point (of a tree the "
                  "foot of its trunk), thickest, lowest, or the thicker end of the longest path")
      ->check(cscd::check_root)
      ->type_name("X,Y,Z|thickest|lowest|longest");
  command
      .add_option("--swc-type", swc.type, "type of the nodes in SWC, such as 2 axon, 3 dendrite; by default 0, 5, 6")
      ->check(CLI::Range(0, 7))
      ->type_name("T");
  command
      .add_option("--soma", swc.min_soma_radius, "in SWC, the thickest node is the soma if its radius is at least R")
      ->check([](const std::string& text) { return check_length(text, false); })
      ->type_name("R");
  command.add_option("--swc-scale", swc.scale, "what coordinates and radii in SWC are multiplied by")
      ->check(CLI::PositiveNumber)
      ->type_name("S");
}

void add_volume(CLI::App& command, cscd::Volume_options& options)
{
  command.add_option("--label", options.label, "of a volume: the voxels with this label are the body")
      ->check(check_count)
      ->type_name("L");
  command.add_flag("--all-labels", options.has_all_labels,
                   "of a volume: each label is a body with files of its own, whose names get _L before the ending");
  command
      .add_option("--threshold", options.threshold,
                  "of a volume: voxels of at least this value are the body; by default all that are not 0")
      ->type_name("T");
  command
      .add_option("--connectivity", options.connectivity,
                  "of a volume: the number of neighbors to which voxels of a body are joined; with 26 those of the "
                  "background have 6, and with 6 they have 26")
      ->check(CLI::IsMember({6, 26}))
      ->capture_default_str();
  command.add_flag("--keep-cavities", options.keeps_cavities,
                   "of a volume: the surfaces of cavities get skeletons, too, instead of being filled");
}

/// Adds the files that are written besides the skeleton.
void add_further_outputs(CLI::App& command, cscd::Skeletonize_options& options)
{
  const auto add_file = [&command](const char* name, std::string& file, const char* content) {
    command.add_option(name, file, content)->check(check_name)->type_name("FILE");
  };
  add_file("--branches", options.branches, "file for the table of branches as CSV, or -");
  add_file("--nodes", options.nodes, "file for the table of nodes as CSV, or -");
  add_file("--cylinders", options.cylinders,
           "of a scan of trees: file for its cylinders as CSV in the columns of TreeQSM, or -");
  command
      .add_option("--breast-height", options.breast_height,
                  "where diameters of trunks are measured, above the root, in the unit of the scan")
      ->check(CLI::PositiveNumber)
      ->type_name("H")
      ->capture_default_str();
  add_file("--correspondence", options.correspondence,
           "file for the node and branch of each vertex or point as CSV, or -");
  add_file("--labelled", options.labelled,
           "file for the input as PLY with node, branch, radius and distance to the skeleton at each vertex, or -");
  add_file("--report", options.report, "file for counts, timings and warnings as JSON, or -");
  add_file("--html", options.html, "file for a page that shows surface and skeleton, or -");
}

void add_skeletonize(CLI::App& app, cscd::Skeletonize_options& options)
{
  CLI::App* command = app.add_subcommand("skeletonize", "compute the curve skeleton of a triangle mesh or a point set");
  command->add_option("INPUT", options.input, "file of a mesh, of points or of a volume, or - for standard input")
      ->required();
  command
      ->add_option("-o,--output", options.outputs,
                   "skeleton file, its ending names the format; - writes .graph to standard output; may be repeated")
      ->type_name("OUT")
      ->allow_extra_args(false);
  check_format(
      command->add_option("--format", options.format, "format of INPUT instead of that of its ending, needed for -"),
      formats_of_inputs({"graph", "edges", "json", "swc"}));
  command
      ->add_option("--as", options.domain,
                   "take INPUT for a graph: a .graph, .json, .swc, .polylines.txt, lines of .obj, edges of .ply, the "
                   "edges of a mesh of any kind, points joined to their neighbors, or .edges: six coordinates a line")
      ->check(CLI::IsMember({cscd::graph_domain}));
  command
      ->add_option("--neighbors", options.number_of_neighbors,
                   "of a graph of points: to how many others each is joined; by default 24")
      ->check(check_count)
      ->type_name("K");
  command->add_option("--method", options.method, "the algorithms: those of CSCD, or those of the paper, much slower")
      ->check(CLI::IsMember({cscd::local_method, cscd::published_method}))
      ->capture_default_str();
  command->add_flag("--literal", options.is_literal,
                    "published method: as printed, with the tree, sources one by one, overlap by crossings");
  command
      ->add_option(
          "--shape", options.shape,
          "what points sample: the surface of a body, or trees and other thin shapes; auto decides by the points")
      ->check(CLI::IsMember({cscd::automatic_shape, cscd::surface_shape, cscd::tree_shape}))
      ->capture_default_str();
  command
      ->add_option("--borders", options.borders,
                   "of a mesh: bridge them all, take components with borders for sheets with separators from border "
                   "to border, or decide by the shape, which is the default")
      ->check(CLI::IsMember({cscd::automatic_borders, cscd::bridged_borders, cscd::open_borders}));
  command
      ->add_option("--wrap", options.wrap,
                   "of a mesh: wrap it first by a closed surface, which joins parts that touch or cut each other and "
                   "closes holes, gaps and hollows narrower than SIZE, relative to the diagonal, such as 0.01")
      ->type_name("SIZE");
  command
      ->add_option("--detail", options.detail,
                   "how small a limb may be to get a branch, from 0 (none) to 1 (every bump); by default 0.5")
      ->check(CLI::Range(0., 1.))
      ->type_name("D");
  command->add_option("--seed", options.seed, "seed of the random choice of sources")->capture_default_str();
  command->add_option("--threads", options.number_of_threads, "number of threads; the skeleton does not depend on it")
      ->check(check_count)
      ->type_name("N");
  command
      ->add_option(
          "--separators", options.maximum_number_of_sources,
          "greatest number of points from which separators are sought; by default the shape decides, or 3000 with the "
          "published method")
      ->check(check_count)
      ->type_name("N");
  add_volume(*command, options.volume);
  add_fragments(*command, options.fragments, "vertices or points");
  add_root_and_swc(*command, options.root, options.swc);
  add_further_outputs(*command, options);
  command->add_flag("-q,--quiet", options.is_quiet, "print nothing but errors");
}

void add_evaluate(CLI::App& app, cscd::Evaluate_options& options)
{
  CLI::App* command = app.add_subcommand("evaluate", "measure how good a skeleton is for its mesh or points");
  command->add_option("INPUT", options.input, "file of a mesh or of points, or - for standard input")->required();
  command
      ->add_option("SKELETON", options.skeleton,
                   "skeleton file, its ending names the format; - reads .graph from standard input")
      ->required();
  check_format(
      command->add_option("--format", options.format, "format of INPUT instead of that of its ending, needed for -"),
      formats_of_inputs());
  command
      ->add_option("--radii", options.radii,
                   "radii of the reconstructed surfaces: estimated from the input, or the skeleton's own")
      ->check(CLI::IsMember({cscd::estimated_radii, cscd::own_radii}))
      ->capture_default_str();
  command
      ->add_option("--resolution", options.resolution,
                   "cells of the reconstructed surfaces along the diagonal of the bounding box")
      ->check(CLI::Range(1, 10000))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--convolution-surface", options.convolution_surface,
                   "file for the convolution surface as a mesh: .off .obj .ply .stl")
      ->check(check_name)
      ->type_name("FILE");
  command->add_option("--round-cones", options.round_cones, "file for the union of round cones as a mesh")
      ->check(check_name)
      ->type_name("FILE");
  command->add_flag("--json", options.is_json, "write all measures as JSON");
  command->add_flag("-q,--quiet", options.is_quiet, "do not print what was repaired");
}

void add_compare(CLI::App& app, cscd::Compare_options& options)
{
  CLI::App* command = app.add_subcommand("compare", "measure how alike two skeletons are");
  command->add_option("A", options.first, "skeleton file; - reads .graph from standard input")->required();
  command->add_option("B", options.second, "skeleton file; - reads .graph from standard input")->required();
  command
      ->add_option("--match-distance", options.match_distance,
                   "up to which tips, junctions and branches count as the same, relative to the diagonal of the "
                   "bounding box")
      ->check([](const std::string& text) {
        return !text.empty() && text.front() == '-' ? "must not be negative" : std::string();
      })
      ->type_name("D")
      ->capture_default_str();
  command->add_flag("--json", options.is_json, "write all figures as JSON");
}

void add_simplify(CLI::App& app, cscd::Simplify_options& options)
{
  CLI::App* command =
      app.add_subcommand("simplify", "leave out, merge, join, sample anew or smooth parts of a skeleton");
  command
      ->add_option("SKELETON", options.skeleton,
                   "skeleton file, its ending names the format; - reads .graph from standard input")
      ->required();
  command
      ->add_option("-o,--output", options.outputs,
                   "skeleton file, its ending names the format; - writes .graph to standard output; may be repeated")
      ->type_name("OUT")
      ->allow_extra_args(false)
      ->required();
  command->add_option(
      "--mesh", options.mesh,
      "the mesh of the skeleton: what is inside stays inside, and radii are estimated if there are none");
  check_format(
      command->add_option("--format", options.format, "format of the mesh instead of that of its ending, needed for -"),
      formats_of(CSCD::mesh_endings()));
  const auto add_length = [&](const std::string& name, double& value, const std::string& description) {
    command->add_option(name, value, description)
        ->check([](const std::string& text) { return check_length(text, false); })
        ->type_name("X");
  };
  add_length("--min-significance", options.min_significance,
             "prune limbs that reach less than this beyond the body they stand on, in their radii");
  add_length("--min-length", options.min_length, "prune limbs that are shorter");
  add_length("--min-length-over-radius", options.min_length_over_radius,
             "prune limbs that are shorter, in their radii");
  add_length("--merge-junctions", options.junction_distance,
             "merge junctions that are nearer to each other along a branch, in radii");
  command
      ->add_option_function<std::string>(
          "--spacing",
          [&options](const std::string& text) {
            const bool is_relative = text.back() == 'r';
            CLI::detail::lexical_cast(text.substr(0, text.size() - (is_relative ? 1 : 0)),
                                      is_relative ? options.spacing_over_radius : options.spacing);
          },
          "distance of nodes along branches; with an r behind it, as in 0.5r, in local radii")
      ->check([](const std::string& text) { return check_length(text, true); })
      ->type_name("D");
  command->add_option("--smooth", options.number_of_smoothing_steps, "number of steps of smoothing")
      ->check(check_count)
      ->type_name("N");
  add_fragments(*command, options.fragments, "nodes");
  add_root_and_swc(*command, options.root, options.swc);
  command->add_flag("-q,--quiet", options.is_quiet, "print nothing but errors");
}

/// The arguments that the commands which use the skeleton of a mesh have in common.
CLI::App* add_application(CLI::App& app, const std::string& name, const std::string& description,
                          const std::string& output, cscd::Application_options& options)
{
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("INPUT", options.input, "file of a mesh, or - for standard input")->required();
  command->add_option("-o,--output", options.output, output)->type_name("OUT")->check(check_name)->required();
  check_format(
      command->add_option("--format", options.format, "format of INPUT instead of that of its ending, needed for -"),
      formats_of(CSCD::mesh_endings()));
  command->add_option("--report", options.report, "file for counts and measures as JSON, or -")
      ->check(check_name)
      ->type_name("FILE");
  command->add_flag("-q,--quiet", options.is_quiet, "do not print what was repaired");
  return command;
}

void add_segment(CLI::App& app, cscd::Segment_options& options)
{
  CLI::App* command = add_application(app, "segment", "segment a mesh into the parts that people would see",
                                      "file for the number of each face's part, one a line, or -", options);
  command->add_option("--parts", options.number_of_parts, "number of parts; by default the shape decides")
      ->check(check_count)
      ->type_name("N");
  command
      ->add_option("--by", options.by,
                   "what decides: the skeleton and the shape of the parts, or the thickness of the body alone")
      ->check(CLI::IsMember({cscd::by_skeleton, cscd::by_diameter}))
      ->capture_default_str();
}

void add_loops(CLI::App& app, cscd::Loops_options& options)
{
  CLI::App* command = add_application(
      app, "loops", "find closed geodesics around handles, tunnels and constrictions of the body of a mesh",
      "file for the loops: .json, or - for it, .html for a page, or as of skeletons, by the ending", options);
  command->add_flag("--handles", options.handles, "write handle loops; without such options, all kinds are written");
  command->add_flag("--tunnels", options.tunnels, "write tunnel loops");
  command->add_flag("--constrictions", options.constrictions, "write constrictions");
  command
      ->add_option("--min-depth", options.min_depth,
                   "minimum constriction depth (relative extra length of neighboring loops)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("D")
      ->capture_default_str();
}

/// Says what is wrong in one line.
void complain(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "cscd: " << cscd::printable(message) << std::endl;
}

constexpr const char* not_enough_memory = "not enough memory; simplify the input or use a machine with more";

/// Ends the program where a destructor has found no memory: those of JSON values need some.
[[noreturn]] void terminate()
{
  try {
    if (const std::exception_ptr exception = std::current_exception()) {
      std::rethrow_exception(exception);
    }
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "cscd: %s\n", not_enough_memory);
    std::_Exit(internal_failure);
  } catch (...) {
    std::fputs("cscd: internal failure; report it as CONTRIBUTING.md says, with the input\n", stderr);
  }
  std::abort();
}

/// The arguments, with `skeletonize` in front of those that name no command.
/// \throw cscd::Usage_error if there are none, or the first one is neither a command nor a file
std::vector<const char*> with_command(int argc, char** argv, const CLI::App& app)
{
  std::vector<const char*> result(argv, argv + argc);
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  const std::string commands = CLI::detail::join(names, ", ");
  if (argc < 2) {
    throw cscd::Usage_error("name an input, or a command: " + commands);
  }
  const std::string first = argv[1];
  if (std::count(names.begin(), names.end(), first) > 0 || first == "-h" || first == "--help" || first == "--version") {
    return result;
  }
  if (first.find_first_of("./-") == std::string::npos && !std::filesystem::exists(first)) {
    throw cscd::Usage_error(first + ": is neither a command nor a file; the commands are " + commands);
  }
  result.insert(result.begin() + 1, "skeletonize");
  return result;
}

int run(int argc, char** argv)
{
  CLI::App app("Curve skeletons of 3D shapes.", "cscd");
  app.formatter(std::make_shared<Examples_first>());
  app.set_version_flag("--version", std::string("cscd ") + CSCD_VERSION);
  app.footer(explanations);
  app.require_subcommand(1);
  cscd::Skeletonize_options skeletonize_options;
  cscd::Evaluate_options evaluate_options;
  cscd::Compare_options compare_options;
  add_skeletonize(app, skeletonize_options);
  add_evaluate(app, evaluate_options);
  add_compare(app, compare_options);
  cscd::Simplify_options simplify_options;
  add_simplify(app, simplify_options);
  cscd::Application_options diameter_options;
  add_application(app, "diameter", "estimate how thick the body of a mesh is at each vertex",
                  "file for one value a line, in the order of the vertices, or -", diameter_options);
  cscd::Segment_options segment_options;
  add_segment(app, segment_options);
  cscd::Loops_options loops_options;
  add_loops(app, loops_options);
  const std::vector<const char*> arguments = with_command(argc, argv, app);
  try {
    app.parse(int(arguments.size()), arguments.data());
  } catch (const CLI::Success& success) { // help or version
    return app.exit(success) == 0 ? done : internal_failure;
  } catch (const CLI::ParseError& error) {
    throw cscd::Usage_error(error.what());
  }
  if (app.got_subcommand("evaluate")) {
    cscd::evaluate(evaluate_options);
  } else if (app.got_subcommand("compare")) {
    cscd::compare(compare_options);
  } else if (app.got_subcommand("simplify")) {
    cscd::simplify(simplify_options);
  } else if (app.got_subcommand("segment")) {
    cscd::segment(segment_options);
  } else if (app.got_subcommand("diameter")) {
    cscd::write_diameters(diameter_options);
  } else if (app.got_subcommand("loops")) {
    cscd::write_loops(loops_options);
  } else {
    cscd::skeletonize(skeletonize_options);
  }
  std::cout.flush();
  if (!std::cout) {
    throw CSCD::File_error("standard output cannot be written; check the pipe or the disk");
  }
  return done;
}

} // namespace

int main(int argc, char** argv)
{
#ifdef __GLIBC__
  // Large arrays come and go. To give them back to the system and ask again takes a twelfth of a run on a large mesh.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
  std::set_terminate(terminate);
  cscd::limit_memory_to_available();
  try {
    return run(argc, argv);
  } catch (const cscd::Usage_error& error) {
    complain(std::string(error.what()) + "; see cscd --help");
    return bad_usage;
  } catch (const CSCD::File_error& error) {
    complain(error.what());
    return bad_input;
  } catch (const CSCD::Input_error& error) {
    complain(error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    complain(not_enough_memory);
    return internal_failure;
  } catch (const std::exception& error) {
    // oneTBB throws its own exception where there is no memory for the stack of a thread.
    complain(std::strstr(error.what(), "pthread_create") != nullptr
                 ? not_enough_memory
                 : std::string("internal failure: ") + error.what() +
                       "; report it as CONTRIBUTING.md says, with the input");
    return internal_failure;
  }
}
