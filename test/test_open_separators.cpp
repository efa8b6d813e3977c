// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of sheets, whose separators lead from border to border, and the choice of these borders.

#include "support/Similarity.h"
#include "support/Skeleton_comparison.h"
#include "support/invariants.h"
#include "support/shapes.h"
#include "support/sheet_shapes.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Skeleton = CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index>;
using CSCD::Border_treatment, CSCD::test::Plain_skeleton, CSCD::test::Shape, CSCD::test::Sheet_shape,
    CSCD::test::Similarity, CSCD::test::Triple, CSCD::test::Violations;
using CSCD::test::operator*;
using CSCD::test::operator+;
using CSCD::test::operator-;

class Open_separators : public testing::Test
{
protected:
  void skeletonize(const Shape& shape, Border_treatment treatment = Border_treatment::automatic)
  {
    m_mesh = CSCD::test::to_mesh<Mesh>(shape);
    m_report = CSCD::extract_curve_skeleton(m_mesh, m_skeleton, CSCD::parameters::border_treatment(treatment));
    EXPECT_EQ(CSCD::test::violated_invariants(m_mesh, m_skeleton, m_report), Violations{}) << shape.name;
    EXPECT_EQ(m_report.number_of_bridged_borders + m_report.number_of_wide_borders, shape.number_of_border_cycles);
  }

  Plain_skeleton plain() const { return CSCD::test::plain(m_mesh, m_skeleton); }

  Mesh m_mesh;
  Skeleton m_skeleton;
  CSCD::Skeletonization_report m_report;
};

TEST_F(Open_separators, lead_along_the_middle_of_sheets)
{
  for (const Sheet_shape& sheet : CSCD::test::sheets_with_known_middle()) {
    SCOPED_TRACE(sheet.shape.name);
    skeletonize(sheet.shape);
    EXPECT_EQ(m_report.number_of_sheets, 1u);
    EXPECT_EQ(m_report.number_of_bridged_borders, 0u);
    EXPECT_GE(m_report.number_of_packed_separators, 3u);
    EXPECT_EQ(m_report.number_of_open_separators, m_report.number_of_packed_separators);
    EXPECT_EQ(m_report.betti_number, sheet.betti_number);
    EXPECT_EQ(m_report.number_of_skeleton_components, 1u);
    EXPECT_EQ(m_report.number_of_tips, sheet.ends.size());
    EXPECT_EQ(m_report.number_of_junctions, sheet.ends.size() > 2 ? 1u : 0u);
    const Plain_skeleton skeleton = plain();
    EXPECT_LT(CSCD::test::max_distance_from_middle(sheet, skeleton.points, skeleton.edges), 0.07);
    EXPECT_LT(CSCD::test::max_distance_from_ends(sheet, skeleton.points), 0.05);
  }
}

/// A shirt is a body with four openings; a vest cut open in front, of genus 0, a sheet with a cycle around each
/// armhole.
TEST_F(Open_separators, tell_the_garment_that_is_cut_open)
{
  skeletonize(CSCD::test::t_shirt());
  EXPECT_EQ(m_report.number_of_sheets, 0u);
  EXPECT_EQ(m_report.number_of_openings, 4u);
  EXPECT_EQ(m_report.number_of_tips, 4u);
  EXPECT_EQ(m_report.number_of_skeleton_components, 1u);
  skeletonize(CSCD::test::open_vest());
  EXPECT_EQ(m_report.number_of_sheets, 1u);
  EXPECT_EQ(m_report.number_of_wide_borders, 3u);
  EXPECT_EQ(m_report.betti_number, 2u);
  EXPECT_EQ(m_report.number_of_skeleton_components, 1u);
}

TEST_F(Open_separators, lead_along_each_finger_of_a_hand_that_is_cut_open)
{
  const Shape hand = CSCD::test::hand_cut_open();
  skeletonize(hand);
  EXPECT_EQ(m_report.number_of_sheets, 1u);
  EXPECT_EQ(m_report.betti_number, 0u);
  EXPECT_EQ(m_report.number_of_tips, hand.number_of_tips);
  EXPECT_EQ(m_report.number_of_junctions, 1u);
  EXPECT_EQ(m_report.number_of_edges_outside, 0u);
}

/// A plate 6 by 3 with square windows around the given corners of its grid.
Shape plate(const std::vector<Triple>& centers, double half_size)
{
  Shape shape = CSCD::test::strip_sheet(6, 3).shape;
  std::vector<bool> is_removed;
  for (const CSCD::test::Triangle& triangle : shape.triangles) {
    is_removed.push_back(std::any_of(centers.begin(), centers.end(), [&](const Triple& center) {
      return std::all_of(triangle.begin(), triangle.end(), [&](std::size_t corner) {
        const Triple offset = shape.points[corner] - center;
        return std::fabs(offset[0]) <= half_size && std::fabs(offset[1]) <= half_size;
      });
    }));
  }
  CSCD::test::remove_triangles(shape, is_removed);
  shape.number_of_border_cycles = 1 + centers.size();
  return shape;
}

TEST_F(Open_separators, leave_a_cycle_around_each_wide_hole)
{
  skeletonize(plate({{1.5, 0, 0}}, 0.76));
  EXPECT_EQ(m_report.number_of_wide_borders, 2u);
  EXPECT_EQ(m_report.betti_number, 1u);
  skeletonize(plate({{1.5, 0, 0}, {4.5, 0, 0}}, 0.76));
  EXPECT_EQ(m_report.number_of_wide_borders, 3u);
  EXPECT_EQ(m_report.betti_number, 2u);
}

TEST_F(Open_separators, go_across_small_holes)
{
  skeletonize(plate({{2, 0, 0}, {4, 0.5, 0}}, 0.13));
  EXPECT_EQ(m_report.number_of_wide_borders, 1u);
  EXPECT_EQ(m_report.number_of_bridged_borders, 2u);
  EXPECT_EQ(m_report.betti_number, 0u);
}

TEST_F(Open_separators, are_none_where_limbs_end_at_borders_or_holes_are_small)
{
  for (const Shape& shape :
       {CSCD::test::tube(3, 1, 24, CSCD::test::Tube_end::open), CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::open),
        CSCD::test::slit_tube(10, 1, 24), CSCD::test::with_small_holes(CSCD::test::y_tube(0.15), 12, 2)}) {
    SCOPED_TRACE(shape.name);
    skeletonize(shape, Border_treatment::bridge);
    const Plain_skeleton bridged = plain();
    skeletonize(shape);
    EXPECT_EQ(m_report.number_of_sheets, 0u);
    EXPECT_EQ(m_report.number_of_open_separators, 0u);
    EXPECT_EQ(plain(), bridged);
  }
}

TEST_F(Open_separators, are_chosen_by_the_caller_where_shape_does_not_tell)
{
  const Shape tube = CSCD::test::tube(5, 1, 24, CSCD::test::Tube_end::open);
  skeletonize(tube, Border_treatment::open);
  EXPECT_EQ(m_report.number_of_sheets, 1u);
  EXPECT_EQ(m_report.number_of_wide_borders, 2u);
  EXPECT_EQ(m_report.betti_number, 1u);
  skeletonize(CSCD::test::strip_sheet(8, 2).shape, Border_treatment::bridge);
  EXPECT_EQ(m_report.number_of_sheets, 0u);
  EXPECT_EQ(m_report.number_of_bridged_borders, 1u);
}

TEST_F(Open_separators, are_found_beside_a_body)
{
  const Shape strip = CSCD::test::strip_sheet(10, 2).shape;
  Shape both = CSCD::test::merged("strip and capsule",
                                  {strip, CSCD::test::translated(CSCD::test::capsule(8, 1, 24), {0, 9, 0})});
  both.number_of_border_cycles = 1;
  skeletonize(both);
  EXPECT_EQ(m_report.number_of_sheets, 1u);
  EXPECT_EQ(m_report.number_of_skeleton_components, 2u);
  EXPECT_EQ(m_report.number_of_tips, 4u);
  EXPECT_GT(m_report.number_of_open_separators, 0u);
  EXPECT_LT(m_report.number_of_open_separators, m_report.number_of_packed_separators);
}

/// Fronts from the border of a square meet at its diagonals, where edges lead to the middle.
TEST_F(Open_separators, are_sought_on_squares)
{
  Shape square;
  square.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  square.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  square.number_of_border_cycles = 1;
  skeletonize(CSCD::test::midpoint_subdivided(square, 3));
  EXPECT_EQ(m_report.number_of_sheets, 1u);
  EXPECT_EQ(m_report.number_of_nodes_outside, 0u);
}

TEST_F(Open_separators, of_bent_sheets_of_few_faces_stay_in_them)
{
  std::vector<Shape> shapes{CSCD::test::capsule(8, 1, 24)};
  for (int i = 0; i < 40; ++i) {
    shapes.push_back(CSCD::test::internal::grid_sheet("roof", 2, 1, false, [i](double u, double v) {
      return Triple{0.2 * i - 4 + 0.06 * u, 2 + 0.04 * v * (1 + u), 0.06 * std::fabs(u - 0.5)};
    }));
  }
  skeletonize(CSCD::test::merged("roofs", shapes));
  EXPECT_EQ(m_report.number_of_nodes_outside, 0u);
}

/// Single faces, pairs, and sheets without a vertex inside.
TEST_F(Open_separators, hold_the_invariants_on_the_smallest_sheets)
{
  Shape triangle;
  triangle.name = "triangle";
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  triangle.number_of_border_cycles = 1;
  Shape ribbon;
  ribbon.name = "ribbon";
  for (std::size_t i = 0; i <= 10; ++i) {
    ribbon.points.push_back({double(i), 0, 0});
    ribbon.points.push_back({double(i), 1, 0});
  }
  for (std::size_t i = 0; i < 20; ++i) {
    ribbon.triangles.push_back(i % 2 == 0 ? CSCD::test::Triangle{i, i + 2, i + 1}
                                          : CSCD::test::Triangle{i, i + 1, i + 2});
  }
  ribbon.number_of_border_cycles = 1;
  for (const Shape& shape : {triangle, ribbon}) {
    for (const Border_treatment treatment :
         {Border_treatment::automatic, Border_treatment::bridge, Border_treatment::open}) {
      skeletonize(shape, treatment);
    }
  }
}

} // namespace
