// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a polygon soup, oriented and skeletonized. The skeleton has all invariants, or the
// soup is refused by an Input_error; everything else is a bug and aborts.

#include "Coded_soup.h"
#include "support/invariants.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::test::Coded_soup;

/// Bits of the first byte.
enum Option : unsigned
{
  huge = 1,      ///< coordinates near the largest numbers
  tiny = 2,      ///< coordinates near the smallest numbers
  far_away = 4,  ///< a body much smaller than its distance from the origin
  not_finite = 8 ///< extreme bytes stand for infinity and NaN
};

double coordinate(std::uint8_t byte, unsigned options)
{
  const int value = byte < 128 ? byte : byte - 256;
  if ((options & not_finite) != 0 && (value == 127 || value == -128)) {
    return value == 127 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  }
  const double scale = (options & huge) != 0 ? 1e288 : (options & tiny) != 0 ? 1e-290 : 1;
  return scale * value + ((options & far_away) != 0 ? scale * 1e9 : 0);
}

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

Soup to_soup(const Coded_soup& coded)
{
  Soup soup;
  for (const Coded_soup::Triple& point : coded.points) {
    soup.points.emplace_back(coordinate(point[0], coded.options), coordinate(point[1], coded.options),
                             coordinate(point[2], coded.options));
  }
  for (const Coded_soup::Triple& triangle : coded.triangles) {
    soup.polygons.emplace_back(triangle.begin(), triangle.end());
  }
  return soup;
}

[[noreturn]] void report_and_abort(const CSCD::test::Violations& violations)
{
  for (const std::string& violation : violations) {
    std::cerr << violation << '\n';
  }
  std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Coded_soup coded(data, size);
  Soup soup = to_soup(coded);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons);
  if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    return 0;
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  Skeleton skeleton;
  try {
    const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(
        mesh, skeleton, CSCD::parameters::maximum_number_of_sources(coded.maximum_number_of_sources));
    const CSCD::test::Violations violations = CSCD::test::violated_invariants_without_area(mesh, skeleton, report);
    if (!violations.empty()) {
      report_and_abort(violations);
    }
  } catch (const CSCD::Input_error& error) {
    if (std::string(error.what()).empty() || num_vertices(skeleton) != 0) {
      report_and_abort({"refused without message, or with an output"});
    }
  }
  return 0;
}
