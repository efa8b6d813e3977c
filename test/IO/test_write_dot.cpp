// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as DOT.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_dot.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_dot : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_dot, Skeletons);
template <class SampleSkeleton>
std::string dot_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_dot(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

/// The value of the attribute `name` in the line of a node.
double attribute(const std::string& line, const std::string& name)
{
  const std::size_t begin = line.find(name + "=");
  EXPECT_NE(std::string::npos, begin) << name << " in " << line;
  std::size_t value = begin + name.size() + 1;
  value += line[value] == '"' ? 1 : 0;
  return std::stod(line.substr(value));
}

TYPED_TEST(Write_dot, reads_back_exactly)
{
  std::istringstream in(dot_text<TypeParam>());
  std::string line;
  ASSERT_TRUE(std::getline(in, line));
  EXPECT_EQ("graph G {", line);
  Parsed_skeleton parsed;
  while (std::getline(in, line) && line != "}") {
    const std::size_t connector = line.find("--");
    if (connector != std::string::npos) {
      parsed.edges.emplace_back(std::stoul(line), std::stoul(line.substr(connector + 2)));
      continue;
    }
    EXPECT_EQ(parsed.points.size(), std::stoul(line));
    parsed.points.emplace_back(attribute(line, "x"), attribute(line, "y"), attribute(line, "z"));
    if (line.find("radius") != std::string::npos) {
      parsed.radii.push_back(attribute(line, "radius"));
    }
  }
  expect_sample<TypeParam>(parsed);
}

TYPED_TEST(Write_dot, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_dot(out, TypeParam()));
}

} // namespace
