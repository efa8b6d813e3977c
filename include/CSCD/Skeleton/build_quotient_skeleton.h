// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the regions of packed separators to a skeleton.

#ifndef CSCD_SKELETON_BUILD_QUOTIENT_SKELETON_H
#define CSCD_SKELETON_BUILD_QUOTIENT_SKELETON_H

#include <CSCD/Selection/Separator_regions.h>
#include <CSCD/Skeleton/Embedded_skeleton.h>
#include <CSCD/Skeleton/Inside_repair.h>
#include <CSCD/Skeleton/Quotient_graph.h>
#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/Skeleton/make_simple.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Builds the skeleton whose nodes are the regions of the packed separators: at their centroids by area (Alg. 2, lines
/// 13 and 14), joined where regions touch.
/// \tparam Traits a model of `SolidSkeletonizationTraits`
template <class Traits>
class Quotient_skeleton_builder
{
public:
  Quotient_skeleton_builder(const Traits& traits, const Separator_regions& regions)
      : m_traits(traits), m_regions(regions)
  {
  }

  Embedded_skeleton operator()(Skeletonization_report& report)
  {
    Embedded_skeleton result;
    Skeleton_draft& draft = result.draft;
    place_regions(draft);
    const Quotient_graph graph(m_traits.surface(), [this](Index vertex) { return m_regions[vertex]; });
    for (const std::vector<Index>& meeting : graph.meetings()) {
      connect(draft, meeting);
    }
    make_simple(draft);
    Inside_repair<Traits> repair(m_traits, draft);
    repair();
    draft.compact();
    report.number_of_nodes_outside = repair.number_of_nodes_outside();
    report.number_of_edges_outside = repair.number_of_edges_outside();
    assign_sites(result);
    return result;
  }

private:
  /// The node of region i is node i of the draft.
  void place_regions(Skeleton_draft& draft)
  {
    std::vector<Vector_3> sum(m_regions.size(), Vector_3::Zero());
    std::vector<Vector_3> plain_sum(m_regions.size(), Vector_3::Zero());
    std::vector<double> area(m_regions.size(), 0);
    std::vector<std::size_t> count(m_regions.size(), 0);
    for (Index site = 0; site < m_traits.number_of_sites(); ++site) {
      const Index region = m_regions[site];
      sum[region] += m_traits.weight(site) * m_traits.point(site);
      area[region] += m_traits.weight(site);
      plain_sum[region] += m_traits.point(site);
      ++count[region];
    }
    for (Index region = 0; region < m_regions.size(); ++region) {
      // A region may have no area, where a border was bridged.
      const Vector_3 center =
          area[region] > 0 ? Vector_3(sum[region] / area[region]) : Vector_3(plain_sum[region] / double(count[region]));
      draft[draft.add_node(center, 0)].separators = {region};
    }
    m_area = std::move(area);
    const std::vector<double> radius = radii([](Index region) { return region; }, draft);
    for (Index region = 0; region < m_regions.size(); ++region) {
      draft[region].radius = radius[region];
    }
  }

  void connect(Skeleton_draft& draft, const std::vector<Index>& meeting)
  {
    if (meeting.size() == 2) {
      draft.add_edge(meeting[0], meeting[1]);
      return;
    }
    Vector_3 sum = Vector_3::Zero();
    double radius = 0;
    double area = 0;
    for (Index region : meeting) {
      sum += m_area[region] * draft[region].position;
      radius += m_area[region] * draft[region].radius;
      area += m_area[region];
    }
    const Index junction =
        area > 0 ? draft.add_node(sum / area, radius / area) : draft.add_node(draft[meeting.front()].position, 0);
    for (Index region : meeting) {
      draft.add_edge(junction, region);
    }
  }

  void assign_sites(Embedded_skeleton& skeleton) const
  {
    const Skeleton_draft& draft = skeleton.draft;
    std::vector<Index> node_of_region(m_regions.size());
    for (Index node = 0; node < draft.size(); ++node) {
      for (Index region : draft[node].separators) {
        node_of_region[region] = node;
      }
    }
    skeleton.node_of_site.resize(m_traits.number_of_sites());
    for (Index site = 0; site < m_traits.number_of_sites(); ++site) {
      skeleton.node_of_site[site] = node_of_region[m_regions[site]];
    }
    skeleton.radius = radii([&](Index region) { return node_of_region[region]; }, draft);
  }

  /// For each node, the median by area of the distances of its sites; what the draft has where a node has no sites.
  template <class NodeOfRegion>
  std::vector<double> radii(const NodeOfRegion& node_of_region, const Skeleton_draft& draft) const
  {
    std::vector<std::vector<std::pair<double, double>>> distances(draft.size());
    for (Index site = 0; site < m_traits.number_of_sites(); ++site) {
      const Index node = node_of_region(m_regions[site]);
      distances[node].emplace_back((m_traits.point(site) - draft[node].position).norm(), m_traits.weight(site));
    }
    std::vector<double> result(draft.size());
    for (Index node = 0; node < draft.size(); ++node) {
      result[node] = distances[node].empty() ? draft[node].radius : weighted_median(distances[node]);
    }
    return result;
  }

  /// The median of values with their weights; sorts them. \pre there is one
  static double weighted_median(std::vector<std::pair<double, double>>& values)
  {
    std::sort(values.begin(), values.end());
    double half = 0;
    for (const auto& value : values) {
      half += value.second / 2;
    }
    for (const auto& [value, weight] : values) {
      half -= weight;
      if (half <= 0) {
        return value;
      }
    }
    return values.back().first;
  }

  const Traits& m_traits;
  const Separator_regions& m_regions;
  std::vector<double> m_area;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BUILD_QUOTIENT_SKELETON_H
