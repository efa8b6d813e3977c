// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How well a separator cuts a limb, as the published method weighs it.

#ifndef CSCD_SELECTION_BALANCE_AND_ROUNDNESS_H
#define CSCD_SELECTION_BALANCE_AND_ROUNDNESS_H

#include <CSCD/Selection/Separator_sides.h>
#include <CSCD/Selection/span_inside_share.h>
#include <CSCD/Separator/Bump_test.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/curve_measures.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Weighs separators by the balance of the surface on their two sides and by their roundness (section 3.2.1), and
/// prunes those that cut no limb (section 3.2.2). One object serves one thread.
///
/// The published text says that local separators are weighed as Baerentzen and Rotenberg do, by the ratio of the sizes
/// of their two fronts: 1 on a tube, less at its ends and where a limb branches off. The areas of two bands are that
/// for a curve. Roundness is the square root of the isoperimetric quotient.
/// \tparam Traits a model of `SolidSkeletonizationTraits`
template <class Traits>
class Balance_and_roundness
{
public:
  enum class Verdict
  {
    good,
    bump,  ///< one side is as small as that of a curve around a bump
    tunnel ///< the curve does not span the body
  };

  explicit Balance_and_roundness(const Traits& traits) : m_traits(traits), m_sides(traits.surface()) {}

  /// Judges `separator` and sets `weight`, in (0, 1] for a good one and 0 for others.
  Verdict operator()(const Separator& separator, double& weight)
  {
    weight = 0;
    const double squared_length = separator.length * separator.length;
    const double width = band_width * separator.length;
    const double least_area = Bump_test::least_area_ratio * squared_length;
    const typename Sides::Side left = m_sides.measure(separator, true, width, least_area);
    const typename Sides::Side right = m_sides.measure(separator, false, width, least_area);
    if (std::min(left.area, right.area) < least_area) {
      return Verdict::bump;
    }
    curve_points(m_traits.surface(), separator, m_points);
    if (span_inside_share(m_traits, m_points, separator.center) < least_inside_share) {
      return Verdict::tunnel;
    }
    const double balance = std::min(left.band_area, right.band_area) / std::max(left.band_area, right.band_area);
    const double isoperimetric_quotient =
        std::min(1., 4 * boost::math::double_constants::pi * separator.area / squared_length);
    weight = balance * std::sqrt(isoperimetric_quotient);
    return Verdict::good;
  }

private:
  using Sides = Separator_sides<std::decay_t<decltype(std::declval<const Traits&>().surface())>>;

  /// Width of the bands, relative to the length of the separator.
  static constexpr double band_width = 1. / 8;
  /// Least share of the spanned surface that lies inside: bent limbs have 0.8 and more, tunnels about 0.
  static constexpr double least_inside_share = 0.7;

  const Traits& m_traits;
  Sides m_sides;
  std::vector<Vector_3> m_points;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_BALANCE_AND_ROUNDNESS_H
