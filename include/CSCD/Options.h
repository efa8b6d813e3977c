// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options of a skeletonization, with their defaults, ranges and help.

#ifndef CSCD_OPTIONS_H
#define CSCD_OPTIONS_H

#include <cstddef>
#include <limits>

namespace CSCD {

/// How the borders of a surface are treated.
enum class Border_treatment
{
  automatic, ///< components that are sheets are doubled along their wide borders, all other borders are bridged
  bridge,    ///< all borders are bridged by faces without weight: the surface bounds a body with holes
  open       ///< components with borders are sheets, and all of their borders are wide
};

/// The options of a skeletonization by the local method. None has a unit: lengths are relative to the shape.
struct Options
{
  /// The seed for the order of trying vertices as sources.
  unsigned random_seed = 0;
  /// The number of threads; 0 means as many as TBB allows. The skeleton is the same for any number.
  unsigned number_of_threads = 1;
  /// The bound on the number of sources that start a search for a separator. By default, the shape decides.
  std::size_t maximum_number_of_sources = std::numeric_limits<std::size_t>::max();
  /// How small a limb may be to get a branch, from 0 (no limb) to 1 (every bump); other numbers are refused by an
  /// `Input_error`. See `Detail`.
  double detail = 0.5;
  /// The length that edges may have where nodes are left out of straight branches, in radii of the body. At 0, the
  /// default, only nodes that no vertex of the input belongs to are left out.
  double node_spacing = 0;
  /// Which components are sheets.
  Border_treatment border_treatment = Border_treatment::automatic;
};

} // namespace CSCD

#endif // CSCD_OPTIONS_H
