// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as graphs of GEL.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_gel_graph : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_gel_graph, Skeletons);
template <class SampleSkeleton>
std::string gel_graph_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_gel_graph(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

/// GEL graphs hold no radius.
TYPED_TEST(Write_gel_graph, reads_back_exactly)
{
  std::istringstream in(gel_graph_text<TypeParam>());
  Parsed_skeleton parsed;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    char kind = 0;
    words >> kind;
    if (kind == 'n') {
      double x = 0;
      double y = 0;
      double z = 0;
      EXPECT_TRUE(words >> x >> y >> z);
      parsed.points.emplace_back(x, y, z);
    } else {
      EXPECT_EQ('c', kind);
      std::size_t u = 0;
      std::size_t v = 0;
      EXPECT_TRUE(words >> u >> v);
      parsed.edges.emplace_back(u, v);
    }
  }
  expect_sample<Skeleton_without_radius>(parsed);
}

TYPED_TEST(Write_gel_graph, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_gel_graph(out, TypeParam()));
}

} // namespace
