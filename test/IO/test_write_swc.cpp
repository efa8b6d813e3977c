// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as SWC.

#include "sample_skeleton.h"
#include "support/convert_shape.h"
#include <CSCD/IO/write_skeleton.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;

struct Swc_node
{
  std::size_t id = 0;
  int type = 0;
  double x = 0;
  double y = 0;
  double z = 0;
  double radius = 0;
  long parent = 0;
};

struct Swc_file
{
  std::vector<Swc_node> nodes;
  std::vector<std::pair<std::size_t, std::size_t>> loops; ///< as identifiers
};

Swc_file parse(const std::string& content)
{
  Swc_file result;
  std::istringstream in(content);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    if (line.rfind("# loop ", 0) == 0) {
      std::string word;
      auto& [i, j] = result.loops.emplace_back();
      EXPECT_TRUE(words >> word >> word >> i >> j);
    } else if (line[0] != '#') {
      Swc_node& n = result.nodes.emplace_back();
      EXPECT_TRUE(words >> n.id >> n.type >> n.x >> n.y >> n.z >> n.radius >> n.parent) << line;
    }
  }
  return result;
}

/// Reads SWC by the strictest rules of readers of neurons: identifiers 1, 2, ..., types 1 to 7, parents before
/// children, one root for each component; one of the roots is the soma.
Swc_file parse_strictly(const std::string& content, std::size_t number_of_components)
{
  Swc_file file = parse(content);
  std::size_t number_of_roots = 0;
  for (std::size_t i = 0; i < file.nodes.size(); ++i) {
    const Swc_node& node = file.nodes[i];
    EXPECT_EQ(i + 1, node.id);
    EXPECT_TRUE(1 <= node.type && node.type <= 7) << node.type;
    EXPECT_TRUE(node.parent == -1 || (1 <= node.parent && node.parent < long(node.id))) << node.parent;
    EXPECT_TRUE(node.type != 1 || node.parent == -1);
    number_of_roots += node.parent == -1 ? 1 : 0;
  }
  EXPECT_EQ(number_of_components, number_of_roots);
  for (const auto& [i, j] : file.loops) {
    EXPECT_TRUE(1 <= i && i <= file.nodes.size() && 1 <= j && j <= file.nodes.size());
  }
  return file;
}

std::string swc_text_with(const Skeleton& skeleton, const CSCD::Swc_options& options)
{
  std::ostringstream out;
  CSCD::write_swc(out, skeleton, options);
  return out.str();
}

/// A tail 0 - 1 of radius 1 to a ring 1 - 2 - 3 - 4, which is thinnest between 2 and 3, and a ball apart of radius 9.
Skeleton tail_with_ring()
{
  return CSCD::test::to_graph<Skeleton>({{0, 0, 0}, {2, 0, 0}, {4, 2, 0}, {6, 0, 0}, {4, -2, 0}, {50, 0, 0}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 1}}, {1, 2, 0.5, 0.25, 2, 9});
}

TEST(Write_swc_for_neurons, obeys_strict_rules)
{
  CSCD::Swc_options options;
  options.type = 3;
  const Swc_file dendrite = parse_strictly(swc_text_with(tail_with_ring(), options), 2);
  EXPECT_EQ(6, std::count_if(dendrite.nodes.begin(), dendrite.nodes.end(), [](auto& n) { return n.type == 3; }));
  options.min_soma_radius = 5;
  const Swc_file with_soma = parse_strictly(swc_text_with(tail_with_ring(), options), 2);
  EXPECT_EQ(1, with_soma.nodes.front().type);
  EXPECT_EQ(9, with_soma.nodes.front().radius);
  EXPECT_EQ(5, std::count_if(with_soma.nodes.begin(), with_soma.nodes.end(), [](auto& n) { return n.type == 3; }));
  options.min_soma_radius = 10; // nothing is as thick
  parse_strictly(swc_text_with(sample_skeleton<Skeleton>(), options), 4);
}

TEST(Write_swc_for_neurons, cuts_cycles_where_they_are_thinnest)
{
  const Swc_file file = parse(swc_text_with(tail_with_ring(), {}));
  ASSERT_EQ(1u, file.loops.size());
  const auto [i, j] = file.loops[0];
  EXPECT_EQ(0.75, file.nodes[i - 1].radius + file.nodes[j - 1].radius);
}

TEST(Write_swc_for_neurons, begins_at_the_roots)
{
  CSCD::Swc_options options;
  options.roots = {3};
  options.scale = 0.5;
  const Swc_file file = parse(swc_text_with(tail_with_ring(), options));
  EXPECT_EQ(3, file.nodes[0].x); // half of that of the node
  EXPECT_EQ(0.125, file.nodes[0].radius);
  EXPECT_EQ(-1, file.nodes[0].parent);
  EXPECT_EQ(25, file.nodes.back().x);
  EXPECT_EQ(-1, file.nodes.back().parent);
}

} // namespace
