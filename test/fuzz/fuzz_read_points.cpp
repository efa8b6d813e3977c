// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a file of points. The result is finite points with as many normals or none, or the
// content is refused in one line that names the file. Few points are skeletonized: each belongs to one node then, or
// they are refused. Everything else is a bug and aborts.
//
// The bytes: the format, then the content of the file.

#include "Bytes.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;

constexpr std::array<const char*, 7> endings_of_points{".xyz", ".pts", ".ply", ".off", ".vtk", ".pcd", ".las"};
constexpr std::size_t max_number_skeletonized = 500; // more would take most of the time
const std::string name_of_points = "fuzz";

[[noreturn]] void complain_of_points(const std::string& what)
{
  std::cerr << what << '\n';
  std::abort();
}

void check_refusal(const std::exception& error)
{
  const std::string message = error.what();
  if (message.find('\n') != std::string::npos || message.rfind(name_of_points, 0) != 0) {
    complain_of_points("refused badly: " + message);
  }
}

void skeletonize(const Points& points)
{
  CSCD::Skeleton_graph<Kernel::Point_3, std::size_t> skeleton;
  try {
    CSCD::extract_curve_skeleton(points, skeleton);
  } catch (const CSCD::Input_error& error) {
    if (std::string(error.what()).empty() || num_vertices(skeleton) != 0) {
      complain_of_points("refused without message, or with an output");
    }
    return;
  }
  std::vector<int> times(points.size(), 0);
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    for (const std::size_t point : skeleton[v].vertices) {
      if (++times.at(point) > 1) {
        complain_of_points("a point belongs to two nodes");
      }
    }
    if (!std::isfinite(skeleton[v].point.x() + skeleton[v].point.y() + skeleton[v].point.z())) {
      complain_of_points("a node is not finite");
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CSCD::test::Bytes bytes(data, size);
  const char* const format = endings_of_points[bytes.take() % endings_of_points.size()];
  std::istringstream in(bytes.rest());
  Points points;
  std::vector<Kernel::Vector_3> normals;
  try {
    CSCD::read_points(in, format, name_of_points, points, normals);
  } catch (const CSCD::File_error& error) {
    check_refusal(error);
    return 0;
  }
  if (points.empty() || (!normals.empty() && normals.size() != points.size())) {
    complain_of_points("no points, or normals of some only");
  }
  if (points.size() <= max_number_skeletonized) {
    skeletonize(points);
  }
  return 0;
}
