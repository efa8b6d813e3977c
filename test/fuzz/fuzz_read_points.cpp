// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a file of points. The result is finite points with as many normals or none, or the
// content is refused in one line that names the file. Few points are skeletonized: each belongs to one node then, or
// they are refused. Everything else is a bug and aborts.
//
// The bytes: the format, then the content of the file.

#include "Coded_file.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;

constexpr std::size_t max_number_skeletonized = 500; // more would take most of the time

void skeletonize(const Points& points)
{
  CSCD::Skeleton_graph<Kernel::Point_3, std::size_t> skeleton;
  try {
    CSCD::extract_curve_skeleton(points, skeleton);
  } catch (const CSCD::Input_error& error) {
    if (std::string(error.what()).empty() || num_vertices(skeleton) != 0) {
      CSCD::test::fail("refused without message, or with an output");
    }
    return;
  }
  std::vector<int> times(points.size(), 0);
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    for (const std::size_t point : skeleton[v].vertices) {
      if (++times.at(point) > 1) {
        CSCD::test::fail("a point belongs to two nodes");
      }
    }
    if (!std::isfinite(skeleton[v].point.x() + skeleton[v].point.y() + skeleton[v].point.z())) {
      CSCD::test::fail("a node is not finite");
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CSCD::test::Coded_file file({data, size}, CSCD::test::endings_of_points);
  Points points;
  std::vector<Kernel::Vector_3> normals;
  try {
    CSCD::read_points(file.content, file.ending, "fuzz", points, normals);
  } catch (const CSCD::File_error& error) {
    CSCD::test::check_refusal(error, "fuzz");
    return 0;
  }
  if (points.empty() || (!normals.empty() && normals.size() != points.size())) {
    CSCD::test::fail("no points, or normals of some only");
  }
  if (points.size() <= max_number_skeletonized) {
    skeletonize(points);
  }
  return 0;
}
