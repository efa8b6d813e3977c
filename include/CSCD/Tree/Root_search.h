// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the trunks of objects begin.

#ifndef CSCD_TREE_ROOT_SEARCH_H
#define CSCD_TREE_ROOT_SEARCH_H

#include <CSCD/Tree/Gap_bridging.h>
#include <CSCD/Tree/Neighbor_graph.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// Finds for each object the points from which distances are measured. Shortest paths from a single point would go
/// round a thick trunk; from all around its foot, they go up.
class Root_search
{
public:
  Root_search(const std::vector<Vector_3>& points, const Neighbor_graph& graph, const Gap_bridging& bridging)
      : m_points(points), m_graph(graph), m_bridging(bridging), m_members(bridging.number_of_objects()),
        m_is_taken(points.size(), 0)
  {
    for (Index point = 0; point < points.size(); ++point) {
      if (bridging.object(point) != no_index) {
        m_members[bridging.object(point)].push_back(point);
      }
    }
  }

  /// \param root where one of the objects, the nearest, begins; all others begin at their lowest points
  std::vector<std::vector<Index>> operator()(const std::optional<Vector_3>& root)
  {
    std::vector<std::vector<Index>> result;
    for (const std::vector<Index>& members : m_members) {
      result.push_back(foot(members));
    }
    if (root) {
      Index nearest = no_index;
      for (Index point = 0; point < m_points.size(); ++point) {
        if (m_bridging.object(point) != no_index &&
            (nearest == no_index ||
             (m_points[point] - *root).squaredNorm() < (m_points[nearest] - *root).squaredNorm())) {
          nearest = point;
        }
      }
      result[m_bridging.object(nearest)] = {nearest};
    }
    return result;
  }

private:
  /// How high above the lowest point the foot reaches, relative to the spacing there.
  static constexpr double foot_height = 3;
  /// How far from the lowest point it may reach, relative to the extent of the object: what is wider is no foot, but an
  /// object that lies.
  static constexpr double foot_width = 0.15;

  /// How far from the lowest point other parts of a foot are, relative to how far the part with that point reaches: an
  /// arc of a third of a circle may have its other parts on the opposite side.
  static constexpr double widest_foot = 1.5;

  /// The points that are lowest and connected with the lowest, if they can be the foot of a trunk; else the outermost
  /// of them: an end of what lies.
  std::vector<Index> foot(const std::vector<Index>& members)
  {
    Index lowest = members.front();
    Vector_3 centroid = Vector_3::Zero();
    for (Index point : members) {
      lowest = m_points[point].z() < m_points[lowest].z() ? point : lowest;
      centroid += m_points[point] / double(members.size());
    }
    double extent = 0;
    for (Index point : members) {
      extent = std::max(extent, 2 * (m_points[point] - centroid).norm());
    }
    std::vector<Index> result{lowest};
    m_is_taken[lowest] = 1;
    const double top = m_points[lowest].z() + foot_height * m_graph.spacing(lowest);
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (Index neighbor : m_graph.neighbors(result[i])) {
        if (m_is_taken[neighbor] == 0 && m_points[neighbor].z() <= top) {
          m_is_taken[neighbor] = 1;
          result.push_back(neighbor);
        }
      }
    }
    add_beside(members, lowest, top, result);
    std::sort(result.begin(), result.end());
    const auto is_far = [&](Index point) { return (m_points[point] - m_points[lowest]).norm() > foot_width * extent; };
    if (std::any_of(result.begin(), result.end(), is_far)) {
      return {*std::max_element(result.begin(), result.end(), [&](Index a, Index b) {
        return (m_points[a] - centroid).squaredNorm() < (m_points[b] - centroid).squaredNorm();
      })};
    }
    return result;
  }

  /// Adds points that are as low as a foot and not far from it: other parts of it, of which no more was seen.
  void add_beside(const std::vector<Index>& members, Index lowest, double top, std::vector<Index>& foot)
  {
    double width = 0;
    for (Index point : foot) {
      width = std::max(width, (m_points[point] - m_points[lowest]).norm());
    }
    for (Index point : members) {
      if (m_is_taken[point] == 0 && m_points[point].z() <= top &&
          (m_points[point] - m_points[lowest]).norm() <= widest_foot * width) {
        m_is_taken[point] = 1;
        foot.push_back(point);
      }
    }
  }

  const std::vector<Vector_3>& m_points;
  const Neighbor_graph& m_graph;
  const Gap_bridging& m_bridging;
  std::vector<std::vector<Index>> m_members; // of every object
  std::vector<char> m_is_taken;
};

} // namespace CSCD::internal

#endif // CSCD_TREE_ROOT_SEARCH_H
