// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples of a skeleton by length.

#ifndef CSCD_MEASURE_SAMPLE_EDGES_H
#define CSCD_MEASURE_SAMPLE_EDGES_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <vector>

namespace CSCD::internal {

/// A point of a skeleton, and the unit direction of its edge.
struct Edge_sample
{
  Vector_3 point = Vector_3::Zero();
  Vector_3 tangent = Vector_3::Zero();
};

/// Samples the edges of `skeleton` evenly: they are laid end to end in their order, and every piece of length `spacing`
/// gets a sample at its middle. So each sample stands for the same length, however the skeleton is cut into edges.
/// O(e + l / spacing) for e edges of total length l.
/// \pre `spacing` is positive
inline std::vector<Edge_sample> sample_edges(const Indexed_skeleton& skeleton, double spacing)
{
  std::vector<Edge_sample> samples;
  double to_next = spacing / 2;
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    const double length = skeleton.length(edge);
    if (!(length > 0)) {
      continue;
    }
    const Vector_3& source = skeleton.points[edge[0]];
    const Vector_3 tangent = (skeleton.points[edge[1]] - source) / length;
    while (to_next <= length) {
      samples.push_back({source + to_next * tangent, tangent});
      to_next += spacing;
    }
    to_next -= length;
  }
  return samples;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_SAMPLE_EDGES_H
