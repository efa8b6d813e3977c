// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user may set about the extraction of a cut locus.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_SETTINGS_H
#define CSCD_PUBLISHED_CUT_LOCUS_SETTINGS_H

#include <CSCD/Named_parameters.h>

#include <boost/math/constants/constants.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <variant>

namespace CSCD {

/// Keeps every cut point and its path to the root of the tree: what remains when leaves that are no cut points are
/// removed until there are none left. No cut point is missed, but false ones far away keep their paths too.
/// `Growing_policy` is the other choice.
struct Pruning_policy
{
  /// Adds to `cut` the vertices for which `is_cut(vertex)` holds, and their paths to the root; linear.
  template <class Predicate, class CutTree>
  void operator()(const Predicate& is_cut, CutTree& cut) const
  {
    for (const auto vertex : cut.tree().order()) {
      if (is_cut(vertex)) {
        cut.keep(vertex);
      }
    }
  }
};

/// Keeps what can be reached from the root of the tree through cut points. Noise elsewhere does no harm, but one vertex
/// that is missed cuts off all that lies behind it. `Pruning_policy` is the other choice.
struct Growing_policy
{
  /// Adds to `cut` the vertices for which `is_cut(vertex)` holds; linear in the number of calls.
  template <class Predicate, class CutTree>
  void operator()(const Predicate& is_cut, CutTree& cut) const
  {
    const auto& graph = cut.tree().graph();
    auto reached = cut.tree().roots();
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const auto edge : boost::make_iterator_range(out_edges(reached[i], graph))) {
        if (is_cut(target(edge, graph))) {
          cut.keep(target(edge, graph));
          reached.push_back(target(edge, graph));
        }
      }
    }
  }
};

} // namespace CSCD

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

/// When a vertex of a cloud counts as a point of the cut locus. The criterion is weaker than on a mesh, since means
/// over neighbors round a ridge off. Chosen on samples of a sphere, a capsule, a torus, an ellipsoid and a flat tube,
/// random or even, with noise or without: of what passes, 99.8 % lies within two edges of the true cut locus (of
/// single gradients 97.9 %, and 70 % on the worst cloud), and the cut locus where fronts meet at 60 degrees is near
/// such a vertex everywhere. At a threshold of 60 degrees it is not (doc/cut_locus.md).
constexpr Cut_criterion point_cut_criterion()
{
  return {-0.35, boost::math::double_constants::pi / 4};
}

/// How a cut locus is found; scale-free.
struct Cut_locus_settings
{
  Cut_criterion criterion;
  std::variant<Pruning_policy, Growing_policy> policy;
  /// Relative to the distance of the farthest point. Found by eye on a dozen meshes: with less, short branches of noise
  /// remain; with more, those of thin limbs such as fingers are lost.
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
  settings.policy = choose_parameter(get_parameter(np, internal_np::cut_locus_policy), Pruning_policy());
  settings.minimum_branch_length =
      choose_parameter(get_parameter(np, internal_np::minimum_branch_length), settings.minimum_branch_length);
  settings.number_of_iterations =
      int(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), settings.number_of_iterations));
  return settings;
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_SETTINGS_H
