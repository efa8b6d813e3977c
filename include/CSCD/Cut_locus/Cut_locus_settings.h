// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user may set about the extraction of a cut locus.

#ifndef CSCD_CUT_LOCUS_CUT_LOCUS_SETTINGS_H
#define CSCD_CUT_LOCUS_CUT_LOCUS_SETTINGS_H

#include <CSCD/Named_parameters.h>

#include <boost/math/constants/constants.hpp>

namespace CSCD::internal {

/// When a vertex counts as a point of the cut locus; scale-free.
struct Cut_criterion
{
  /// The scale-free Laplacian is at most this. Across a straight ridge where unit gradients meet at the angle a, it is
  /// about -2.3 sin(a/2); elsewhere it is positive or small.
  double laplacian_threshold = -0.5;
  /// Gradients around the vertex run against each other at this angle at least, in radians.
  double angle_threshold = boost::math::double_constants::third_pi;
};

/// How a cut locus is found; scale-free.
struct Cut_locus_settings
{
  Cut_criterion criterion;
  /// Relative to the distance of the farthest point. Found by eye on a dozen meshes: less leaves thorns, more takes
  /// fingers.
  double minimum_branch_length = 0.03;
  int number_of_iterations = 10;
};

/// The settings that `np` gives, with `default_criterion` where it says nothing.
template <class NamedParameters>
Cut_locus_settings cut_locus_settings(const NamedParameters& np, const Cut_criterion& default_criterion)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Cut_locus_settings settings;
  settings.criterion.laplacian_threshold =
      choose_parameter(get_parameter(np, internal_np::laplacian_threshold), default_criterion.laplacian_threshold);
  settings.criterion.angle_threshold =
      choose_parameter(get_parameter(np, internal_np::angle_threshold), default_criterion.angle_threshold);
  settings.minimum_branch_length =
      choose_parameter(get_parameter(np, internal_np::minimum_branch_length), settings.minimum_branch_length);
  settings.number_of_iterations =
      int(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), settings.number_of_iterations));
  return settings;
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_LOCUS_SETTINGS_H
