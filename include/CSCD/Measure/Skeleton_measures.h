// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of skeletons.

#ifndef CSCD_MEASURE_SKELETON_MEASURES_H
#define CSCD_MEASURE_SKELETON_MEASURES_H

#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD {

/// The value of a measure that is not defined for the input.
inline constexpr double undefined_measure = std::numeric_limits<double>::quiet_NaN();

/// How far the input and a surface reconstructed from a skeleton are apart. Lengths are relative to the diagonal of the
/// bounding box of the input.
struct Reconstruction_error
{
  double mean = undefined_measure;        ///< distance from the points of the input to the faces of the reconstruction
  double mean_square = undefined_measure; ///< of the same distances, relative to the square of the diagonal
  double maximum = undefined_measure;     ///< of the same distances
  /// Mean distance from the reconstruction to the input, by area: parts that swell or stick out. To the faces of a
  /// mesh; to the nearest of the points, so that their spacing counts, if the input is a point cloud.
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
  double max_distance_outside = undefined_measure;      ///< of nodes and samples; relative to the diagonal
  /// From rays across the skeleton to the surface: the standard deviation of their lengths over their mean. 0 in the
  /// center of a round section, never 0 in one that is not round. The mean over the length of the edges.
  double deviation_by_length = undefined_measure;
  /// Likewise: the length of the mean of the rays' end points, as seen from where they begin, over the mean length. 0
  /// in the center of any section that is symmetric about a point.
  double offset_by_length = undefined_measure;
};

/// A limb of the surface: a part that reaches out of the rest, `doc/measures.md` says how far.
struct Surface_limb
{
  Vector3 tip = Vector3::Zero(); ///< the vertex that is farthest from the rest, in the coordinates of the input
  double height = 0;             ///< from where the limb begins to the tip, relative to the diagonal
  bool has_tip = false;          ///< whether a tip of the skeleton belongs to it
};

/// How well the tips of a skeleton and the limbs of the surface belong together, in pairs.
struct Limb_measures
{
  std::vector<Surface_limb> limbs;             ///< of the surface
  std::size_t number_of_limbs_without_tip = 0; ///< missed limbs
  std::size_t number_of_tips_without_limb = 0; ///< spurious tips
  double tip_recall = undefined_measure;       ///< the fraction of the limbs that have a tip
  double tip_precision = undefined_measure;    ///< the fraction of the tips that have a limb
};

/// How good a skeleton is, for the input that it was evaluated with.
struct Skeleton_measures
{
  std::size_t number_of_points = 0; ///< of the input: vertices with a face, or points
  double diagonal = 0;              ///< of the bounding box of the input, in its unit
  Skeleton_counts counts;           ///< of the skeleton alone
  Position_measures position;       ///< undefined if the input is a point cloud
  Limb_measures limbs;              ///< undefined if the input is a point cloud
  Reconstruction_error convolution; ///< of the convolution surface
  Reconstruction_error round_cones; ///< of the union of round cones
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

/// How far the points of one skeleton are from another one. Lengths are relative to the diagonal of the bounding box of
/// both skeletons.
struct Skeleton_distance
{
  double mean = 0;             ///< over the length of the edges
  double maximum = 0;          ///< over edges and nodes
  double fraction_matched = 0; ///< of the length: the part no farther away than the match distance
};

/// How many features of two skeletons are at the same place.
struct Match_count
{
  std::size_t number_in_first = 0;  ///< features of the first skeleton
  std::size_t number_in_second = 0; ///< features of the second skeleton
  std::size_t number_matched = 0;   ///< pairs of features at the same place; each is in one pair at most

  /// 1 if all are matched, 0 if none are; 1 if there are none.
  double fraction() const
  {
    const std::size_t sum = number_in_first + number_in_second;
    return sum > 0 ? 2 * double(number_matched) / double(sum) : 1;
  }
};

/// How alike two skeletons are.
struct Skeleton_comparison
{
  double diagonal = 0;                    ///< of the bounding box of both, in their unit
  double match_distance = 0;              ///< up to it, features count as the same; relative to the diagonal
  Skeleton_distance from_first_to_second; ///< of the points of the first from the second
  Skeleton_distance from_second_to_first; ///< of the points of the second from the first
  Match_count tips;                       ///< nodes with one edge
  Match_count junctions;                  ///< nodes with three edges or more

  /// The mean of both mean distances.
  double mean_distance() const { return (from_first_to_second.mean + from_second_to_first.mean) / 2; }
  /// The greater one of both maxima.
  double hausdorff_distance() const { return std::max(from_first_to_second.maximum, from_second_to_first.maximum); }
};

} // namespace CSCD

#endif // CSCD_MEASURE_SKELETON_MEASURES_H
