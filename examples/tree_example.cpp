// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of a scanned tree as a table: parent, order, length, diameters; and the skeleton as an SWC file.
// Usage: tree_example [point file], by default a made-up trunk with two limbs, seen from one side

#include <CSCD/IO/read_points.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Tree/extract_tree_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

/// Appends the half of a cylinder that a scanner far away on the first axis sees.
void add_limb(const Point& base, const Vector& axis, double radius, std::vector<Point>& points)
{
  const double length = std::sqrt(axis.squared_length());
  const Vector along = axis / length;
  const Vector side = CGAL::cross_product(Vector(1, 0, 0), along) / std::sqrt(1 - along.x() * along.x());
  const Vector front = CGAL::cross_product(along, side);
  const double spacing = 0.015;
  for (double t = 0; t < length; t += spacing) {
    for (double arc = 0; arc < boost::math::double_constants::pi; arc += spacing / radius) {
      points.push_back(base + t * along + radius * (std::cos(arc) * side + std::sin(arc) * front));
    }
  }
}

std::vector<Point> made_up_tree()
{
  std::vector<Point> points;
  add_limb(Point(0, 0, 0), Vector(0, 0, 6), 0.12, points);
  add_limb(Point(0, 0, 2.5), Vector(0, 1.5, 1.5), 0.06, points);
  add_limb(Point(0, 0, 4), Vector(0, -1.2, 0.8), 0.05, points);
  return points;
}

} // namespace

int main(int argc, char** argv)
try {
  std::vector<Point> points;
  if (argc > 1) {
    std::vector<Vector> normals;
    CSCD::read_points(argv[1], points, normals);
  } else {
    points = made_up_tree();
  }
  //! [Tree]
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  const CSCD::Tree_report report = CSCD::extract_tree_skeleton(points, skeleton);

  std::cout << "branch,parent,order,length,diameter at base,diameter at tip\n";
  for (std::size_t i = 0; i < report.branches.size(); ++i) {
    const CSCD::Tree_branch& branch = report.branches[i];
    std::cout << i << ',' << (branch.parent == CSCD::no_branch ? "" : std::to_string(branch.parent)) << ','
              << branch.order << ',' << branch.length << ',' << 2 * branch.radius_at_base << ','
              << 2 * branch.radius_at_tip << '\n';
  }
  CSCD::write_skeleton("tree.swc", skeleton);
  //! [Tree]
  for (const std::string& warning : report.warnings) {
    std::cerr << warning << '\n';
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
