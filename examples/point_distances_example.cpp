// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of every point of a set from the first one along the surface that the points sample: writes the points
// as point_distances.ply, with bands of equal distance in two colors.

#include <CSCD/IO/read_points.h>
#include <CSCD/estimate_geodesic_distances_on_points.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Distance_map = Point_set::Property_map<double>;

/// The largest distance that is finite.
double eccentricity(const Point_set& points, const Distance_map& distance)
{
  double largest = 0;
  for (const auto& point : points) {
    largest = std::isfinite(distance[point]) ? std::max(largest, distance[point]) : largest;
  }
  return largest;
}

void color_bands(Point_set& points, const Distance_map& distance, double width)
{
  auto red = points.add_property_map<unsigned char>("red", 128).first;
  auto green = points.add_property_map<unsigned char>("green", 128).first;
  auto blue = points.add_property_map<unsigned char>("blue", 128).first;
  for (const auto& point : points) {
    if (std::isfinite(distance[point])) {
      const bool is_even = std::fmod(distance[point], 2 * width) < width;
      red[point] = is_even ? 250 : 200;
      green[point] = is_even ? 250 : 60;
      blue[point] = is_even ? 250 : 40;
    }
  }
}

} // namespace

int main(int argc, char** argv)
try {
  std::vector<Kernel::Point_3> positions;
  std::vector<Kernel::Vector_3> normals;
  CSCD::read_points(argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"), positions, normals);
  Point_set points;
  for (const Kernel::Point_3& position : positions) {
    points.insert(position);
  }
  //! [Distances from a point]
  const Point_set::Index source = *points.begin();
  auto distance = points.add_property_map<double>("distance", 0).first;
  CSCD::estimate_geodesic_distances(points, source, distance);
  //! [Distances from a point]

  const double farthest = eccentricity(points, distance);
  constexpr double number_of_bands = 30;
  color_bands(points, distance, farthest / number_of_bands);
  if (!CGAL::IO::write_PLY("point_distances.ply", points)) {
    std::cerr << "point_distances.ply: cannot be written\n";
    return 1;
  }
  std::cout << "point_distances.ply: the farthest point is " << farthest << " away\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
