// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the table of branches as CSV.

#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Skeleton_branches.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

using Table_rows = std::vector<std::map<std::string, std::string>>;

std::vector<std::string> csv_fields(const std::string& line)
{
  std::vector<std::string> result(1);
  for (const char c : line) {
    if (c == ',') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

Table_rows parse_table(const std::string& text)
{
  std::istringstream in(text);
  std::string line;
  EXPECT_TRUE(std::getline(in, line));
  const std::vector<std::string> names = csv_fields(line);
  Table_rows result;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    EXPECT_EQ(names.size(), fields.size()) << line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      result.resize(result.size() + (i == 0 ? 1 : 0));
      result.back()[names.at(i)] = fields[i];
    }
  }
  return result;
}

template <class SampleSkeleton>
Table_rows sample_table(const std::vector<CSCD::Index>& roots)
{
  return parse_table(write_in_foreign_locale(
      [&](std::ostream& out, const SampleSkeleton& s) {
        CSCD::write_branch_table(out, CSCD::measure_branches(s, roots));
      },
      sample_skeleton<SampleSkeleton>()));
}

TEST(Write_branch_table, has_a_line_for_each_branch)
{
  const CSCD::Skeleton_branches branches = CSCD::measure_branches(sample_skeleton<Skeleton>(), {0});
  const Table_rows table = sample_table<Skeleton>({0});
  ASSERT_EQ(branches.branches.size(), table.size());
  for (std::size_t b = 0; b < table.size(); ++b) {
    const CSCD::Skeleton_branch& branch = branches.branches[b];
    EXPECT_EQ(std::to_string(b), table[b].at("branch"));
    EXPECT_EQ(std::to_string(branch.nodes.front()), table[b].at("first_node"));
    EXPECT_EQ(std::to_string(branch.nodes.back()), table[b].at("last_node"));
    EXPECT_EQ(name(branch.ends[1]), table[b].at("last_end"));
    EXPECT_EQ(branch.length, std::stod(table[b].at("length"))); // exactly
    EXPECT_EQ(branch.mean_radius, std::stod(table[b].at("mean_radius")));
    EXPECT_EQ(branch.significance, std::stod(table[b].at("significance")));
    EXPECT_EQ(branch.parent ? std::to_string(*branch.parent) : "", table[b].at("parent"));
    EXPECT_EQ(std::to_string(*branch.order), table[b].at("order"));
  }
}

TEST(Write_branch_table, leaves_empty_what_is_not_known)
{
  for (const auto& row : sample_table<Skeleton_without_radius>({})) {
    for (const std::string name : {"min_radius", "mean_radius", "max_radius", "first_radius", "last_radius",
                                   "cone_area", "cone_volume", "surface_area", "volume", "parent", "order", "limb"}) {
      EXPECT_EQ("", row.at(name)) << name;
    }
    EXPECT_NE("", row.at("length"));
  }
}

} // namespace
