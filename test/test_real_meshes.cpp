// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The whole pipeline on the meshes that come with CGAL.

#include "support/Inside_count.h"
#include "support/Surface_facts.h"
#include "support/invariants.h"
#include "support/message_of.h"
#include "support/real_meshes.h"
#include "support/skip_or_fail.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::test::Real_mesh;

bool read_mesh(const Real_mesh& real_mesh, Mesh& mesh)
{
  std::ifstream file(real_mesh.path());
  return CGAL::IO::read_OFF(file, mesh);
}

class Skeletonized_real_mesh : public testing::TestWithParam<Real_mesh>
{
protected:
  void SetUp() override
  {
    if (!GetParam().exists()) {
      CSCD_TEST_SKIP_OR_FAIL(GetParam().path() << " is missing: it comes with the Debian package libcgal-demo");
    }
    ASSERT_TRUE(read_mesh(GetParam(), m_mesh));
    if (!CGAL::is_triangle_mesh(m_mesh)) {
      ASSERT_TRUE(CGAL::Polygon_mesh_processing::triangulate_faces(m_mesh));
    }
    const CSCD::test::Surface_facts facts = CSCD::test::surface_facts(m_mesh);
    ASSERT_EQ(facts.number_of_components, GetParam().number_of_components);
    ASSERT_EQ(facts.genus, GetParam().genus);
    ASSERT_EQ(facts.number_of_border_cycles, GetParam().number_of_border_cycles);
    m_report = CSCD::extract_curve_skeleton(m_mesh, m_skeleton);
  }

  Mesh m_mesh;
  Skeleton m_skeleton;
  CSCD::Skeletonization_report m_report;
};

class Closed_real_mesh : public Skeletonized_real_mesh
{
};

TEST_P(Closed_real_mesh, gets_a_skeleton_inside_with_all_invariants)
{
  EXPECT_EQ(CSCD::test::violated_invariants(m_mesh, m_skeleton, m_report), CSCD::test::Violations{});
  EXPECT_EQ(m_report.betti_number, GetParam().genus);
  const CSCD::test::Inside_count count = CSCD::test::count_inside(m_mesh, m_skeleton);
  EXPECT_EQ(count.number_of_nodes_outside, m_report.number_of_nodes_outside);
  EXPECT_EQ(count.number_of_nodes_outside, 0u);
  EXPECT_GE(count.fraction_of_length_inside(), 0.999);
}

class Open_real_mesh : public Skeletonized_real_mesh
{
};

TEST_P(Open_real_mesh, gets_a_skeleton_with_all_invariants)
{
  EXPECT_EQ(CSCD::test::violated_invariants(m_mesh, m_skeleton, m_report), CSCD::test::Violations{});
}

std::string name_of(const testing::TestParamInfo<Real_mesh>& info)
{
  std::string name = "_" + std::string(info.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cgal, Closed_real_mesh, testing::ValuesIn(CSCD::test::closed_real_meshes()), name_of);
INSTANTIATE_TEST_SUITE_P(Cgal, Open_real_mesh, testing::ValuesIn(CSCD::test::open_real_meshes()), name_of);

TEST(Real_meshes, with_many_holes_are_bodies)
{
  Mesh mesh;
  if (!read_mesh({"elephant-with-holes", 1, 3, 106}, mesh)) {
    CSCD_TEST_SKIP_OR_FAIL("elephant-with-holes.off is missing: it comes with the Debian package libcgal-demo");
  }
  Skeleton skeleton;
  const auto report = CSCD::extract_curve_skeleton(mesh, skeleton);
  EXPECT_EQ(report.number_of_sheets, 0u);
  EXPECT_EQ(report.number_of_bridged_borders, 106u);
  EXPECT_EQ(report.betti_number, 3u);
}

TEST(Real_meshes, with_a_pinched_vertex_are_refused_by_name)
{
  Mesh mesh;
  if (!read_mesh({"polygon_mesh", 1, 0, 0}, mesh)) {
    CSCD_TEST_SKIP_OR_FAIL("polygon_mesh.off is missing: it comes with the Debian package libcgal-demo");
  }
  Skeleton skeleton;
  const std::string message = CSCD::test::message_of([&] { CSCD::extract_curve_skeleton(mesh, skeleton); });
  EXPECT_NE(message.find("vertex 4113"), std::string::npos) << message;
}

} // namespace
