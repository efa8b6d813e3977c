// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program cscd: skeletons of meshes and point sets from the command line, and their quality.

#include "memory.h"
#include "options.h"
#include "other_methods.h"
#include "write_report.h"
#include <CSCD/exceptions.h>
#include <CSCD/version.h>

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <utility>
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

/// A command: its row in the help, its options, and its function.
struct Command
{
  const char* name;
  const char* description;
  const char* examples;
  std::vector<cscd::Option> options;
  std::function<void()> run;
};

/// The command that `run` does with the options of its table.
template <class Options>
Command make_command(const char* name, const char* description, const char* examples, void (*run)(const Options&))
{
  const auto options = std::make_shared<Options>();
  return {name, description, examples, cscd::options_of(*options), [options, run] { run(*options); }};
}

std::vector<Command> make_commands()
{
  return {
      make_command(
          "skeletonize", "compute the curve skeleton of a mesh, of points, of a volume or of a graph",
          R"(  cscd bunny.off -o bunny.graph -o bunny.html          the skeleton as a graph, and a page to look at it
  cscd skeletonize bunny.off -o bunny.glb --root lowest     a rig: the mesh with joints and weights
  cscd oak.xyz --shape tree -o oak.swc --report oak.json    a scan of a tree
  cscd vessels.nii.gz --threshold 150 -o vessels.swc -o nodes.nrrd
  cscd soup.obj --as graph -o soup.graph                    no surface: the edges as a graph
  cat bunny.ply | cscd - --format ply -o - > bunny.graph
)",
          cscd::skeletonize),
      make_command("evaluate", "measure how good a skeleton is for its mesh or points",
                   "  cscd evaluate bunny.off bunny.graph            a skeleton made by any program\n", cscd::evaluate),
      make_command("compare", "measure how alike two skeletons are", "  cscd compare bunny.graph other.swc\n",
                   cscd::compare),
      make_command(
          "simplify", "prune, join or resample parts of a skeleton",
          R"(  cscd simplify bunny.json -o less.json --min-significance 1     without limbs that hardly stand out
  cscd simplify neuron.swc -o one.swc --join --min-component 20 --spacing 0.5r
)",
          cscd::simplify),
      make_command("segment", "segment a mesh into the parts that people would see",
                   "  cscd segment bunny.off -o bunny.seg --parts 5\n", cscd::segment),
      make_command("diameter", "estimate how thick the body of a mesh is at each vertex",
                   "  cscd diameter bunny.off -o bunny.txt\n", cscd::write_diameters),
      make_command("loops", "find closed geodesics around handles, tunnels and constrictions of the body of a mesh",
                   "  cscd loops bunny.off -o loops.json\n", cscd::write_loops)};
}

constexpr const char* explanations =
    R"(Meshes: .off .obj .ply .stl .vtp .vtk .glb .gltf; points: .xyz .pwn .pts .txt .csv .asc .pcd .las, or .ply
.off .vtp .vtk without faces; both also with .gz behind. Volumes: .nrrd .nhdr .nii .nii.gz .mha .mhd .tif .tiff.
Skeletons: .graph .json .obj .ply .polylines.txt .swc .vtp. A file appears only when it is complete. Repairs of the
input are named on standard error.
Exit status: 0 done, 1 bad usage, 2 bad input or a file that cannot be read or written, 3 internal failure.)";

/// Puts examples before the rest of a help.
class Examples_first : public CLI::Formatter
{
public:
  explicit Examples_first(std::string examples) : m_examples(std::move(examples))
  {
    constexpr std::size_t width_of_names = 34; // characters
    column_width(width_of_names);
  }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
  {
    return "Examples:\n" + m_examples + "\n" + CLI::Formatter::make_help(app, name, mode);
  }
  std::string make_usage(const CLI::App* app, std::string name) const override
  {
    return CLI::Formatter::make_usage(app, name) + "\n";
  }
  /// Groups are separated by one line, not by two.
  std::string make_group(std::string group, bool is_positional, std::vector<const CLI::Option*> options) const override
  {
    return CLI::Formatter::make_group(group, is_positional, options).substr(1) + (is_positional ? "\n" : "");
  }

private:
  std::string m_examples;
};

/// Behind the version of a program that has no more than the local method.
constexpr const char* local_method_only = " without the published method, graphs and wraps";

/// Sets the value of `option`. An r behind a spacing means radii: `rows` may have an option of its own for such
/// lengths.
void assign(const cscd::Option& option, const std::vector<cscd::Option>& rows, const std::string& text)
{
  const auto relative =
      std::find_if(rows.begin(), rows.end(), [](const cscd::Option& row) { return row.name == "spacing-over-radius"; });
  const bool is_relative = option.name == "spacing" && text.size() > 1 && text.back() == 'r';
  cscd::assign(is_relative && relative != rows.end() ? *relative : option,
               is_relative ? text.substr(0, text.size() - 1) : text);
}

void add_option(CLI::App& command, const cscd::Option& option, const std::vector<cscd::Option>& rows)
{
  const bool is_positional = std::isupper(static_cast<unsigned char>(option.name.front())) != 0;
  const std::string letter = option.letter != 0 ? std::string("-") + option.letter + "," : "";
  const std::string name = is_positional ? option.name : letter + "--" + option.name;
  if (std::holds_alternative<bool*>(option.value)) {
    command
        .add_flag_callback(
            name, [option] { cscd::assign(option, "true"); }, option.help)
        ->group(option.group);
    return;
  }
  const CLI::callback_t set = [option, rows](const CLI::results_t& texts) {
    for (const std::string& text : texts) {
      assign(option, rows, text);
    }
    return true;
  };
  const bool is_left_out = option.needs_all_methods && !cscd::has_all_methods;
  const std::string help =
      is_left_out ? "left out of this build; configure it with -DCSCD_WITH_ALL_METHODS=ON" : option.help;
  const std::string value = cscd::text_of(option);
  CLI::Option* added = command.add_option(name, set, help);
  added->type_name(option.argument)->default_str(value == "0" ? "" : value)->required(option.is_required);
  if (!is_positional) {
    added->group(option.group);
  }
  if (std::holds_alternative<std::vector<std::string>*>(option.value)) {
    added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
}

void add_command(CLI::App& app, const Command& command)
{
  CLI::App* added = app.add_subcommand(command.name, command.description);
  added->formatter(std::make_shared<Examples_first>(command.examples));
  added->get_help_ptr()->group(""); // readers of the help know this option
  for (const cscd::Option& option : command.options) {
    add_option(*added, option, command.options);
  }
}

/// Prints a fault in one line.
void complain(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "cscd: " << cscd::printable(message) << std::endl;
}

constexpr const char* not_enough_memory = "not enough memory; simplify the input or use a machine with more";

/// Ends the program if a destructor runs out of memory: destructors of JSON values need some.
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

/// The arguments. If the first one names no command, `skeletonize` stands in front.
/// \throw cscd::Usage_error without arguments, or if the first one is neither a command nor a file
std::vector<const char*> with_command(int argc, char** argv, const std::vector<Command>& commands)
{
  std::vector<const char*> result(argv, argv + argc);
  std::vector<std::string> names;
  for (const Command& command : commands) {
    names.emplace_back(command.name);
  }
  const std::string list = boost::algorithm::join(names, ", ");
  if (argc < 2) {
    throw cscd::Usage_error("name an input, or a command: " + list);
  }
  const std::string first = argv[1];
  if (std::count(names.begin(), names.end(), first) > 0 || first == "-h" || first == "--help" || first == "--version") {
    return result;
  }
  if (first.find_first_of("./-") == std::string::npos && !std::filesystem::exists(first)) {
    throw cscd::Usage_error(first + ": is neither a command nor a file; the commands are " + list);
  }
  result.insert(result.begin() + 1, "skeletonize");
  return result;
}

int run(int argc, char** argv)
{
  const std::vector<Command> commands = make_commands();
  CLI::App app("Curve skeletons of 3D shapes.", "cscd");
  app.set_version_flag("--version",
                       std::string("cscd ") + CSCD_VERSION + (cscd::has_all_methods ? "" : local_method_only));
  app.footer(explanations);
  app.require_subcommand(1);
  std::string examples;
  for (const Command& command : commands) {
    examples += command.examples;
    add_command(app, command);
  }
  app.formatter(std::make_shared<Examples_first>(examples));
  const std::vector<const char*> arguments = with_command(argc, argv, commands);
  try {
    app.parse(int(arguments.size()), arguments.data());
  } catch (const CLI::Success& success) { // help or version
    return app.exit(success) == 0 ? done : internal_failure;
  } catch (const CLI::ParseError& error) {
    throw cscd::Usage_error(error.what());
  }
  for (const Command& command : commands) {
    if (app.got_subcommand(command.name)) {
      command.run();
    }
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
    // oneTBB throws its own exception if memory for the stack of a thread is missing.
    complain(std::strstr(error.what(), "pthread_create") != nullptr
                 ? not_enough_memory
                 : std::string("internal failure: ") + error.what() +
                       "; report it as CONTRIBUTING.md says, with the input");
    return internal_failure;
  }
}
