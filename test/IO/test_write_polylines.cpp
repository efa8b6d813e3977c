// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as poly-lines.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/split_into_branches.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_polylines : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_polylines, Skeletons);
template <class SampleSkeleton>
std::string polylines_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_polylines(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

TYPED_TEST(Write_polylines, reads_back_exactly)
{
  const TypeParam skeleton = sample_skeleton<TypeParam>();
  std::istringstream in(polylines_text<TypeParam>());
  for (const auto& branch : CSCD::split_into_branches(skeleton)) {
    std::string line;
    ASSERT_TRUE(std::getline(in, line));
    std::istringstream words(line);
    std::size_t size = 0;
    words >> size;
    ASSERT_EQ(branch.size(), size);
    for (auto v : branch) {
      double x = 0;
      double y = 0;
      double z = 0;
      EXPECT_TRUE(words >> x >> y >> z);
      EXPECT_EQ(skeleton[v].point, Point(x, y, z));
    }
    std::string rest;
    EXPECT_FALSE(words >> rest);
  }
  std::string rest;
  EXPECT_FALSE(in >> rest);
}

TYPED_TEST(Write_polylines, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_polylines(out, TypeParam()));
}

} // namespace
