// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a polygon soup, oriented and skeletonized. The skeleton has all invariants, or the
// soup is refused by an Input_error; everything else is a bug and aborts.
//
// The bytes: options, the maximum number of sources, the number of points; three signed bytes for each point; then
// triangles, as three numbers of points each.

#include "Bytes.h"
#include "support/invariants.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
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
using CSCD::test::Bytes;

/// Bits of the first byte.
enum Option : unsigned
{
  huge = 1,      ///< coordinates near the largest numbers
  tiny = 2,      ///< coordinates near the smallest numbers
  far_away = 4,  ///< a body much smaller than its distance from the origin
  not_finite = 8 ///< extreme bytes stand for infinity and for what is not a number
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

Soup take_soup(Bytes& bytes, unsigned options)
{
  Soup soup;
  const std::size_t number_of_points = std::size_t(1) + bytes.take();
  for (std::size_t i = 0; i < number_of_points; ++i) {
    const double x = coordinate(bytes.take(), options);
    const double y = coordinate(bytes.take(), options);
    const double z = coordinate(bytes.take(), options);
    soup.points.emplace_back(x, y, z);
  }
  while (!bytes.is_at_end()) {
    const std::size_t a = bytes.take() % number_of_points;
    const std::size_t b = bytes.take() % number_of_points;
    const std::size_t c = bytes.take() % number_of_points;
    if (a != b && b != c && c != a) {
      soup.polygons.push_back({a, b, c});
    }
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
  Bytes bytes(data, size);
  const unsigned options = bytes.take();
  const std::size_t maximum_number_of_sources = bytes.take();
  Soup soup = take_soup(bytes, options);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons);
  if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    return 0;
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  Skeleton skeleton;
  try {
    const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(
        mesh, skeleton, CSCD::parameters::maximum_number_of_sources(maximum_number_of_sources));
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
