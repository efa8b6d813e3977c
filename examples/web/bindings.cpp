// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the worker of the page calls: `cscd skeletonize` in two steps, so that one skeleton can be saved in many
// formats. Files are those of Emscripten's memory; messages go to standard error, as those of the program.

#include "types.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/exceptions.h>

#include <emscripten/emscripten.h>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace {

/// A skeleton and what it was computed from.
struct Session
{
  cscd::Skeletonize_options options;
  cscd::Input input;
  cscd::Skeletonization_result result;
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

} // namespace

extern "C" {

/// Skeletonizes the file `name`. \return whether there is a skeleton
EMSCRIPTEN_KEEPALIVE bool cscd_skeletonize(const char* name, double detail)
{
  session().reset();
  return succeeds([&] {
    auto computed = std::make_unique<Session>();
    cscd::Skeletonize_options& options = computed->options;
    options.input = name;
    options.detail = detail;
    options.report = "report.json"; // branches are measured with their surfaces then
    computed->input = cscd::read_input(options.input, options.format, false, true);
    computed->result = cscd::skeletonize_input(computed->input, options, nullptr);
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
           const std::string which = option;
           if (which == "output") {
             options.outputs = {name};
           } else {
             (which == "branches"         ? options.branches
              : which == "nodes"          ? options.nodes
              : which == "correspondence" ? options.correspondence
              : which == "labelled"       ? options.labelled
              : which == "report"         ? options.report
                                          : options.html) = name;
           }
           CSCD::File_group files;
           cscd::write_results(files, session()->input, session()->result, options);
           files.publish();
         });
}

} // extern "C"
