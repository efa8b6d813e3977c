// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outputs of the program when the disk is full, memory runs out, or it is killed: all of them, or none. The memory
// that control groups leave.

#include "../../program/memory.h"
#include "IO/mesh_files.h"
#include "program/Cscd.h"
#include "support/Temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

namespace {

using namespace test_support;

class Faults : public Cscd
{
protected:
  Faults()
  {
    m_folder.write("torus.off", off(torus(8)));
    EXPECT_EQ(0, run(m_arguments).status);
    m_expected = outputs();
    EXPECT_EQ(m_expected.size(), 4u);
    remove_outputs();
  }

  /// The contents of all files but the input; times in the report are left out.
  std::map<std::string, std::string> outputs() const
  {
    std::map<std::string, std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.path())) {
      const std::string name = entry.path().filename().string();
      if (name != "torus.off") {
        result[name] = name == "report.json" ? "" : content(name);
      }
    }
    return result;
  }

  /// The number of outputs that have appeared; temporary files next to them do not count.
  std::size_t number_of_outputs() const
  {
    std::size_t result = 0;
    for (const auto& [name, text] : outputs()) {
      result += m_expected.count(name);
    }
    return result;
  }

  void remove_outputs()
  {
    for (const auto& [name, text] : outputs()) {
      std::filesystem::remove(m_folder.file(name));
    }
  }

  const std::string m_arguments =
      "skeletonize torus.off --threads 1 --quiet -o a.graph -o b.ply -o c.vtp --report report.json";
  std::map<std::string, std::string> m_expected;
};

TEST_F(Faults, full_disk_at_any_place_leaves_nothing)
{
  bool is_done = false;
  std::size_t blocks = 1; // of 512 or 1024 bytes, that a file may have; the message has to fit, too
  for (; !is_done && blocks < 1000; ++blocks) {
    const Outcome outcome = run(m_arguments, "trap '' XFSZ; ulimit -f " + std::to_string(blocks) + ";");
    is_done = outcome.status == 0;
    if (!is_done) {
      EXPECT_EQ(outcome.status, 2);
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
      ASSERT_TRUE(outputs().empty()) << blocks << " blocks";
    }
  }
  EXPECT_GT(blocks, 4u);
  EXPECT_EQ(outputs(), m_expected);
}

TEST_F(Faults, without_memory_at_any_allocation_there_is_a_message_and_nothing_else)
{
  // Before main() begins, the system ends the program.
  constexpr std::size_t most_before_main = 32;
  constexpr int aborted = 128 + 6;
  const auto run_without = [this](std::size_t number) {
    return run(m_arguments, "CSCD_FAIL_AT=" + std::to_string(number) + " LD_PRELOAD='" CSCD_FAIL_ALLOCATION "'");
  };
  std::size_t number = 1;
  while (number < most_before_main && run_without(number).status == aborted) {
    ++number;
  }
  std::size_t number_of_failures = 0;
  std::size_t number_of_others = 0; // one after the other: the last allocation was passed
  for (; number_of_others < 3; number += 1 + number / 64) {
    const Outcome outcome = run_without(number);
    if (outcome.status == 0) { // or the memory is only for speed, as that of a sort
      ++number_of_others;
      EXPECT_EQ(outputs(), m_expected) << number;
      remove_outputs();
      continue;
    }
    ++number_of_failures;
    number_of_others = 0;
    EXPECT_EQ(outcome.status, 3) << number << ": " << outcome.err;
    EXPECT_NE(outcome.err.find("not enough memory"), std::string::npos) << number << ": " << outcome.err;
    ASSERT_EQ(number_of_outputs(), 0u) << number;
    remove_outputs(); // a destructor without memory ends the program, and leaves temporary files
  }
  EXPECT_GT(number_of_failures, 100u);
}

TEST_F(Faults, memory_is_limited_to_what_the_machine_has)
{
  // While the program waits for its input, its limit is read: soft and hard, in bytes.
  const std::string arguments = "skeletonize pipe --format off --quiet -o a.graph &"
                                " exec 3> pipe; awk '/Max data size/ { print $4 }' /proc/$!/limits; exec 3>&-; wait; }";
  const std::string limit = run(arguments, "mkfifo pipe; {").out;
  ASSERT_FALSE(limit.empty());
  ASSERT_TRUE(std::all_of(limit.begin(), limit.end() - 1, [](char c) { return c >= '0' && c <= '9'; })) << limit;
  constexpr double least = 1e6; // bytes; a machine without them does not run this test
  constexpr double most = 1e15;
  EXPECT_GT(std::stod(limit), least);
  EXPECT_LT(std::stod(limit), most);
}

TEST_F(Faults, without_the_memory_that_it_needs_there_is_a_message_and_no_output)
{
  m_folder.write("large.off", off(torus(282)));
  const Outcome outcome = run("skeletonize large.off --quiet -o large.graph", "ulimit -d 40000;");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("not enough memory"), std::string::npos) << outcome.err;
  EXPECT_EQ(m_folder.number_of_files(), 2);
}

TEST_F(Faults, killed_at_any_time_no_output_is_half_written)
{
  bool is_done = false;
  for (int milliseconds = 1; !is_done && milliseconds < 100000; milliseconds += 1 + milliseconds / 8) {
    const std::string seconds =
        std::to_string(milliseconds / 1000) + "." + std::to_string(1000 + milliseconds % 1000).substr(1);
    is_done = run(m_arguments, "timeout --signal=KILL " + seconds).status == 0;
    for (const auto& [name, text] : outputs()) {
      if (const auto expected = m_expected.find(name); expected != m_expected.end()) {
        EXPECT_EQ(expected->second, text) << name << " after " << milliseconds << " ms";
      } // else a temporary file that was not yet renamed
    }
    remove_outputs();
  }
  EXPECT_TRUE(is_done);
}

constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();

TEST(memory_left_in_groups, is_the_least_of_those_around)
{
  const Temporary_folder root;
  std::filesystem::create_directories(root.path() / "slice/job");
  std::size_t swap = 0;
  const auto left = [&](const char* group) {
    return cscd::memory_left_in_groups((root.path() / group).string(), root.path().string(), swap);
  };
  EXPECT_EQ(left("slice/job"), unbounded);
  root.write("slice/job/memory.max", "max\n");
  root.write("slice/job/memory.current", "300\n");
  EXPECT_EQ(left("slice/job"), unbounded);
  root.write("slice/memory.max", "1000\n");
  root.write("slice/memory.current", "700\n");
  EXPECT_EQ(left("slice/job"), 300U);
  root.write("slice/memory.stat", "anon 450\nfile 250\nkernel 10\n");
  EXPECT_EQ(left("slice/job"), 550U);
  root.write("memory.max", "100\n");
  root.write("memory.current", "150\n");
  EXPECT_EQ(left("slice/job"), 0U);
  EXPECT_EQ(left("none/such"), 0U);
  root.write("memory.max", "max\n");
  swap = 1000;
  EXPECT_EQ(left("slice/job"), 1550U);
  root.write("slice/memory.swap.max", "200\n");
  root.write("slice/memory.swap.current", "150\n");
  EXPECT_EQ(left("slice/job"), 600U);
}

} // namespace
