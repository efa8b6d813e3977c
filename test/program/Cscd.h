// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Running the program cscd in a test.

#ifndef CSCD_TEST_PROGRAM_CSCD_H
#define CSCD_TEST_PROGRAM_CSCD_H

#include "IO/mesh_files.h"
#include "support/Temporary_folder.h"
#include "support/swept_shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace test_support {

/// A torus of radii 3 and 1, whose skeleton is one cycle.
inline Mesh_file_content torus(std::size_t around = 24)
{
  return file_content(CSCD::test::torus(3, 1, around));
}

/// The outcome of a run of the program.
struct Outcome
{
  int status = -1;
  std::string out;
  std::string err;
};

/// A test that runs the program in a folder of its own, which holds torus.off.
class Cscd : public testing::Test
{
protected:
  Cscd() { m_folder.write("torus.off", off(torus())); }

  /// Runs the program in the test's folder, in a shell: arguments may redirect.
  /// \param before the first commands of the shell, with a semicolon, or the variables that the program gets
  Outcome run(const std::string& arguments, const std::string& before = "")
  {
    const std::string command = "cd '" + m_folder.path().string() + "' && " + before + " '" + m_program + "' " +
                                arguments + " > '" + m_streams.file("out") + "' 2> '" + m_streams.file("err") + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(m_streams.file("out")),
            read_file(m_streams.file("err"))};
  }

  /// As run(), and expects success.
  Outcome run_well(const std::string& arguments, const std::string& before = "")
  {
    Outcome outcome = run(arguments, before);
    EXPECT_EQ(0, outcome.status) << arguments << ": " << outcome.err;
    return outcome;
  }

  std::string content(const std::string& name) const { return read_file(m_folder.file(name)); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(content(name)); }

  /// Expects a refusal in one line that holds all `parts`.
  void expect_refusal(const std::string& arguments, int status, const std::vector<std::string>& parts)
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(status, outcome.status);
    EXPECT_EQ("", outcome.out);
    EXPECT_EQ(0u, outcome.err.rfind("cscd: ", 0)) << outcome.err;
    EXPECT_EQ(1, std::count(outcome.err.begin(), outcome.err.end(), '\n')) << outcome.err;
    for (const std::string& part : parts) {
      EXPECT_NE(std::string::npos, outcome.err.find(part)) << part << " in " << outcome.err;
    }
  }

  std::string m_program = CSCD_PROGRAM;
  Temporary_folder m_folder;

private:
  Temporary_folder m_streams;
};

} // namespace test_support

#endif // CSCD_TEST_PROGRAM_CSCD_H
