// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as JSON.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_json : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_json, Skeletons);
template <class SampleSkeleton>
std::string json_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_json(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

TYPED_TEST(Write_json, reads_back_exactly)
{
  const nlohmann::json document = nlohmann::json::parse(json_text<TypeParam>());
  Parsed_skeleton parsed;
  for (const nlohmann::json& node : document.at("nodes")) {
    parsed.points.emplace_back(node.at("point")[0], node.at("point")[1], node.at("point")[2]);
    if (node.contains("radius")) {
      parsed.radii.push_back(node["radius"]);
    }
  }
  for (const nlohmann::json& edge : document.at("edges")) {
    parsed.edges.emplace_back(edge[0], edge[1]);
  }
  expect_sample<TypeParam>(parsed);
}

TYPED_TEST(Write_json, tells_degree_and_number_of_sites)
{
  const TypeParam skeleton = sample_skeleton<TypeParam>();
  const nlohmann::json document = nlohmann::json::parse(json_text<TypeParam>());
  for (std::size_t i = 0; i < num_vertices(skeleton); ++i) {
    EXPECT_EQ(out_degree(i, skeleton), document["nodes"][i].at("degree"));
    EXPECT_EQ(i, document["nodes"][i].at("number_of_sites"));
  }
}

TYPED_TEST(Write_json, tells_length_radius_and_significance_of_branches)
{
  const nlohmann::json document = nlohmann::json::parse(json_text<TypeParam>());
  ASSERT_EQ(CSCD::has_radius_v<TypeParam>, document.contains("branches"));
  if (!CSCD::has_radius_v<TypeParam>) {
    return;
  }
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const nlohmann::json& branch : document["branches"]) {
    append_path(branch.at("nodes").template get<std::vector<std::size_t>>(), edges);
    const bool is_limb = branch["nodes"] == std::vector<int>({0, 1, 2}) || branch["nodes"] == std::vector<int>({4, 5});
    EXPECT_EQ(is_limb, branch.at("significance").is_number()) << branch;
    EXPECT_EQ(branch["nodes"].size() > 1, branch.at("length") > 1e19) << branch;
    EXPECT_GT(branch.at("mean_radius"), 1 / 20.);
    EXPECT_LE(branch.at("mean_radius"), 1 / 7.);
  }
  EXPECT_EQ(normalized(sample_edges()), normalized(edges));
}

TYPED_TEST(Write_json, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_json(out, TypeParam()));
}

} // namespace
