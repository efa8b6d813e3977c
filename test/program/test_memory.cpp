// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The memory that control groups leave.

#include "../../program/memory.h"
#include "support/Temporary_folder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <limits>

namespace {

constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();

TEST(memory_left_in_groups, is_the_least_of_those_around)
{
  const test_support::Temporary_folder root;
  std::filesystem::create_directories(root.path() / "slice/job");
  const auto left = [&](const char* group) {
    return cscd::memory_left_in_groups((root.path() / group).string(), root.path().string());
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
}

} // namespace
