// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of a skeleton.

#ifndef CSCD_MEASURE_SKELETON_MEASURES_H
#define CSCD_MEASURE_SKELETON_MEASURES_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD {

/// What stands for a measure that is not defined for the input.
inline constexpr double undefined_measure = std::numeric_limits<double>::quiet_NaN();

/// How far the input and a surface reconstructed from a skeleton are apart. Lengths are relative to the diagonal of the
/// bounding box of the input.
struct Reconstruction_error
{
  double mean = undefined_measure;        ///< distance from the points of the input to the faces of the reconstruction
  double mean_square = undefined_measure; ///< of the same distances, relative to the square of the diagonal
  double maximum = undefined_measure;     ///< of the same distances
  /// Mean distance from the reconstruction to the input, by area: what swells or hangs outside. To the faces of a mesh;
  /// to the nearest of the points, so that their spacing counts, if the input is a point cloud.
  double reverse_mean = undefined_measure;
  double reverse_maximum = undefined_measure;     ///< of the distances from the reconstruction to the input
  double unresolved_fraction = undefined_measure; ///< of the skeleton's length, which is too thin for the lattice
  double cell_size = undefined_measure;           ///< of the lattice
  std::size_t number_of_faces = 0;                ///< of the reconstruction; if 0, the distances are undefined
};

/// Counts and lengths of a skeleton alone.
struct Skeleton_counts
{
  std::size_t number_of_nodes = 0;          ///< vertices of the graph
  std::size_t number_of_edges = 0;          ///< edges of the graph, loops and parallel ones included
  std::size_t number_of_components = 0;     ///< connected components
  std::size_t betti_number = 0;             ///< the number of independent cycles
  std::size_t number_of_tips = 0;           ///< nodes with one edge
  std::size_t number_of_junctions = 0;      ///< nodes with three edges or more
  std::size_t number_of_isolated_nodes = 0; ///< nodes without edges
  double length = 0;                        ///< of all edges, relative to the diagonal
  /// Turning angle for each local radius that is gone along the branches, in radians: of a circle, the radius of the
  /// body over that of the circle.
  double mean_turning = undefined_measure;
  double max_turning = undefined_measure; ///< at a node with two edges, in radians
};

/// How a skeleton lies in the body.
struct Position_measures
{
  std::size_t number_of_surface_components = 0; ///< connected components of the surface
  std::size_t genus = 0;                        ///< of the surface, its borders closed by discs, over all components
  std::size_t number_of_borders = 0;            ///< border cycles of the surface
  double fraction_of_nodes_inside = undefined_measure;  ///< of all nodes
  double fraction_of_length_inside = undefined_measure; ///< of the length of all edges, by samples
  double max_distance_outside = undefined_measure;  ///< of nodes and samples; relative to the diagonal
  /// From rays across the skeleton to the surface: the standard deviation of their lengths over their mean. 0 in the
  /// centre of a round section, never 0 in one that is not round. The mean over nodes with one or two edges.
  double deviation_at_nodes = undefined_measure;
  double deviation_by_length = undefined_measure; ///< the mean over the length of the edges
  /// Likewise: the length of the mean of the rays' end points, as seen from the node, over the mean length. 0 in the
  /// centre of any section that is symmetric about a point.
  double offset_at_nodes = undefined_measure;
  double offset_by_length = undefined_measure; ///< the mean over the length of the edges
};

/// How good a skeleton is, for the input that it was evaluated with.
struct Skeleton_measures
{
  std::size_t number_of_points = 0; ///< of the input: vertices with a face, or points
  double diagonal = 0;              ///< of the bounding box of the input, in its unit
  Skeleton_counts counts;           ///< of the skeleton alone
  Position_measures position;       ///< undefined if the input is a point cloud
  Reconstruction_error convolution; ///< of the convolution surface, if it was asked for
  Reconstruction_error round_cones; ///< of the union of round cones, if it was asked for
  /// The mean of |signed distance| of the input's points from the round cones, without triangulation: exact outside, a
  /// lower bound inside. Relative to the diagonal.
  double mean_distance_from_round_cones = undefined_measure;

  /// Whether the skeleton has as many components as the surface and as many cycles as it has handles; false if the
  /// input is a point cloud.
  bool has_topology_of_surface() const
  {
    return position.number_of_surface_components > 0 &&
           counts.number_of_components == position.number_of_surface_components &&
           counts.betti_number == position.genus;
  }
};

} // namespace CSCD

namespace CSCD::internal {

/// The angle by which the path a, b, c turns at b, from 0 to pi; 0 where two of the points are equal.
inline double turning_angle(const Vector_3& a, const Vector_3& b, const Vector_3& c)
{
  const Vector_3 before = b - a;
  const Vector_3 after = c - b;
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

/// Measures how much the branches turn: the sum of the turning angles at nodes of two edges, over the length of the
/// edges that touch such nodes, half for each end, in local radii.
inline void measure_turning(const Indexed_skeleton& skeleton, const std::vector<double>& radii,
                            const std::vector<std::vector<Index>>& neighbors, Skeleton_counts& counts)
{
  double sum = 0;
  double length = 0; // in radii
  for (std::size_t v = 0; v < neighbors.size(); ++v) {
    if (neighbors[v].size() != 2) {
      continue;
    }
    const Vector_3& a = skeleton.points[neighbors[v][0]];
    const Vector_3& b = skeleton.points[v];
    const Vector_3& c = skeleton.points[neighbors[v][1]];
    const double angle = turning_angle(a, b, c);
    counts.max_turning = std::fmax(counts.max_turning, angle);
    if (radii[v] > 0) {
      sum += angle;
      length += ((a - b).norm() + (c - b).norm()) / 2 / radii[v];
    }
  }
  if (length > 0) {
    counts.mean_turning = sum / length;
  }
}

/// Counts nodes, edges, components, cycles, tips and junctions, and measures length and turning. Near linear.
/// \param radii of the nodes, for the unit of the turning
inline Skeleton_counts count_skeleton(const Indexed_skeleton& skeleton, const std::vector<double>& radii)
{
  Skeleton_counts counts;
  counts.number_of_nodes = skeleton.number_of_nodes();
  counts.number_of_edges = skeleton.edges.size();
  counts.number_of_components = skeleton.number_of_nodes();
  Disjoint_sets sets(skeleton.number_of_nodes());
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    counts.number_of_components -= sets.join(edge[0], edge[1]) ? 1 : 0;
    counts.length += skeleton.length(edge);
  }
  counts.betti_number = counts.number_of_edges + counts.number_of_components - counts.number_of_nodes;
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  for (const std::vector<Index>& around : neighbors) {
    counts.number_of_isolated_nodes += around.empty() ? 1 : 0;
    counts.number_of_tips += around.size() == 1 ? 1 : 0;
    counts.number_of_junctions += around.size() > 2 ? 1 : 0;
  }
  measure_turning(skeleton, radii, neighbors, counts);
  return counts;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_SKELETON_MEASURES_H
