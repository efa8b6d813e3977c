// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Malformed files, kept as data: malformed_files.json.

#ifndef CSCD_TEST_IO_MALFORMED_FILES_H
#define CSCD_TEST_IO_MALFORMED_FILES_H

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace test_support {

struct Malformed_file
{
  std::string ending;
  std::string content;
  std::string message; ///< a part of the refusal
};

/// The list `name` of the data.
inline nlohmann::json malformed_data(const std::string& name)
{
  std::ifstream file(CSCD_TEST_DIR "/IO/malformed_files.json");
  return nlohmann::json::parse(file).at(name);
}

inline std::vector<Malformed_file> malformed_files(const std::string& name)
{
  std::vector<Malformed_file> result;
  for (const nlohmann::json& file : malformed_data(name)) {
    result.push_back({file.at("ending"), file.at("content"), file.at("message")});
  }
  return result;
}

} // namespace test_support

#endif // CSCD_TEST_IO_MALFORMED_FILES_H
