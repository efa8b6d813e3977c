// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How small a limb may be to get a branch.

#ifndef CSCD_SEPARATOR_DETAIL_H
#define CSCD_SEPARATOR_DETAIL_H

#include <CSCD/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <string>

namespace CSCD {

/// The detail of a skeleton: a number from 0 to 1 without unit, which sets the length, relative to its radius, that a
/// limb needs to get a branch. At 0 no limb is long enough, at 1 every bump is. Handles do not depend on it.
class Detail
{
public:
  /// Draws blunt limbs, such as muzzles and heads on a short neck.
  static constexpr double default_value = 0.5;

  /// \param value from 0 to 1 \throw Input_error if it is not
  explicit Detail(double value = default_value) : m_value(value)
  {
    if (!(value >= 0 && value <= 1)) {
      throw Input_error("the detail is " + std::to_string(value) + ", and should be from 0 to 1");
    }
  }

  /// The number.
  double value() const { return m_value; }

  /// The length that a limb with a flat end needs, relative to its radius: it falls from infinity at detail 0 to 0
  /// at 1.
  double min_limb_length() const { return default_limb_length * (1 - m_value) / m_value; }

  /// What some separator of a branch has to cut off: an area relative to the squared length of the separator. That of
  /// the limb above, whose side is `2 pi r l` and whose end is `pi r^2`, around which the separator is `2 pi r` long.
  double min_branch_area_ratio() const { return (1 + 2 * min_limb_length()) / (4 * boost::math::double_constants::pi); }

  /// The same of a loop that has not been shortened yet. \see max_loop_area_ratio
  double min_loop_area_ratio() const { return std::min(loop_share * min_branch_area_ratio(), max_loop_area_ratio); }

  /// Between a flat disc, 1 / (4 pi), and a hemisphere, 1 / (2 pi). Loops that cut off less are not taken for bumps at
  /// a detail as low as it may be: many good loops near tips would go.
  static constexpr double max_loop_area_ratio = 0.11;

private:
  /// The area ratio of a branch is 0.10 with it: of 0.06 to 0.15, errors on meshes of animals were least from there
  /// down, and lower ones only added branches.
  static constexpr double default_limb_length = 0.13;
  /// A loop that is not shortened yet is longer than the separator that it becomes: 0.09 was measured with 0.10.
  static constexpr double loop_share = 0.9;

  double m_value;
};

} // namespace CSCD

#endif // CSCD_SEPARATOR_DETAIL_H
