// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes made directly from few vertices: platonic bodies, spheres, discs, and bodies of few huge triangles as CAD
// programs write them.

#ifndef CSCD_TEST_SUPPORT_SIMPLE_SHAPES_H
#define CSCD_TEST_SUPPORT_SIMPLE_SHAPES_H

#include "Shape.h"
#include "shape_operations.h"
#include "swept_shapes.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::test {

inline Shape tetrahedron()
{
  Shape shape;
  shape.name = "tetrahedron";
  shape.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  shape.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return shape;
}

/// A box of 12 triangles, one corner in the origin.
inline Shape box(const std::string& name, const Triple& size)
{
  Shape shape;
  shape.name = name;
  for (std::size_t i = 0; i < 8; ++i) {
    shape.points.push_back({(i & 1) != 0 ? size[0] : 0, (i & 2) != 0 ? size[1] : 0, (i & 4) != 0 ? size[2] : 0});
  }
  shape.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return shape;
}

inline Shape cube()
{
  return box("cube", {1, 1, 1});
}

/// A prism of height 1 over a polygon mesh in the plane z = 0: a wall stands under each edge of one triangle only.
inline Shape prism(const std::string& name, const std::vector<Triple>& polygon, const std::vector<Triangle>& fill)
{
  const std::size_t n = polygon.size();
  Shape shape;
  shape.name = name;
  shape.points = polygon;
  for (const Triple& p : polygon) {
    shape.points.push_back({p[0], p[1], 1});
  }
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [a, b, c] : fill) {
    shape.triangles.push_back({a, c, b});
    shape.triangles.push_back({n + a, n + b, n + c});
    edges.insert({{a, b}, {b, c}, {c, a}});
  }
  for (const auto& [a, b] : edges) {
    if (edges.count({b, a}) == 0) {
      shape.triangles.push_back({a, b, n + b});
      shape.triangles.push_back({a, n + b, n + a});
    }
  }
  return shape;
}

/// A comb whose teeth, of width 1 and length 5, stand on a bar or on a triangle; slivers from one of its corners fill
/// it.
inline Shape comb(std::size_t teeth, bool has_bar)
{
  const double width = 2 * static_cast<double>(teeth) - 1;
  std::vector<Triple> polygon{has_bar ? Triple{width, -1, 0} : Triple{static_cast<double>(teeth), -10, 0}};
  std::vector<Triangle> fill;
  for (std::size_t i = teeth; i-- > 0;) { // from the right to the left
    const double x = 2 * static_cast<double>(i);
    const std::size_t first = polygon.size();
    polygon.insert(polygon.end(), {{x + 1, 1, 0}, {x + 1, 6, 0}, {x, 6, 0}, {x, 1, 0}});
    fill.insert(fill.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}, {0, first, first + 3}});
    if (i > 0) {
      fill.push_back({0, first + 3, first + 4});
    }
  }
  if (has_bar) {
    fill.push_back({0, polygon.size() - 1, polygon.size()});
    polygon.push_back({0, -1, 0});
  }
  return prism("comb", polygon, fill);
}

inline Shape subdivided_cube(std::size_t times)
{
  Shape shape = midpoint_subdivided(cube(), times);
  shape.name = "subdivided cube";
  return shape;
}

/// A long box of 12 huge triangles.
inline Shape beam()
{
  Shape shape = box("beam", {20, 1, 1});
  shape.centreline = {{{0.5, 0.5, 0.5}, {19.5, 0.5, 0.5}, 0.5, 0.5}};
  return shape;
}

/// The icosahedron, subdivided `times` times and its vertices moved to the unit sphere.
inline Shape sphere(std::size_t times)
{
  const double g = (1 + std::sqrt(5.0)) / 2;
  Shape shape;
  shape.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                  {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  shape.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  shape = midpoint_subdivided(shape, times);
  for (Triple& p : shape.points) {
    p = unit(p);
  }
  shape.name = "sphere";
  return shape;
}

/// A sphere stretched along the axes.
inline Shape ellipsoid(const Triple& half_axes, std::size_t times)
{
  Shape shape = moved(sphere(times), [&](const Triple& p) {
    return Triple{half_axes[0] * p[0], half_axes[1] * p[1], half_axes[2] * p[2]};
  });
  shape.name = "ellipsoid";
  return shape;
}

/// A ball with a ball-shaped cavity: two surfaces, one within the other.
inline Shape hollow_sphere(std::size_t times)
{
  return merged("hollow sphere", {sphere(times), reversed(scaled(sphere(times), 0.5))});
}

/// A flat open disc in the plane z = 0.
inline Shape flat_disc(std::size_t rings, std::size_t around)
{
  Shape shape;
  shape.name = "flat disc";
  for (std::size_t i = 1; i <= rings; ++i) {
    internal::add_ring(shape, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, static_cast<double>(i) / static_cast<double>(rings),
                       around);
  }
  for (std::size_t i = 0; i + 1 < rings; ++i) {
    internal::join_rings(shape, (i + 1) * around, i * around, around);
  }
  internal::add_fan(shape, 0, {0, 0, 0}, true, around);
  shape.number_of_border_cycles = 1;
  return shape;
}

/// A cone with one vertex of `valence` triangles at either end.
inline Shape double_cone(std::size_t valence)
{
  Shape shape;
  shape.name = "double cone";
  internal::add_ring(shape, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, valence);
  internal::add_fan(shape, 0, {4, 0, 0}, true, valence);
  internal::add_fan(shape, 0, {-4, 0, 0}, false, valence);
  return shape;
}

/// An L-shaped bracket of 20 triangles.
inline Shape l_bracket()
{
  return prism("L-bracket", {{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {1, 1, 0}, {1, 10, 0}, {0, 10, 0}},
               {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
}

/// A square plate with a square hole through it: 32 triangles, genus 1.
inline Shape plate_with_hole()
{
  Shape shape = prism("plate with hole",
                      {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {3, 3, 0}, {7, 3, 0}, {7, 7, 0}, {3, 7, 0}},
                      {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}});
  shape.genus = 1;
  return shape;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SIMPLE_SHAPES_H
