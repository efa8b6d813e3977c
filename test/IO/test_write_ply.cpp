// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as PLY.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_ply : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_ply, Skeletons);
template <class SampleSkeleton>
std::string ply_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_ply(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

TYPED_TEST(Write_ply, reads_back_exactly)
{
  constexpr bool has_radius = CSCD::has_radius_v<TypeParam>;
  std::istringstream in(ply_text<TypeParam>());
  std::string header;
  for (std::string line; line != "end_header" && std::getline(in, line);) {
    header += line + "\n";
  }
  EXPECT_EQ(std::string("ply\nformat ascii 1.0\nelement vertex 13\nproperty double x\nproperty double y\n"
                        "property double z\n") +
                (has_radius ? "property double radius\n" : "") +
                "element edge 12\nproperty int vertex1\nproperty int vertex2\n" +
                (has_radius ? "property double significance\n" : "") + "end_header\n",
            header);
  Parsed_skeleton parsed;
  for (int i = 0; i < 13; ++i) {
    double x = 0;
    double y = 0;
    double z = 0;
    EXPECT_TRUE(in >> x >> y >> z);
    parsed.points.emplace_back(x, y, z);
    if (has_radius) {
      EXPECT_TRUE(in >> parsed.radii.emplace_back());
    }
  }
  for (std::size_t u = 0, v = 0; in >> u >> v;) {
    parsed.edges.emplace_back(u, v);
    double significance = 0;
    if (has_radius) {
      EXPECT_TRUE(in >> significance);
      const bool is_limb = v == 5 || u < 2; // all else are cycles
      EXPECT_EQ(is_limb, significance < std::numeric_limits<double>::max()) << u << ' ' << v;
    }
  }
  expect_sample<TypeParam>(parsed);
}

TYPED_TEST(Write_ply, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_ply(out, TypeParam()));
}

} // namespace
