// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd classify`: from a table of meshes to their classes.

#include "applications.h"
#include "commands.h"
#include "compute_skeleton.h"
#include "dump_json.h"
#include "types.h"
#include <CSCD/Application/classify_shapes.h>
#include <CSCD/exceptions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

/// Mesh files and their classes, which are empty where they are to be found.
struct Shape_table
{
  std::vector<std::string> files; ///< as the table names them
  std::vector<std::string> classes;
};

/// `text` without blanks at both ends, as tables from other systems have them.
std::string trimmed(const std::string& text)
{
  constexpr const char* blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

Shape_table read_table(const std::string& filename)
{
  std::ifstream in(filename);
  if (!in) {
    throw CSCD::File_error(filename + ": cannot be read; check the name and the permissions");
  }
  Shape_table table;
  for (std::string line; std::getline(in, line);) {
    const std::size_t comma = line.rfind(','); // file names may have commas
    const std::string file = trimmed(line.substr(0, comma));
    const std::string class_name = comma == std::string::npos ? std::string() : trimmed(line.substr(comma + 1));
    const bool is_title = table.files.empty() && file == "file" && class_name == "class";
    if (!file.empty() && !is_title) {
      table.files.push_back(file);
      table.classes.push_back(class_name);
    }
  }
  if (std::count(table.classes.begin(), table.classes.end(), std::string()) + 2 > std::ptrdiff_t(table.files.size())) {
    throw CSCD::Input_error(filename + ": has no two shapes with a class; write lines of file,class");
  }
  return table;
}

CSCD::Shape_description describe(const std::string& file, const Classify_options& options)
{
  Input input = read_mesh(file, "", options.is_quiet);
  try {
    const Skeletonization_result result = compute_skeleton(input, Skeletonize_options(), nullptr);
    return CSCD::describe_shape(input.mesh, result.skeleton,
                                options.descriptor == diameter_descriptor ? CSCD::Shape_descriptor::diameter
                                                                          : CSCD::Shape_descriptor::skeleton);
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(file + ": " + error.what());
  }
}

nlohmann::ordered_json to_json(const Classify_options& options, const Shape_table& table,
                               const CSCD::Shape_classification& result)
{
  nlohmann::ordered_json shapes = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < table.files.size(); ++i) {
    shapes.push_back(
        {{"file", table.files[i]},
         {"class", table.classes[i].empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(table.classes[i])},
         {"found", result.found[i]},
         {"nearest", table.files[result.nearest[i]]},
         {"distance", result.distance[i]}});
  }
  return {{"descriptor", options.descriptor},
          {"accuracy", result.accuracy},
          {"macro_f1", result.macro_f1},
          {"shapes", std::move(shapes)}};
}

} // namespace

void classify(const Classify_options& options)
{
  check_is_not_input(options.output, options.manifest, "--output");
  const Shape_table table = read_table(options.manifest);
  const std::filesystem::path folder = std::filesystem::path(options.manifest).parent_path();
  std::vector<CSCD::Shape_description> descriptions;
  descriptions.reserve(table.files.size());
  for (const std::string& file : table.files) {
    descriptions.push_back(describe((folder / file).string(), options));
  }
  const CSCD::Shape_classification result = CSCD::classify_shapes(descriptions, table.classes);
  write_output(options.output, [&](std::ostream& out) { out << dump_json(to_json(options, table, result)) << '\n'; });
  if (!options.is_quiet && options.output != standard_stream) {
    std::cout << options.output << ": accuracy " << std::round(1000 * result.accuracy) / 1000 << ", F1 score "
              << std::round(1000 * result.macro_f1) / 1000 << '\n';
  }
}

} // namespace cscd
