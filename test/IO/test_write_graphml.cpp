// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as GraphML.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_graphml : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_graphml, Skeletons);
template <class SampleSkeleton>
std::string graphml_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_graphml(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

using Tree = boost::property_tree::ptree;

std::size_t node_number(const std::string& id)
{
  EXPECT_EQ('n', id.at(0));
  return std::stoul(id.substr(1));
}

TYPED_TEST(Write_graphml, reads_back_exactly)
{
  std::istringstream in(graphml_text<TypeParam>());
  Tree tree;
  read_xml(in, tree);
  std::map<std::string, std::string> name_of_key;
  for (const auto& [tag, key] : tree.get_child("graphml")) {
    if (tag == "key") {
      EXPECT_EQ("double", key.template get<std::string>(Tree::path_type("<xmlattr>/attr.type", '/')));
      name_of_key[key.template get<std::string>("<xmlattr>.id")] =
          key.template get<std::string>(Tree::path_type("<xmlattr>/attr.name", '/'));
    }
  }
  std::size_t number_of_significances = 0;
  Parsed_skeleton parsed;
  for (const auto& [tag, element] : tree.get_child("graphml.graph")) {
    if (tag == "edge") {
      parsed.edges.emplace_back(node_number(element.template get<std::string>("<xmlattr>.source")),
                                node_number(element.template get<std::string>("<xmlattr>.target")));
      number_of_significances += element.count("data");
    } else if (tag == "node") {
      EXPECT_EQ(parsed.points.size(), node_number(element.template get<std::string>("<xmlattr>.id")));
      std::map<std::string, double> value;
      for (const auto& [data_tag, data] : element) {
        if (data_tag == "data") {
          value[name_of_key.at(data.template get<std::string>("<xmlattr>.key"))] = std::stod(data.data());
        }
      }
      parsed.points.emplace_back(value.at("x"), value.at("y"), value.at("z"));
      if (value.count("radius") == 1) {
        parsed.radii.push_back(value["radius"]);
      }
    }
  }
  EXPECT_EQ(CSCD::has_radius_v<TypeParam> ? parsed.edges.size() : 0, number_of_significances);
  expect_sample<TypeParam>(parsed);
}

TYPED_TEST(Write_graphml, empty_skeleton_is_written)
{
  std::ostringstream out;
  EXPECT_NO_THROW(CSCD::write_graphml(out, TypeParam()));
}

} // namespace
