// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances from vertices to the skeleton, averaged along the surface.

#include <CSCD/Application/Skeletonized_surface.h>
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

void smooth_along_surface(const Skeletonized_surface& surface, std::size_t number_of_steps, std::vector<double>& values)
{
  const std::size_t n = values.size();
  std::vector<double> sum(n);
  std::vector<double> weight(n); // an edge counts once for each of its faces
  for (std::size_t step = 0; step < number_of_steps; ++step) {
    std::fill(sum.begin(), sum.end(), 0.);
    std::fill(weight.begin(), weight.end(), 0.);
    for (const std::array<Index, 3>& face : surface.triangles.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[face[k]] += values[face[(k + 1) % 3]] + values[face[(k + 2) % 3]];
        weight[face[k]] += 2;
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      values[v] = (values[v] + sum[v] / weight[v]) / 2;
    }
  }
}

std::vector<double> vertex_shape_diameters(const Skeletonized_surface& surface, std::size_t number_of_smoothing_steps)
{
  const std::size_t n = surface.node.size();
  const std::vector<std::vector<Index>> neighbors = node_neighbors(surface.skeleton);
  std::vector<double> diameters(n);
  for (std::size_t v = 0; v < n; ++v) {
    diameters[v] = 2 * distance_to_edges(surface.skeleton, neighbors, surface.node[v], surface.triangles.points[v]);
  }
  smooth_along_surface(surface, number_of_smoothing_steps, diameters);
  return diameters;
}

std::vector<double> face_means(const Skeletonized_surface& surface, const std::vector<double>& vertex_values)
{
  std::vector<double> means;
  means.reserve(surface.triangles.faces.size());
  for (const auto& [a, b, c] : surface.triangles.faces) {
    means.push_back((vertex_values[a] + vertex_values[b] + vertex_values[c]) / 3);
  }
  return means;
}

} // namespace CSCD::internal
