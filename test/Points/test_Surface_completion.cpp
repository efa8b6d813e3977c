// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles with a hole become a closed surface, and the report says so in the coordinates of the input.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using CSCD::internal::Reconstructed_surface;

Reconstructed_surface completed(CSCD::Indexed_triangles triangles)
{
  Reconstructed_surface result;
  result.triangles = std::move(triangles);
  CSCD::internal::Surface_completion complete(result, {CSCD::Vector_3(100, 0, 0), 10});
  complete.prepare();
  complete();
  EXPECT_FALSE(CSCD::Triangulated_surface{CSCD::Indexed_triangles(result.triangles)}.defect());
  return result;
}

TEST(Surface_completion, closes_holes_and_drops_points_without_faces)
{
  CSCD::Indexed_triangles triangles = to_indexed_triangles(CSCD::test::sphere(3));
  triangles.faces.pop_back();
  triangles.points.emplace_back(9, 9, 9);
  const std::size_t number_of_points = triangles.points.size();
  const Reconstructed_surface surface = completed(std::move(triangles));
  EXPECT_EQ(surface.report.number_of_border_edges, 3u);
  EXPECT_EQ(surface.report.number_of_holes, 1u);
  EXPECT_TRUE(surface.report.cut_handles.empty());
  for (const CSCD::Index point : surface.point_of_vertex) {
    EXPECT_TRUE(point == CSCD::no_index || point + 1 < number_of_points);
  }
}

TEST(Surface_completion, reports_cuts_where_they_are_in_the_input)
{
  const Reconstructed_surface surface = completed(to_indexed_triangles(CSCD::test::torus(6, 1, 4)));
  ASSERT_EQ(surface.report.cut_handles.size(), 1u);
  const auto& center = surface.report.cut_handles.front().center;
  EXPECT_NEAR(std::hypot(center[0] - 100, center[1]), 60, 1);
}

} // namespace
