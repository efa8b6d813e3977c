// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations that make new shapes of others: moving, renumbering, refining, shaking, merging.

#ifndef CSCD_TEST_SUPPORT_SHAPE_OPERATIONS_H
#define CSCD_TEST_SUPPORT_SHAPE_OPERATIONS_H

#include "Shape.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::test {

/// Numbers below `n` in an order drawn from `random`; the same on every platform, unlike that of `std::shuffle`.
inline std::vector<std::size_t> random_permutation(std::size_t n, std::mt19937_64& random)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i) {
    std::swap(order[i - 1], order[random() % i]);
  }
  return order;
}

/// `points` in another order: number `order[i]` comes as number i.
inline std::vector<Triple> permuted(const std::vector<Triple>& points, const std::vector<std::size_t>& order)
{
  std::vector<Triple> result;
  result.reserve(order.size());
  for (const std::size_t number : order) {
    result.push_back(points[number]);
  }
  return result;
}

/// A number in [-1, 1) drawn from `random`; the same on every platform.
inline double random_signed_unit(std::mt19937_64& random)
{
  return 2 * (static_cast<double>(random() >> 11) * 0x1.0p-53) - 1;
}

/// Removes the marked triangles, and the vertices that then have none. Properties of `shape` are left to the caller.
inline void remove_triangles(Shape& shape, const std::vector<bool>& is_removed)
{
  const std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> new_number(shape.points.size(), none);
  std::vector<Triple> points;
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    if (is_removed[t]) {
      continue;
    }
    Triangle triangle = shape.triangles[t];
    for (std::size_t& v : triangle) {
      if (new_number[v] == none) {
        new_number[v] = points.size();
        points.push_back(shape.points[v]);
      }
      v = new_number[v];
    }
    triangles.push_back(triangle);
  }
  shape.points = std::move(points);
  shape.triangles = std::move(triangles);
}

/// All of `shapes` side by side in one mesh; they must not touch.
inline Shape merged(const std::string& name, const std::vector<Shape>& shapes)
{
  Shape result;
  result.name = name;
  result.number_of_components = 0;
  std::size_t tips = 0;
  std::size_t junctions = 0;
  bool tips_known = true;
  bool junctions_known = true;
  for (const Shape& shape : shapes) {
    const std::size_t offset = result.points.size();
    result.points.insert(result.points.end(), shape.points.begin(), shape.points.end());
    for (const Triangle& t : shape.triangles) {
      result.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
    result.number_of_components += shape.number_of_components;
    result.genus += shape.genus;
    result.number_of_border_cycles += shape.number_of_border_cycles;
    result.centreline.insert(result.centreline.end(), shape.centreline.begin(), shape.centreline.end());
    tips += shape.number_of_tips.value_or(0);
    junctions += shape.number_of_junctions.value_or(0);
    tips_known = tips_known && shape.number_of_tips.has_value();
    junctions_known = junctions_known && shape.number_of_junctions.has_value();
  }
  if (tips_known) {
    result.number_of_tips = tips;
  }
  if (junctions_known) {
    result.number_of_junctions = junctions;
  }
  return result;
}

/// `shape` with `move(p)` for every point and `scale` for every radius.
template <class Move>
Shape moved(Shape shape, const Move& move, double scale = 1)
{
  for (Triple& p : shape.points) {
    p = move(p);
  }
  for (Centreline_segment& segment : shape.centreline) {
    segment.source = move(segment.source);
    segment.target = move(segment.target);
    segment.source_radius *= scale;
    segment.target_radius *= scale;
  }
  return shape;
}

inline Shape translated(const Shape& shape, const Triple& offset)
{
  return moved(shape, [&](const Triple& p) { return p + offset; });
}

inline Shape scaled(const Shape& shape, double factor)
{
  return moved(
      shape, [&](const Triple& p) { return factor * p; }, factor);
}

/// `shape` with all its triangles turned over.
inline Shape reversed(Shape shape)
{
  for (Triangle& t : shape.triangles) {
    std::swap(t[1], t[2]);
  }
  return shape;
}

/// A renumbered shape and the new number of each vertex.
struct Renumbered_shape
{
  Shape shape;
  std::vector<std::size_t> new_number; ///< of each old vertex
};

/// `shape` with its vertices and faces in another order, and each face beginning at another corner.
inline Renumbered_shape renumbered(const Shape& shape, std::size_t seed)
{
  std::mt19937_64 random(seed);
  Renumbered_shape result{shape, random_permutation(shape.points.size(), random)};
  for (std::size_t v = 0; v < shape.points.size(); ++v) {
    result.shape.points[result.new_number[v]] = shape.points[v];
  }
  const std::vector<std::size_t> face_order = random_permutation(shape.triangles.size(), random);
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    const Triangle& old_triangle = shape.triangles[face_order[t]];
    const std::size_t first = random() % 3;
    for (std::size_t k = 0; k < 3; ++k) {
      result.shape.triangles[t][k] = result.new_number[old_triangle[(first + k) % 3]];
    }
  }
  return result;
}

inline double mean_edge_length(const Shape& shape)
{
  double sum = 0;
  for (const Triangle& t : shape.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum += norm(shape.points[t[k]] - shape.points[t[(k + 1) % 3]]);
    }
  }
  return sum / (3 * static_cast<double>(shape.triangles.size()));
}

/// `shape` with every coordinate shifted by up to `amplitude` mean edge lengths.
inline Shape noisy(Shape shape, double amplitude, std::size_t seed)
{
  std::mt19937_64 random(seed);
  const double length = amplitude * mean_edge_length(shape);
  for (Triple& p : shape.points) {
    for (double& coordinate : p) {
      coordinate += length * random_signed_unit(random);
    }
  }
  shape.name = "noisy " + shape.name;
  return shape;
}

/// `shape` with every triangle split into four through the middles of its edges.
inline Shape midpoint_subdivided(const Shape& shape)
{
  Shape result = shape;
  result.triangles.clear();
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle_of_edge;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto [position, is_new] = middle_of_edge.try_emplace(std::minmax(a, b), result.points.size());
    if (is_new) {
      result.points.push_back(0.5 * (shape.points[a] + shape.points[b]));
    }
    return position->second;
  };
  for (const Triangle& t : shape.triangles) {
    const Triangle m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    result.triangles.push_back({t[0], m[0], m[2]});
    result.triangles.push_back({t[1], m[1], m[0]});
    result.triangles.push_back({t[2], m[2], m[1]});
    result.triangles.push_back(m);
  }
  return result;
}

/// `shape` subdivided `times` times.
inline Shape midpoint_subdivided(Shape shape, std::size_t times)
{
  for (std::size_t i = 0; i < times; ++i) {
    shape = midpoint_subdivided(shape);
  }
  return shape;
}

/// `shape` without the triangles around about `number_of_holes` vertices, drawn so that no two holes touch.
inline Shape with_small_holes(Shape shape, std::size_t number_of_holes, std::size_t seed)
{
  std::vector<std::vector<std::size_t>> triangles_of(shape.points.size());
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    for (const std::size_t v : shape.triangles[t]) {
      triangles_of[v].push_back(t);
    }
  }
  std::mt19937_64 random(seed);
  std::vector<bool> is_near_hole(shape.points.size(), false);
  std::vector<bool> is_removed(shape.triangles.size(), false);
  for (const std::size_t center : random_permutation(shape.points.size(), random)) {
    std::vector<std::size_t> ring;
    for (const std::size_t t : triangles_of[center]) {
      ring.insert(ring.end(), shape.triangles[t].begin(), shape.triangles[t].end());
    }
    const bool touches =
        std::any_of(ring.begin(), ring.end(), [&](std::size_t v) { return static_cast<bool>(is_near_hole[v]); });
    if (touches || shape.number_of_border_cycles == number_of_holes) {
      continue;
    }
    for (const std::size_t v : ring) {
      is_near_hole[v] = true;
    }
    for (const std::size_t t : triangles_of[center]) {
      is_removed[t] = true;
    }
    ++shape.number_of_border_cycles;
  }
  remove_triangles(shape, is_removed);
  shape.name += " with small holes";
  return shape;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SHAPE_OPERATIONS_H
