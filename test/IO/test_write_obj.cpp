// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as OBJ.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_obj : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_obj, Skeletons);
template <class SampleSkeleton>
std::string obj_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_obj(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

TYPED_TEST(Write_obj, reads_back_exactly)
{
  std::istringstream in(obj_text<TypeParam>());
  Parsed_skeleton parsed;
  std::size_t number_of_isolated_nodes = 0;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    char kind = 0;
    words >> kind;
    if (kind == 'v') {
      double x = 0;
      double y = 0;
      double z = 0;
      EXPECT_TRUE(words >> x >> y >> z);
      parsed.points.emplace_back(x, y, z);
      continue;
    }
    std::vector<std::size_t> branch;
    for (std::size_t i = 0; words >> i;) {
      branch.push_back(i - 1);
    }
    number_of_isolated_nodes += kind == 'p' ? 1 : 0;
    EXPECT_EQ(kind == 'p' ? 1u : std::max<std::size_t>(branch.size(), 2), branch.size());
    append_path(branch, parsed.edges);
  }
  EXPECT_EQ(1u, number_of_isolated_nodes);
  expect_sample<Skeleton_without_radius>(parsed); // OBJ holds no radius
}

TYPED_TEST(Write_obj, has_a_line_for_each_branch)
{
  const std::string content = obj_text<TypeParam>();
  EXPECT_NE(std::string::npos, content.find("\nl 1 2 3\n"));
  EXPECT_NE(std::string::npos, content.find("\np 7\n"));
  EXPECT_NE(std::string::npos, content.find("\nl 8 9 10 8\n"));
}

TYPED_TEST(Write_obj, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_obj(out, TypeParam()));
}

} // namespace
