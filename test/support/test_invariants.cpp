// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The invariants notice violations: a skeleton made by hand passes, and fails after each damage.

#include "support/Centreline_error.h"
#include "support/Inside_count.h"
#include "support/Skeleton_comparison.h"
#include "support/Surface_facts.h"
#include "support/invariants.h"
#include "support/shapes.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::test::Violations;

/// A capsule with its exact skeleton: a row of nodes on the axis, each with the vertices that are nearest to it.
class Invariants : public testing::Test
{
protected:
  Invariants()
      : m_shape(CSCD::test::capsule(length, 1, 16)), m_mesh(CSCD::test::to_mesh<Mesh>(m_shape)), m_skeleton(nodes)
  {
    for (std::size_t i = 0; i < nodes; ++i) {
      m_skeleton[i].point = Point(length * static_cast<double>(i) / (nodes - 1), 0, 0);
      m_skeleton[i].radius = 1;
      if (i > 0) {
        add_edge(i - 1, i, m_skeleton);
      }
    }
    for (const Mesh::Vertex_index v : m_mesh.vertices()) {
      const double x = std::min(length, std::max(0.0, m_mesh.point(v).x()));
      m_skeleton[static_cast<std::size_t>(x / length * (nodes - 1) + 0.5)].vertices.push_back(v);
    }
    m_report.number_of_input_vertices = m_mesh.number_of_vertices();
    m_report.number_of_surface_components = 1;
    m_report.genus = 0;
    m_report.number_of_nodes = nodes;
    m_report.number_of_edges = nodes - 1;
    m_report.number_of_skeleton_components = 1;
    m_report.number_of_tips = 2;
  }

  Violations violations() const { return CSCD::test::violated_invariants(m_mesh, m_skeleton, m_report); }

  static constexpr std::size_t nodes = 9;
  static constexpr double length = 8;
  CSCD::test::Shape m_shape;
  Mesh m_mesh;
  Skeleton m_skeleton;
  CSCD::Skeletonization_report m_report;
};

TEST_F(Invariants, hold_for_an_exact_skeleton)
{
  EXPECT_EQ(violations(), Violations{});
  EXPECT_EQ(CSCD::test::count_inside(m_mesh, m_skeleton).fraction_of_nodes_inside(), 1);
  EXPECT_EQ(CSCD::test::count_inside(m_mesh, m_skeleton).fraction_of_length_inside(), 1);
  EXPECT_LT(CSCD::test::centreline_error(m_shape, m_skeleton).max_of_nodes, 1e-12);
  EXPECT_LT(CSCD::test::centreline_error(m_shape, m_skeleton).max_gap, 1e-12);
}

TEST_F(Invariants, notice_damage)
{
  const Skeleton whole = m_skeleton;
  m_skeleton[3].vertices.pop_back();
  EXPECT_EQ(violations().size(), 1u) << "a vertex without node";
  m_skeleton = whole;
  m_skeleton[3].vertices.push_back(m_skeleton[4].vertices.front());
  EXPECT_EQ(violations().size(), 1u) << "a vertex with two nodes";
  for (const auto& [a, b] : {std::pair(0, 8), std::pair(0, 1), std::pair(2, 2)}) {
    m_skeleton = whole;
    add_edge(std::size_t(a), std::size_t(b), m_skeleton);
    EXPECT_FALSE(violations().empty()) << "a wrong cycle, a double edge, a loop";
  }
  m_skeleton = whole;
  remove_edge(4, 5, m_skeleton);
  EXPECT_FALSE(violations().empty()) << "two components";
}

TEST_F(Invariants, notice_bad_numbers)
{
  m_skeleton[2].radius = -1;
  m_skeleton[3].point = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  m_skeleton[4].radius = std::numeric_limits<double>::infinity();
  EXPECT_EQ(CSCD::test::violations_of_graph(m_skeleton).size(), 3u);
  m_skeleton[5].radius = 0;
  EXPECT_EQ(CSCD::test::violations_of_radii(m_skeleton).size(), 1u);
  EXPECT_EQ(violations().size(), 4u);
}

TEST_F(Invariants, notice_a_report_that_lies)
{
  m_report.number_of_tips = 3;
  m_report.number_of_isolated_vertices = 1;
  EXPECT_EQ(violations().size(), 2u);
  m_report.genus = std::nullopt;
  EXPECT_EQ(violations().size(), 3u);
}

TEST_F(Invariants, notice_nodes_outside)
{
  m_skeleton[4].point = Point(4, 1.5, 0);
  const CSCD::test::Inside_count count = CSCD::test::count_inside(m_mesh, m_skeleton);
  EXPECT_EQ(count.number_of_nodes_outside, 1u);
  EXPECT_LT(count.fraction_of_length_inside(), 1);
  EXPECT_EQ(violations().size(), 2u) << "a node and a part of the length";
  m_report.number_of_nodes_outside = 1;
  m_report.number_of_edges_outside = 2;
  EXPECT_EQ(violations(), Violations{});
  EXPECT_NEAR(CSCD::test::centreline_error(m_shape, m_skeleton).max_of_nodes, 1.5, 1e-12);
}

TEST_F(Invariants, comparison_ignores_names_only)
{
  const CSCD::test::Plain_skeleton a = CSCD::test::plain(m_mesh, m_skeleton);
  CSCD::test::Plain_skeleton b = a;
  std::reverse(b.points.begin(), b.points.end());
  std::reverse(b.sites.begin(), b.sites.end());
  EXPECT_FALSE(a == b);
  EXPECT_EQ(CSCD::test::difference(a, b, 1e-9), "");

  b = a;
  b.points[3][1] += 1e-3;
  EXPECT_NE(CSCD::test::difference(a, b, 1e-4), "");
  EXPECT_EQ(CSCD::test::difference(a, b, 1e-2), "");

  b = a;
  b.edges[3] = {0, 8};
  EXPECT_NE(CSCD::test::difference(a, b, 1e-9), "");
}

} // namespace
