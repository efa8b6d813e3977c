// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written as VTP.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/Skeleton_branches.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace test_support;

template <class SampleSkeleton>
class Write_vtp : public testing::Test
{
};
using Skeletons = testing::Types<Skeleton, Skeleton_without_radius>;
TYPED_TEST_SUITE(Write_vtp, Skeletons);
template <class SampleSkeleton>
std::string vtp_text()
{
  return write_in_foreign_locale([](std::ostream& out, const SampleSkeleton& s) { CSCD::write_vtp(out, s); },
                                 sample_skeleton<SampleSkeleton>());
}

using Tree = boost::property_tree::ptree;

template <class Number>
std::vector<Number> numbers(const Tree& array)
{
  std::istringstream in(array.data());
  std::vector<Number> result;
  for (Number number{}; in >> number;) {
    result.push_back(number);
  }
  EXPECT_TRUE(in.eof());
  return result;
}

const Tree& array(const Tree& parent, const std::string& name)
{
  for (const auto& [tag, child] : parent) {
    if (tag == "DataArray" && child.get<std::string>("<xmlattr>.Name") == name) {
      return child;
    }
  }
  throw std::out_of_range(name);
}

std::vector<std::vector<std::size_t>> cells(const Tree& parent)
{
  const auto connectivity = numbers<std::size_t>(array(parent, "connectivity"));
  std::vector<std::vector<std::size_t>> result;
  std::size_t begin = 0;
  for (const std::size_t end : numbers<std::size_t>(array(parent, "offsets"))) {
    auto& cell = result.emplace_back();
    for (; begin < end; ++begin) {
      cell.push_back(connectivity.at(begin));
    }
  }
  EXPECT_EQ(connectivity.size(), begin);
  return result;
}

template <class SampleSkeleton>
Tree piece()
{
  std::istringstream in(vtp_text<SampleSkeleton>());
  Tree tree;
  read_xml(in, tree);
  EXPECT_EQ("PolyData", tree.get<std::string>("VTKFile.<xmlattr>.type"));
  return tree.get_child("VTKFile.PolyData.Piece");
}

TYPED_TEST(Write_vtp, reads_back_exactly)
{
  const Tree tree = piece<TypeParam>();
  Parsed_skeleton parsed;
  const auto coordinates = numbers<double>(tree.get_child("Points.DataArray"));
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    parsed.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  EXPECT_EQ(parsed.points.size(), tree.get<std::size_t>("<xmlattr>.NumberOfPoints"));
  if (tree.get_child_optional("PointData")) {
    parsed.radii = numbers<double>(array(tree.get_child("PointData"), "Radius"));
    EXPECT_EQ(parsed.radii, numbers<double>(array(tree.get_child("PointData"), "MaximumInscribedSphereRadius")));
  }
  for (const auto& line : cells(tree.get_child("Lines"))) {
    append_path(line, parsed.edges);
  }
  expect_sample<TypeParam>(parsed);
}

TYPED_TEST(Write_vtp, numbers_its_cells)
{
  const Tree tree = piece<TypeParam>();
  const auto vertices = cells(tree.get_child("Verts"));
  const auto lines = cells(tree.get_child("Lines"));
  EXPECT_EQ((std::vector<std::vector<std::size_t>>{{6}}), vertices);
  EXPECT_EQ(vertices.size(), tree.get<std::size_t>("<xmlattr>.NumberOfVerts"));
  EXPECT_EQ(lines.size(), tree.get<std::size_t>("<xmlattr>.NumberOfLines"));
  const auto ids = numbers<std::size_t>(array(tree.get_child("CellData"), "BranchId"));
  ASSERT_EQ(vertices.size() + lines.size(), ids.size());
  const std::vector<CSCD::Skeleton_branch> branches = CSCD::measure_branches(sample_skeleton<TypeParam>()).branches;
  for (std::size_t i = 0; i < ids.size(); ++i) { // the same numbers as in other outputs, although vertices come first
    const auto& nodes = i < vertices.size() ? vertices[i] : lines[i - vertices.size()];
    EXPECT_EQ(branches.at(ids[i]).nodes, std::vector<CSCD::Index>(nodes.begin(), nodes.end()));
  }
  if (CSCD::has_radius_v<TypeParam>) {
    const auto significances = numbers<double>(array(tree.get_child("CellData"), "Significance"));
    ASSERT_EQ(ids.size(), significances.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool is_limb = lines[i].front() == 0 || lines[i].back() == 5;
      EXPECT_EQ(is_limb, significances[vertices.size() + i] < std::numeric_limits<double>::max());
    }
  }
}

} // namespace
