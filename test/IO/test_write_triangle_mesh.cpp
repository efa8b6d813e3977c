// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of triangle meshes written to files.

#include "support/Temporary_folder.h"
#include "support/convert_shape.h"
#include "support/shapes.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_triangle_mesh.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace {

using namespace CSCD::test;
using test_support::Temporary_folder;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

TEST(Write_triangle_mesh, reads_back_exactly)
{
  const Mesh mesh = to_mesh<Mesh>(torus(3, 1. / 3, 12));
  const Temporary_folder folder;
  for (const std::string ending : {".off", ".obj", ".ply", ".STL"}) {
    SCOPED_TRACE(ending);
    const std::string filename = folder.file("mesh" + ending);
    CSCD::write_triangle_mesh(filename, mesh);
    Mesh copy;
    EXPECT_TRUE(CSCD::read_triangle_mesh(filename, copy).sentences().empty());
    ASSERT_EQ(num_vertices(mesh), num_vertices(copy));
    EXPECT_EQ(num_faces(mesh), num_faces(copy));
    if (ending != ".STL") { // which has no vertices, only corners
      for (const auto v : vertices(mesh)) {
        EXPECT_EQ(mesh.point(v), copy.point(v));
      }
    }
  }
}

TEST(Write_triangle_mesh, refuses_unknown_endings_and_places)
{
  const Temporary_folder folder;
  const Mesh mesh = to_mesh<Mesh>(cube());
  EXPECT_THROW(CSCD::write_triangle_mesh(folder.file("mesh.graph"), mesh), CSCD::File_error);
  EXPECT_THROW(CSCD::write_triangle_mesh(folder.file("missing/mesh.off"), mesh), CSCD::File_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
