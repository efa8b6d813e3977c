// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two triangles with the same corners become simplicial; all else stays.

#include "Traits/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/refine_large_faces.h>

#include <gtest/gtest.h>

#include <utility>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::internal::Surface_components;
using CSCD::Triangulated_surface;

TEST(split_two_face_components, leaves_other_surfaces_alone)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::tetrahedron());
  Halfedge_pairing pairing(triangles.faces, 4);
  Surface_components components(triangles, pairing);
  EXPECT_EQ(CSCD::internal::split_two_face_components(triangles, pairing, components), 0u);
  EXPECT_EQ(triangles.faces.size(), 4u);
}

TEST(split_two_face_components, splits_the_second_face)
{
  // A bridged triangle, a closed pillow, and a tetrahedron between their faces.
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::tetrahedron());
  for (int i = 0; i < 6; ++i) {
    triangles.points.emplace_back(i, i * i, i % 3);
  }
  triangles.faces.insert(triangles.faces.begin(), {{7, 8, 9}, {4, 5, 6}});
  triangles.faces.insert(triangles.faces.end(), {{7, 9, 8}, {4, 6, 5}});
  triangles.first_hole_filling_face = 7; // the last face
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Surface_components components(triangles, pairing);
  EXPECT_EQ(CSCD::internal::split_two_face_components(triangles, pairing, components), 2u);
  EXPECT_EQ(triangles.faces.size(), 12u);
  EXPECT_EQ(triangles.first_hole_filling_face, 9u);
  EXPECT_EQ(Surface_components(triangles, pairing).component, components.component);
  CSCD::internal::refine_large_faces(triangles, pairing, components);
  const Triangulated_surface surface(std::move(triangles));
  ASSERT_FALSE(surface.defect());
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    EXPECT_GE(surface.degree(vertex), 3u);
  }
}

} // namespace
