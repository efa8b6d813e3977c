// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings of cut loci and of the published method.

#ifndef CSCD_PUBLISHED_FIELD_SEARCH_SETTINGS_H
#define CSCD_PUBLISHED_FIELD_SEARCH_SETTINGS_H

#include <CSCD/Named_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <optional>

namespace CSCD::internal {

/// How a cut locus is found; scale-free.
struct Cut_locus_settings
{
  /// At a cut point the scale-free Laplacian is at most this. Across a straight ridge where unit gradients meet at the
  /// angle a, it is about -2.3 sin(a/2); elsewhere it is positive or small.
  double laplacian_threshold = -0.5;
  /// Gradients around a cut point run against each other at this angle at least, in radians.
  double angle_threshold = boost::math::double_constants::third_pi;
  /// Relative to the distance of the farthest point. Found by eye on a dozen meshes: with less, short branches of noise
  /// remain; with more, those of thin limbs such as fingers are lost.
  double minimum_branch_length = 0.03;
};

/// The same on a cloud. The criterion is weaker than on a mesh, since means over neighbors round a ridge off. Chosen on
/// samples of a sphere, a capsule, a torus, an ellipsoid and a flat tube, random or even, with noise or without: of
/// what passes, 99.8 % lies within two edges of the true cut locus (of single gradients 97.9 %, and 70 % on the worst
/// cloud), and the cut locus where fronts meet at 60 degrees is near such a vertex everywhere. At a threshold of 60
/// degrees it is not (doc/cut_locus.md).
constexpr Cut_locus_settings point_cut_locus_settings()
{
  return {-0.35, boost::math::double_constants::pi / 4};
}

/// The settings that `np` gives, the `others` where it says nothing.
template <class NamedParameters>
Cut_locus_settings cut_locus_settings(const NamedParameters& np, const Cut_locus_settings& others)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return {choose_parameter(get_parameter(np, internal_np::laplacian_threshold), others.laplacian_threshold),
          choose_parameter(get_parameter(np, internal_np::angle_threshold), others.angle_threshold),
          choose_parameter(get_parameter(np, internal_np::minimum_branch_length), others.minimum_branch_length)};
}

} // namespace CSCD::internal

namespace CSCD {

/// Which cut point is the target of a source.
enum class Target_rule
{
  nearest_in_space,     ///< minimum Euclidean distance: around the limb, however wide it is
  nearest_along_surface ///< minimum geodesic distance: on a wide body that may be around another limb (supplement, J.1)
};

/// Where the published method chooses the target of a source.
enum class Cut_locus_rule
{
  points, ///< vertices that pass the thresholds, tested one by one: quick, since most are never looked at
  tree    ///< vertices of the cut locus: of the ORG tree, filtered, its loops closed, made thin (algorithm 3, line 2)
};

/// How the published method draws its sources.
enum class Sampling_rule
{
  rounds_by_area, ///< by area times distance from the nearest source of an earlier round of 32
  one_by_one ///< by distance from the nearest earlier source alone, the first uniformly (algorithm 2, lines 2 to 6)
};

/// When the published method takes two separators for overlapping.
enum class Overlap_rule
{
  nearest_vertex, ///< they pass closest to the same vertex: so each has a connected region
  crossing        ///< they meet in a face, by equations 7 and 8 of appendix C, or at a vertex; on meshes only
};

/// The preference of the published method when it packs separators.
enum class Weight_rule
{
  balance_and_roundness, ///< balance of both sides, as Baerentzen and Rotenberg's of fronts, times the root of the
                         ///< isoperimetric quotient (3.2.1)
  shortness              ///< the inverse of the length (supplement, I.3), in roots of the area of the surface
};

/// Where the published method places nodes.
enum class Placement_rule
{
  sections, ///< as the local method, in the middle of sections across branches, with tips; among points at centroids
  centroids ///< at the centroids of regions by area (algorithm 2, line 13)
};

/// Settings of the search for separators from distance fields, their packing, and nodes.
struct Field_search_settings
{
  /// Which cut point is the target.
  Target_rule target_rule = Target_rule::nearest_in_space;

  /// The points where targets are chosen.
  Cut_locus_rule cut_locus_rule = Cut_locus_rule::points;
  /// The greatest Laplacian of a cut point, times the spacing of the vertices; by default -0.5, among points -0.35.
  std::optional<double> laplacian_threshold{};
  /// The least angle between gradients at a cut point, in radians; by default pi/3, among points pi/4.
  std::optional<double> angle_threshold{};
  /// With `Cut_locus_rule::tree`: the least length of a branch, relative to the distance of the farthest point.
  double minimum_branch_length = 0.03;

  /// How sources are drawn.
  Sampling_rule sampling_rule = Sampling_rule::rounds_by_area;
  /// When two separators overlap.
  Overlap_rule overlap_rule = Overlap_rule::nearest_vertex;
  /// Which of two separators that overlap is packed.
  Weight_rule weight_rule = Weight_rule::balance_and_roundness;
  /// Where nodes are placed.
  Placement_rule placement_rule = Placement_rule::sections;
  /// Whether distances are computed on coarse levels of detail, from sources in their faces, and loops carried to the
  /// finest level and shortened again there (supplement, K.2); on meshes only.
  bool is_multiscale = false;

  /// The algorithms as printed where those of the default differ: targets on the cut locus, sources one by one, overlap
  /// by crossings, nodes at centroids.
  static Field_search_settings literal()
  {
    Field_search_settings settings;
    settings.cut_locus_rule = Cut_locus_rule::tree;
    settings.sampling_rule = Sampling_rule::one_by_one;
    settings.overlap_rule = Overlap_rule::crossing;
    settings.placement_rule = Placement_rule::centroids;
    return settings;
  }
};

} // namespace CSCD

#endif // CSCD_PUBLISHED_FIELD_SEARCH_SETTINGS_H
