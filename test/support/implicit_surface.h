// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed manifold triangle mesh of an implicit surface, by marching tetrahedra.

#ifndef CSCD_TEST_SUPPORT_IMPLICIT_SURFACE_H
#define CSCD_TEST_SUPPORT_IMPLICIT_SURFACE_H

#include "Shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CSCD::test {

namespace internal {

/// A grid of cubes, each cut into the six tetrahedra around its main diagonal: neighboring cubes agree on their faces.
template <class Function>
class Marching_tetrahedra
{
public:
  Marching_tetrahedra(const Function& function, const Triple& lower, const Triple& upper, double cell_size)
      : m_lower(lower), m_cell_size(cell_size)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      m_size[axis] = 1 + static_cast<std::size_t>(std::ceil((upper[axis] - lower[axis]) / cell_size));
    }
    for (std::size_t z = 0; z < m_size[2]; ++z) {
      for (std::size_t y = 0; y < m_size[1]; ++y) {
        for (std::size_t x = 0; x < m_size[0]; ++x) {
          m_values.push_back(function(position(number({x, y, z}))));
        }
      }
    }
  }

  Shape operator()()
  {
    for (std::size_t z = 0; z + 1 < m_size[2]; ++z) {
      for (std::size_t y = 0; y + 1 < m_size[1]; ++y) {
        for (std::size_t x = 0; x + 1 < m_size[0]; ++x) {
          march_cube({x, y, z});
        }
      }
    }
    return std::move(m_shape);
  }

private:
  using Cell = std::array<std::size_t, 3>;
  using Edge = std::pair<std::size_t, std::size_t>;

  std::size_t number(const Cell& cell) const { return cell[0] + m_size[0] * (cell[1] + m_size[1] * cell[2]); }

  Triple position(std::size_t node) const
  {
    const std::size_t x = node % m_size[0];
    const std::size_t y = node / m_size[0] % m_size[1];
    const std::size_t z = node / m_size[0] / m_size[1];
    return m_lower + m_cell_size * Triple{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }

  bool is_inside(std::size_t node) const { return m_values[node] < 0; }

  void march_cube(const Cell& cell)
  {
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      std::array<std::size_t, 4> nodes{};
      Cell corner = cell;
      nodes[0] = number(corner);
      for (std::size_t k = 0; k < 3; ++k) {
        ++corner[axes[k]];
        nodes[k + 1] = number(corner);
      }
      march_tetrahedron(nodes);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void march_tetrahedron(const std::array<std::size_t, 4>& nodes)
  {
    std::vector<std::size_t> in;
    std::vector<std::size_t> out;
    for (const std::size_t node : nodes) {
      (is_inside(node) ? in : out).push_back(node);
    }
    if (in.size() == 1) {
      add_triangle({{{in[0], out[0]}, {in[0], out[1]}, {in[0], out[2]}}}, in, out);
    } else if (in.size() == 3) {
      add_triangle({{{in[0], out[0]}, {in[1], out[0]}, {in[2], out[0]}}}, in, out);
    } else if (in.size() == 2) {
      add_triangle({{{in[0], out[0]}, {in[0], out[1]}, {in[1], out[1]}}}, in, out);
      add_triangle({{{in[0], out[0]}, {in[1], out[1]}, {in[1], out[0]}}}, in, out);
    }
  }

  /// Adds the triangle with a vertex on each of `edges`, turned so that it faces the nodes of `out`.
  void add_triangle(const std::array<Edge, 3>& edges, const std::vector<std::size_t>& in,
                    const std::vector<std::size_t>& out)
  {
    Triangle triangle{};
    std::array<Triple, 3> middle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = vertex_on(edges[k]);
      middle[k] = 0.5 * (position(edges[k].first) + position(edges[k].second));
    }
    const Triple normal = cross(middle[1] - middle[0], middle[2] - middle[0]);
    if (dot(normal, position(out[0]) - position(in[0])) < 0) {
      std::swap(triangle[1], triangle[2]);
    }
    m_shape.triangles.push_back(triangle);
  }

  std::size_t vertex_on(const Edge& edge)
  {
    const Edge key = std::minmax(edge.first, edge.second);
    const auto [place, is_new] = m_vertex_on_edge.try_emplace(key, m_shape.points.size());
    if (is_new) {
      // Vertices stay away from the nodes of the grid, since triangles would degenerate there.
      const double margin = 0.1;
      const double a = m_values[key.first];
      const double b = m_values[key.second];
      const double t = std::fmin(1 - margin, std::fmax(margin, a / (a - b)));
      m_shape.points.push_back((1 - t) * position(key.first) + t * position(key.second));
    }
    return place->second;
  }

  Triple m_lower;
  double m_cell_size;
  Cell m_size{};
  std::vector<double> m_values;
  std::map<Edge, std::size_t> m_vertex_on_edge;
  Shape m_shape;
};

template <class Function>
Triple gradient(const Function& function, const Triple& p, double step)
{
  Triple result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Triple lower = p;
    Triple upper = p;
    lower[axis] -= step;
    upper[axis] += step;
    result[axis] = (function(upper) - function(lower)) / (2 * step);
  }
  return result;
}

/// Evens out the triangles: every vertex goes halfway to the mean of its neighbors, then back to the surface.
template <class Function>
void smooth_on_surface(Shape& shape, const Function& function, double cell_size)
{
  std::vector<Triple> sum(shape.points.size(), Triple{});
  std::vector<double> count(shape.points.size(), 0);
  for (const Triangle& t : shape.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[t[k]] = sum[t[k]] + shape.points[t[(k + 1) % 3]];
      count[t[k]] += 1;
    }
  }
  for (std::size_t v = 0; v < shape.points.size(); ++v) {
    Triple p = 0.5 * shape.points[v] + (0.5 / count[v]) * sum[v];
    const Triple slope = gradient(function, p, 0.01 * cell_size);
    const double squared_slope = dot(slope, slope);
    if (squared_slope > 0) {
      const double step = function(p) / squared_slope;
      const double longest_step = 0.5 * cell_size / std::sqrt(squared_slope);
      p = p - std::fmin(longest_step, std::fmax(-longest_step, step)) * slope;
    }
    shape.points[v] = p;
  }
}

} // namespace internal

/// The boundary of the set where `function` is negative; the set must keep away from the box between `lower` and
/// `upper`, or the surface ends at the box. Triangles are about `cell_size` wide.
template <class Function>
Shape implicit_surface(const Function& function, const Triple& lower, const Triple& upper, double cell_size)
{
  Shape shape = internal::Marching_tetrahedra<Function>(function, lower, upper, cell_size)();
  const std::size_t number_of_smoothing_steps = 4;
  for (std::size_t i = 0; i < number_of_smoothing_steps; ++i) {
    internal::smooth_on_surface(shape, function, cell_size);
  }
  return shape;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_IMPLICIT_SURFACE_H
