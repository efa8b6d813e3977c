// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions that the worker of the page and of the npm package calls: `cscd skeletonize` in two steps, so that one
// skeleton can be saved in many formats. Files are in Emscripten's memory; messages go to standard error, as in the
// program.

#include "options.h"
#include "types.h"
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <emscripten/emscripten.h>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Reports progress to the script of the worker.
EM_JS(void, tell_progress, (const char* stage, double fraction),
      { Module.on_progress(UTF8ToString(stage), fraction); });

namespace {

/// A skeleton and its input.
struct Session
{
  cscd::Skeletonize_options options;
  cscd::Input input;
  cscd::Skeletonization_result result;
  std::vector<CSCD::Index> nodes_of_vertices;
};

std::unique_ptr<Session>& session()
{
  static std::unique_ptr<Session> result;
  return result;
}

/// \return whether `run` threw nothing; else the message goes to standard error
template <class Run>
bool succeeds(const Run& run)
{
  try {
    run();
    return true;
  } catch (const std::bad_alloc&) {
    std::cerr << "not enough memory for this input; simplify it, or use the program\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return false;
}

/// Sets the options of the lines `NAME VALUE` of `given`, named as on the command line.
/// \throw Usage_error
void set_options(const std::string& given, cscd::Skeletonize_options& options)
{
  const std::vector<cscd::Option> table = cscd::options_of(options);
  std::istringstream in(given);
  for (std::string name, value; std::getline(in, name, ' ') && std::getline(in, value);) {
    const auto row =
        std::find_if(table.begin(), table.end(), [&](const cscd::Option& option) { return option.name == name; });
    if (row == table.end()) {
      throw cscd::Usage_error("--" + name + ": is not an option; leave it out");
    }
    cscd::assign(*row, value);
  }
}

} // namespace

extern "C" {

/// Skeletonizes the file `name`. \param given options, see `set_options()` \return whether there is a skeleton
EMSCRIPTEN_KEEPALIVE bool cscd_skeletonize(const char* name, const char* given)
{
  session().reset();
  return succeeds([&] {
    auto computed = std::make_unique<Session>();
    cscd::Skeletonize_options& options = computed->options;
    options.input = name;
    set_options(given, options);
    options.report = "report.json"; // branches are measured with their surfaces then
    computed->input = cscd::read_input(options.input, options.format, false, true);
    const auto progress = [](CSCD::Skeletonization_stage stage, double fraction) {
      tell_progress(CSCD::name(stage), fraction);
    };
    computed->result = cscd::skeletonize_input(computed->input, options, progress);
    for (const std::string& warning : computed->result.warnings()) {
      std::cerr << warning << '\n';
    }
    session() = std::move(computed);
  });
}

/// Writes the file `name` by the option of `cscd skeletonize` for such files. \return whether there is such a file
EMSCRIPTEN_KEEPALIVE bool cscd_save(const char* option, const char* name)
{
  return session() && succeeds([&] {
           cscd::Skeletonize_options options = session()->options;
           options.is_quiet = true;
           options.report.clear();
           set_options(std::string(option) + ' ' + name, options);
           CSCD::File_group files;
           cscd::write_results(files, session()->input, session()->result, options);
           files.publish();
         });
}

/// The node of each vertex of the file of a session, -1 for none. Valid until the next call.
EMSCRIPTEN_KEEPALIVE const CSCD::Index* cscd_nodes_of_vertices()
{
  std::vector<CSCD::Index>& nodes = session()->nodes_of_vertices;
  nodes.clear();
  for (const CSCD::Vertex_label& label : cscd::labels_of_file(session()->input, session()->result)) {
    nodes.push_back(label.node);
  }
  return nodes.data();
}

} // extern "C"
