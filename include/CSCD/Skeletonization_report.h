// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a skeletonization.

#ifndef CSCD_SKELETONIZATION_REPORT_H
#define CSCD_SKELETONIZATION_REPORT_H

#include <CSCD/Skeletonization_visitor.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CSCD::internal {

/// `count` and its noun: `one` after 1, else `many`.
inline std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// The same for nouns whose plural ends in `s`.
inline std::string counted(std::size_t count, const std::string& noun)
{
  return counted(count, noun, noun + 's');
}

} // namespace CSCD::internal

namespace CSCD {

/// The outcome for a source or for one of its cut points.
enum class Cut_loop_outcome
{
  found,                ///< a closed curve
  no_cut_point,         ///< the source has no cut point outside of its neighborhood
  distance_below_chord, ///< the distance is less than that in space, which only an estimate can be
  one_direction,        ///< all fronts arrive from one side
  not_connected,        ///< no path leads down to the source
  meets_at_once,        ///< the paths to the source join at the target or next to it: nothing is enclosed
  narrow                ///< the paths to the source stay close together: they go around a bump
};

/// Number of values of `Cut_loop_outcome`.
inline constexpr std::size_t number_of_cut_loop_outcomes = std::size_t(Cut_loop_outcome::narrow) + 1;

/// A place where the reconstructed surface was cut or joined, in the coordinates of the input.
struct Reconstruction_repair
{
  std::array<double, 3> center{}; ///< of the loop that was cut, or of the gap that was bridged
  double length = 0;              ///< of the loop that was cut, or the width of the gap, in the unit of the input
};

/// Counts and measures of the reconstruction of a surface from points. Lengths are in the unit of the input.
struct Reconstruction_report
{
  std::size_t number_of_points = 0;         ///< points of the input
  std::size_t number_of_duplicates = 0;     ///< points that are at the place of another one
  std::size_t number_of_thinned_points = 0; ///< points left out of dense clouds: they belong to the node of the nearest
  bool is_averaged = false;                 ///< whether noise was averaged away where the cloud was thinned
  std::size_t number_of_neighbors = 0;      ///< the k of the neighborhoods
  double spacing = 0;                       ///< median over the points of the mean distance to the nearest six
  double noise = 0;                         ///< lower quartile of the deviations from quadrics, relative to the spacing
  bool is_smoothed = false;                 ///< whether the points were moved to the quadrics
  std::size_t number_of_outliers = 0;       ///< points far from all others: left out of the surface
  std::size_t number_of_unused_points = 0;  ///< points that are not vertices: they belong to the node of the nearest
  std::size_t number_of_border_edges = 0;   ///< edges at holes of the surface
  std::size_t number_of_holes = 0;          ///< holes that were closed
  std::vector<Reconstruction_repair> cut_handles; ///< handles that are too small for the sampling to prove them
  std::vector<Reconstruction_repair> joined_gaps; ///< gaps between the fragments of one body

  /// The points that a surface is made of.
  std::size_t number_of_sampled_points() const { return number_of_points - number_of_thinned_points; }
};

/// Counts, timings and warnings of one skeletonization.
struct Skeletonization_report
{
  /// \name Input
  /// @{
  std::size_t number_of_input_vertices = 0;     ///< input vertices or points that the skeleton partitions
  std::size_t number_of_isolated_vertices = 0;  ///< input vertices without any face: no part of the surface
  std::size_t number_of_surface_components = 0; ///< connected components of the surface, cavities not counted
  std::size_t number_of_cavities = 0;           ///< components within bodies that face inwards: they are filled
  std::size_t number_of_bridged_borders = 0;    ///< border cycles that were closed by faces without weight
  std::size_t number_of_sheets = 0;             ///< components that are sheets, where separators may be open
  std::size_t number_of_wide_borders = 0;       ///< border cycles of sheets where open separators end
  std::size_t number_of_inserted_vertices = 0;  ///< vertices inserted where faces were too large to sample
  std::size_t number_of_degenerate_faces = 0;   ///< faces of (nearly) no area; kept, they carry no weight
  std::size_t number_of_levels = 0;             ///< levels of detail, the input included
  /// Of the (bridged) surface, summed over its components: a sheet of genus g with b wide borders has 2 g + b - 1. Of
  /// points without a surface it is not known.
  std::optional<std::size_t> genus;
  /// The reconstruction of a surface from points; nothing for a mesh.
  std::optional<Reconstruction_report> reconstruction;
  /// @}

  /// \name Separators
  /// @{
  std::size_t number_of_sources = 0;             ///< sources that started a search for a separator
  std::size_t number_of_sources_without_cut = 0; ///< sources whose search found neither a separator nor a bump
  /// Why sources have no cut point that is accepted, in the order of `Cut_loop_outcome`; published only.
  std::array<std::size_t, number_of_cut_loop_outcomes> number_of_rejections{};
  std::size_t number_of_collapsed_loops = 0;    ///< the loop shrank to a point when it was shortened; published only
  std::size_t number_of_held_loops = 0;         ///< separators that only the locality constraint holds; published only
  std::size_t number_of_unfinished_loops = 0;   ///< separators that could still be shortened; published only
  std::size_t number_of_bumps = 0;              ///< separators rejected since they only encircle a bump
  std::size_t number_of_tunnels = 0;            ///< separators around hollows, dropped after the search or in packing
  std::size_t number_of_separators = 0;         ///< separators found
  std::size_t number_of_plane_sections = 0;     ///< separators shortened by the section plane
  std::size_t number_of_straightened_loops = 0; ///< separators shortened by straightening
  std::size_t number_of_packed_separators = 0;  ///< separators that cut the surface
  std::size_t number_of_open_separators = 0;    ///< packed separators of sheets, from border to border
  std::size_t number_of_handle_cuts = 0;        ///< packed separators added for handles that no source had found
  /// @}

  /// \name Skeleton
  /// @{
  std::size_t number_of_nodes = 0;               ///< vertices of the graph
  std::size_t number_of_edges = 0;               ///< edges of the graph
  std::size_t number_of_skeleton_components = 0; ///< connected components, as many as of the surface
  std::size_t betti_number = 0;                  ///< first Betti number: edges - nodes + components
  std::size_t number_of_tips = 0;                ///< nodes of degree 1
  std::size_t number_of_junctions = 0;           ///< nodes of degree 3 or more
  std::size_t number_of_openings = 0;            ///< nodes at borders of the input, where limbs end
  std::size_t number_of_nodes_outside = 0;       ///< nodes that are not inside the (bridged) surface
  std::size_t number_of_edges_outside = 0;       ///< edges that are not wholly inside
  /// @}

  /// Number of threads that the parallel part may have used.
  std::size_t number_of_threads = 1;
  /// Wall-clock seconds of each stage.
  std::array<double, number_of_skeletonization_stages> seconds{};
  /// One sentence each.
  std::vector<std::string> warnings;

  /// Adds the warning "`count` `many`", or "1 `one`", unless `count` is 0.
  void add_warning(std::size_t count, const std::string& one, const std::string& many)
  {
    if (count > 0) {
      warnings.push_back(internal::counted(count, one, many));
    }
  }
};

} // namespace CSCD

#endif // CSCD_SKELETONIZATION_REPORT_H
