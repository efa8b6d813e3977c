// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes inputs whose true shape is known, in OFF or, for points, in XYZ format:
//
// make_input OUTPUT shape NAME                        torus, knot or star with some 12,500 vertices
// make_input OUTPUT ring IS_BROKEN                    torus with two holes back to back, and a break if IS_BROKEN is 1
// make_input OUTPUT noise MESH DEVIATION              coordinates moved; the deviation in mean edge lengths
// make_input OUTPUT simplified MESH SHARE             with this share of the edges
// make_input OUTPUT holes MESH NUMBER                 without the triangles around so many vertices
// make_input OUTPUT points MESH NUMBER DEVIATION HOLES  points drawn from the mesh: the deviation relative to the mean
//                                                     distance to the nearest point, HOLES balls without points

#include "convert_shape.h"
#include "limb_shapes.h"
#include "sampling.h"
#include "shape_operations.h"
#include "swept_shapes.h"
#include <CSCD/IO/read_triangle_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CSCD::test::Shape;
using CSCD::test::Triple;
using CSCD::test::operator+; // of triples, which argument-dependent lookup does not find
using CSCD::test::operator*;

constexpr double number_of_vertices = 12500;

/// The number of edges around a tube that has so many vertices on every `area` squared radii of its surface.
std::size_t edges_around(double area)
{
  return std::size_t(std::lround(2 * CSCD::test::pi / std::sqrt(area / number_of_vertices)));
}

Shape make_torus()
{
  return CSCD::test::torus(3, 1, edges_around(4 * CSCD::test::pi * CSCD::test::pi * 3));
}

Shape make_shape(const std::string& name)
{
  if (name == "torus") {
    return make_torus();
  }
  if (name == "knot") {
    constexpr double radius = 0.4;
    constexpr double length = 32; // of the knot's curve
    return CSCD::test::trefoil_knot(radius, edges_around(2 * CSCD::test::pi * length / radius));
  }
  if (name != "star") {
    throw std::invalid_argument(name + " is not a shape");
  }
  Shape star = CSCD::test::star(5, 3, 0.35, 0.22);
  while (2 * double(star.points.size()) < number_of_vertices) {
    star = CSCD::test::midpoint_subdivided(star);
  }
  return star;
}

/// The torus whose skeleton the paper shows (supplement, H.3); the break is around the tube on the other side.
Shape make_ring(bool is_broken)
{
  constexpr double major_radius = 3;
  constexpr double hole_radius = 0.4;
  constexpr double half_width_of_break = 0.3;
  Shape shape = make_torus();
  std::vector<bool> is_removed;
  for (const CSCD::test::Triangle& t : shape.triangles) {
    const Triple center = (1. / 3) * (shape.points[t[0]] + shape.points[t[1]] + shape.points[t[2]]);
    const bool is_in_hole = std::hypot(center[0] - major_radius, center[1]) < hole_radius; // above and below
    const bool is_in_break = is_broken && center[0] < 0 && std::fabs(center[1]) < half_width_of_break;
    is_removed.push_back(is_in_hole || is_in_break);
  }
  remove_triangles(shape, is_removed);
  return shape;
}

Shape simplified(const Shape& shape, double edges_to_keep)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  CGAL::Surface_mesh_simplification::Count_ratio_stop_predicate<Mesh> stop(edges_to_keep);
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
  return CSCD::test::to_shape(mesh);
}

Shape sampled(const Shape& shape, std::size_t number, double deviation, std::size_t holes)
{
  constexpr double hole_radius = 0.02; // relative to the diagonal of the bounding box
  std::vector<Triple> points = CSCD::test::sampled(shape, number, 1);
  const std::vector<Triple> centers(points.begin(), points.begin() + std::ptrdiff_t(holes));
  for (const Triple& center : centers) {
    points = CSCD::test::without_ball(std::move(points), center, hole_radius * diagonal(shape));
  }
  Shape result;
  result.points = CSCD::test::shaken(std::move(points), deviation * CSCD::test::mean_spacing(shape, number), 2);
  return result;
}

Shape make(const std::vector<std::string>& arguments)
{
  const std::string& kind = arguments.at(0);
  const std::string& what = arguments.at(1);
  if (kind == "shape") {
    return make_shape(what);
  }
  if (kind == "ring") {
    return make_ring(what == "1");
  }
  Mesh mesh;
  CSCD::read_triangle_mesh(what, mesh);
  Shape shape = CSCD::test::to_shape(mesh);
  const double number = std::stod(arguments.at(2));
  if (kind == "noise") {
    shape.points = CSCD::test::shaken(shape.points, number * CSCD::test::mean_edge_length(shape), 1);
    return shape;
  }
  if (kind == "simplified") {
    return simplified(shape, number);
  }
  if (kind == "holes") {
    return CSCD::test::with_small_holes(shape, std::size_t(number), 1);
  }
  if (kind == "points") {
    return sampled(shape, std::size_t(number), std::stod(arguments.at(3)), std::stoul(arguments.at(4)));
  }
  throw std::invalid_argument(kind + " is not a kind of input");
}

void write(const std::string& path, const Shape& shape)
{
  std::ofstream out(path);
  out.precision(std::numeric_limits<double>::max_digits10);
  if (!shape.triangles.empty()) {
    out << "OFF\n" << shape.points.size() << ' ' << shape.triangles.size() << " 0\n";
  }
  for (const Triple& p : shape.points) {
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for (const CSCD::test::Triangle& t : shape.triangles) {
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
}

} // namespace

int main(int argc, char** argv)
try {
  write(argc > 1 ? argv[1] : "", make({argv + std::min(argc, 2), argv + argc}));
} catch (const std::exception& error) {
  std::cerr << "make_input: " << error.what() << '\n';
  return 1;
}
