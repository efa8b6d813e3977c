// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts off what leads aside at the end of a limb.

#ifndef CSCD_SKELETON_RIM_TRIMMING_H
#define CSCD_SKELETON_RIM_TRIMMING_H

#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// Cuts off short ends of branches that turn aside where the body lies all around the branch: in a rim, they lead to no
/// point more than to others.
class Rim_trimming
{
public:
  /// Both are referred to.
  Rim_trimming(const Triangulated_solid& solid, Skeleton_builder& builder) : m_solid(solid), m_builder(builder) {}

  void operator()()
  {
    for (Index tip = 0; tip < m_builder.size(); ++tip) {
      const Skeleton_builder::Node& node = m_builder[tip];
      if (!node.is_removed && node.neighbors.size() == 1 && !node.is_opening && !node.is_on_sheet) {
        trim(tip);
      }
    }
  }

private:
  /// The greatest length of what is cut off, relative to the radius where it starts ...
  static constexpr double max_length = 1.5;
  /// ... and the greatest cosine of the turn there.
  static constexpr double max_cosine = 0.5;

  void trim(Index tip)
  {
    Index outer_neighbor = tip;
    Index base = m_builder[tip].neighbors[0];
    while (m_builder.is_regular(base) && m_builder.edge_length(tip, base) < max_length * m_builder[base].radius) {
      if (leads_into_rim(tip, base, m_builder.other_neighbor(base, outer_neighbor))) {
        contract_until(tip, base);
        return;
      }
      outer_neighbor = std::exchange(base, m_builder.other_neighbor(base, outer_neighbor));
    }
  }

  void contract_until(Index tip, Index base)
  {
    while (tip != base) {
      const Index next = m_builder[tip].neighbors[0];
      m_builder.contract(tip, next);
      tip = next;
    }
  }

  /// Whether the way from `base` to `tip` turns aside from the branch that comes from `inner_neighbor`, in a body that
  /// lies around that as far out.
  bool leads_into_rim(Index tip, Index base, Index inner_neighbor) const
  {
    const Vector_3& position = m_builder[base].position;
    Index last = base;
    Index node = inner_neighbor;
    while (m_builder.is_regular(node) && m_builder.edge_length(node, base) < m_builder[base].radius) {
      last = std::exchange(node, m_builder.other_neighbor(node, last));
    }
    const Vector_3 axis = (position - m_builder[node].position).normalized();
    const Vector_3 way = m_builder[tip].position - position;
    const double along = way.dot(axis);
    if (along > max_cosine * way.norm()) {
      return false;
    }
    const Vector_3 aside = way - along * axis;
    const Vector_3 across = axis.cross(aside);
    const Vector_3 center = position + along * axis;
    return m_solid.is_inside(center - aside) && m_solid.is_inside(center + across) &&
           m_solid.is_inside(center - across);
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_RIM_TRIMMING_H
