// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user may set about the search for separators from distance fields.

#ifndef CSCD_PUBLISHED_FIELD_SEARCH_SETTINGS_H
#define CSCD_PUBLISHED_FIELD_SEARCH_SETTINGS_H

#include <CSCD/Published/Cut_locus_settings.h>

#include <optional>
#include <variant>

namespace CSCD {

/// Which cut point is the target of a source.
enum class Target_rule
{
  nearest_in_space,     ///< minimum Euclidean distance: around the limb, however wide it is
  nearest_along_surface ///< minimum geodesic distance: on a wide body that may be around another limb (supplement, J.1)
};

/// How the published method shortens the loop of a source.
enum class Shortening_rule
{
  edge_flips, ///< to a geodesic, by flips of intrinsic edges (appendix E)
  variational ///< by the variational flow, projected to the surface (appendix F)
};

/// What the published method chooses the target of a source from.
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

/// What the published method prefers when it packs separators.
enum class Weight_rule
{
  balance_and_roundness, ///< balance times the root of the isoperimetric quotient
  balance,               ///< the ratio of the areas of the bands on both sides, as Baerentzen and Rotenberg's of fronts
  shortness,             ///< the inverse of the length (supplement, I.3), in roots of the area of the surface
  none                   ///< all alike: those come first that exclude few others
};

/// Where the published method places nodes.
enum class Placement_rule
{
  centroids, ///< at the centroids of regions by area (algorithm 2, line 13)
  sections   ///< on meshes as the local method: in the middle of sections across branches, with tips; else towards the
             ///< middle of separators, with tips
};

/// What a user may set about the search for separators from distance fields, their packing, and nodes.
struct Field_search_settings
{
  /// Which cut point is the target.
  Target_rule target_rule = Target_rule::nearest_in_space;
  /// By default edge flips on meshes and the variational flow among points, where edges cannot be flipped.
  std::optional<Shortening_rule> shortening_rule;

  /// What targets are chosen from.
  Cut_locus_rule cut_locus_rule = Cut_locus_rule::points;
  /// The greatest Laplacian of a cut point, times the spacing of the vertices; by default -0.5, among points -0.35.
  std::optional<double> laplacian_threshold{};
  /// The least angle between gradients at a cut point, in radians; by default pi/3, among points pi/4.
  std::optional<double> angle_threshold{};
  /// With `Cut_locus_rule::tree`: how the tree is filtered.
  std::variant<Pruning_policy, Growing_policy> cut_locus_policy{};
  /// With `Cut_locus_rule::tree`: the least length of a branch, relative to the distance of the farthest point.
  double minimum_branch_length = 0.03;

  /// How sources are drawn.
  Sampling_rule sampling_rule = Sampling_rule::rounds_by_area;
  /// When two separators overlap.
  Overlap_rule overlap_rule = Overlap_rule::nearest_vertex;
  /// Which of two separators that overlap is packed.
  Weight_rule weight_rule = Weight_rule::balance_and_roundness;
  /// Where nodes are placed.
  Placement_rule placement_rule = Placement_rule::centroids;
  /// Whether distances are computed on coarse levels of detail, from sources in their faces, and loops carried to the
  /// finest level and shortened again there (supplement, K.2); on meshes only.
  bool is_multiscale = false;

  /// Whether cut points, paths and loops are those of the intrinsic triangulation, as distances are (appendix G.1), and
  /// faces that fill holes are part of the surface for all of these; by default with edge flips on meshes, where alone
  /// that can be. A multiscale search takes no note of it.
  std::optional<bool> is_intrinsic{};

  /// The algorithms as printed where those of the default differ: targets on the cut locus, sources one by one, overlap
  /// by crossings.
  static Field_search_settings literal()
  {
    Field_search_settings settings;
    settings.cut_locus_rule = Cut_locus_rule::tree;
    settings.sampling_rule = Sampling_rule::one_by_one;
    settings.overlap_rule = Overlap_rule::crossing;
    return settings;
  }
};

} // namespace CSCD

#endif // CSCD_PUBLISHED_FIELD_SEARCH_SETTINGS_H
