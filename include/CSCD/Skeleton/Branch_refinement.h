// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the edges of branches, centers the new nodes and smooths the branches.

#ifndef CSCD_SKELETON_BRANCH_REFINEMENT_H
#define CSCD_SKELETON_BRANCH_REFINEMENT_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Divides long edges of branches and moves the new nodes to the middle of the section of the body that is
/// perpendicular to the branch there. A node without a reliable section is removed again.
class Branch_refinement
{
public:
  Branch_refinement(const Triangulated_solid& solid, Skeleton_builder& builder)
      : m_solid(solid), m_builder(builder), m_section(solid.query_surface())
  {
  }

  void operator()()
  {
    divide_edges();
    for (int sweep = 0; sweep < number_of_sweeps; ++sweep) {
      for (Index node : m_inserted) {
        if (m_builder.is_regular(node) && !center(node)) {
          m_builder.bypass(node);
        }
      }
    }
  }

private:
  /// Edges are divided into parts of about this length, relative to the mean radius at their ends.
  static constexpr double part_length = 0.5;
  static constexpr int max_parts = 30;
  static constexpr int number_of_sweeps = 2;
  /// Bounds for the radius of an accepted section, relative to the radius interpolated between the separators.
  static constexpr double min_radius = 0.6;
  static constexpr double max_radius = 1.5;
  /// The length of a section is bounded by this, relative to the circle of the expected radius.
  static constexpr double max_outline = 4;
  /// A node moves at most this far, relative to the expected radius.
  static constexpr double max_shift = 1;
  /// The two edges of a node may be this much longer than the straight line between its neighbors.
  static constexpr double max_detour = 1.4;

  void divide_edges()
  {
    std::vector<std::pair<Index, Index>> edges;
    m_builder.for_each_edge([&](Index a, Index b) {
      if (a != b && !m_builder.is_junction(a) && !m_builder.is_junction(b)) {
        edges.emplace_back(a, b);
      }
    });
    for (const auto& [a, b] : edges) {
      divide(a, b);
    }
  }

  void divide(Index a, Index b)
  {
    const Skeleton_builder::Node from = m_builder[a];
    const Skeleton_builder::Node to = m_builder[b];
    const double mean_radius = (from.radius + to.radius) / 2;
    if (!(mean_radius > 0)) {
      return;
    }
    const double length = (to.position - from.position).norm();
    const int parts = int(std::min(length / (part_length * mean_radius), double(max_parts))) + 1;
    Index last = a;
    for (int i = 1; i < parts; ++i) {
      const double along = double(i) / parts;
      last = m_builder.split_edge(last, b, (1 - along) * from.position + along * to.position,
                                  (1 - along) * from.radius + along * to.radius);
      m_inserted.push_back(last);
    }
  }

  /// Moves `node` to the center of its section. \return false if there is no section to trust
  bool center(Index node)
  {
    Skeleton_builder::Node& center_node = m_builder[node];
    const Vector_3& before = m_builder[center_node.neighbors[0]].position;
    const Vector_3& after = m_builder[center_node.neighbors[1]].position;
    const double expected = center_node.radius;
    const Vector_3 axis = (after - before).normalized();
    if (!cut(center_node.position, axis, max_outline * 2 * boost::math::double_constants::pi * expected)) {
      return false;
    }
    const Section_disc disc = section_disc(m_section.points());
    const double detour = (disc.center - before).norm() + (after - disc.center).norm();
    if (disc.radius() < min_radius * expected || disc.radius() > max_radius * expected ||
        (disc.center - center_node.position).norm() > max_shift * expected ||
        detour >= max_detour * (after - before).norm()) {
      return false;
    }
    center_node.position = disc.center;
    return true;
  }

  /// Takes the section of the body around `point` perpendicular to `axis`.
  bool cut(const Vector_3& point, const Vector_3& axis, double max_length)
  {
    const auto hit = m_solid.first_hit(point, axis.unitOrthogonal());
    return hit && m_section.cut_at_face(hit->face, axis, point, max_length) &&
           is_in_outline(m_section.points(), point, axis);
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
  Plane_section m_section;
  std::vector<Index> m_inserted;
};

/// Moves every node of degree 2 halfway to the middle of its neighbors, all at once. More such steps decenter bends.
inline void smooth_branches(Skeleton_builder& builder)
{
  std::vector<Vector_3> smoothed(builder.size());
  for (Index node = 0; node < builder.size(); ++node) {
    smoothed[node] = builder[node].position;
    if (builder.is_regular(node)) {
      const std::vector<Index>& neighbors = builder[node].neighbors;
      smoothed[node] = smoothed[node] / 2 + (builder[neighbors[0]].position + builder[neighbors[1]].position) / 4;
    }
  }
  for (Index node = 0; node < builder.size(); ++node) {
    builder[node].position = smoothed[node];
  }
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BRANCH_REFINEMENT_H
