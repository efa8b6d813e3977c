// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Puts more nodes between those of the separators, in the middle of the body.

#ifndef CSCD_SKELETON_BRANCH_REFINEMENT_H
#define CSCD_SKELETON_BRANCH_REFINEMENT_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Skeleton/Section_disc.h>
#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Divides long edges of branches and moves the new nodes to the middle of the section of the body that is
/// perpendicular to the branch there. A node for which there is no trustworthy section is taken out again.
/// \tparam Traits a model of `TriangulatedSolidSkeletonizationTraits`
template <class Traits>
class Branch_refinement
{
public:
  Branch_refinement(const Traits& traits, Skeleton_draft& draft)
      : m_traits(traits), m_draft(draft), m_section(traits.solid_surface())
  {
  }

  void operator()()
  {
    divide_edges();
    for (int sweep = 0; sweep < number_of_sweeps; ++sweep) {
      for (Index node : m_inserted) {
        if (m_draft.is_regular(node) && !center(node)) {
          m_draft.bypass(node);
        }
      }
    }
  }

private:
  /// Edges are divided into parts of about this length, relative to the mean radius at their ends.
  static constexpr double part_length = 0.5;
  static constexpr int most_parts = 30;
  static constexpr int number_of_sweeps = 2;
  /// Bounds for the radius of an accepted section, relative to the radius interpolated between the separators.
  static constexpr double least_radius = 0.6;
  static constexpr double most_radius = 1.5;
  /// The length of a section is bounded by this, relative to the circle of the expected radius.
  static constexpr double most_outline = 4;
  /// A node moves at most this far, relative to the expected radius.
  static constexpr double most_shift = 1;
  /// The two edges of a node may be this much longer than the straight line between its neighbors.
  static constexpr double most_detour = 1.4;

  void divide_edges()
  {
    std::vector<std::pair<Index, Index>> edges;
    m_draft.for_each_edge([&](Index a, Index b) {
      if (a != b && !m_draft.is_junction(a) && !m_draft.is_junction(b)) {
        edges.emplace_back(a, b);
      }
    });
    for (const auto& [a, b] : edges) {
      divide(a, b);
    }
  }

  void divide(Index a, Index b)
  {
    const Skeleton_draft::Node from = m_draft[a];
    const Skeleton_draft::Node to = m_draft[b];
    const double mean_radius = (from.radius + to.radius) / 2;
    if (!(mean_radius > 0)) {
      return;
    }
    const double length = (to.position - from.position).norm();
    const int parts = int(std::min(length / (part_length * mean_radius), double(most_parts))) + 1;
    Index last = a;
    for (int i = 1; i < parts; ++i) {
      const double along = double(i) / parts;
      last = m_draft.split_edge(last, b, (1 - along) * from.position + along * to.position,
                                (1 - along) * from.radius + along * to.radius);
      m_inserted.push_back(last);
    }
  }

  /// Moves `node` to the center of its section. \return false if there is no section to trust
  bool center(Index node)
  {
    Skeleton_draft::Node& center_node = m_draft[node];
    const Vector_3& before = m_draft[center_node.neighbors[0]].position;
    const Vector_3& after = m_draft[center_node.neighbors[1]].position;
    const double expected = center_node.radius;
    const Vector_3 axis = (after - before).normalized();
    if (!cut(center_node.position, axis, most_outline * 2 * boost::math::double_constants::pi * expected)) {
      return false;
    }
    const Section_disc disc = section_disc(m_section.points());
    const double detour = (disc.center - before).norm() + (after - disc.center).norm();
    if (disc.radius() < least_radius * expected || disc.radius() > most_radius * expected ||
        (disc.center - center_node.position).norm() > most_shift * expected ||
        detour >= most_detour * (after - before).norm()) {
      return false;
    }
    center_node.position = disc.center;
    return true;
  }

  /// Takes the section of the body around `point` perpendicular to `axis`.
  bool cut(const Vector_3& point, const Vector_3& axis, double max_length)
  {
    const auto hit = m_traits.first_hit(point, axis.unitOrthogonal());
    return hit && m_section.cut_at_face(hit->face, axis, point, max_length) &&
           is_in_outline(m_section.points(), point, axis);
  }

  const Traits& m_traits;
  Skeleton_draft& m_draft;
  Plane_section m_section;
  std::vector<Index> m_inserted;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BRANCH_REFINEMENT_H
