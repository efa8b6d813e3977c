// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a scan of trees to nodes and branches.

#ifndef CSCD_TREE_TREE_SKELETONIZATION_H
#define CSCD_TREE_TREE_SKELETONIZATION_H

#include <CSCD/Surface/Neighbor_table.h>
#include <CSCD/Tree/Gap_bridging.h>
#include <CSCD/Tree/Limb.h>
#include <CSCD/Tree/Limb_finder.h>
#include <CSCD/Tree/Neighbor_graph.h>
#include <CSCD/Tree/Root_search.h>
#include <CSCD/Tree/Section_fitting.h>
#include <CSCD/Tree/Slice_growth.h>
#include <CSCD/Tree/Tree_nodes.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// Makes the skeletons of the objects in a cloud, step by step.
class Tree_skeletonization
{
public:
  /// O(n log n).
  /// \param points different points, at least one
  /// \param root where one of the objects begins; all others begin at their lowest points
  Tree_skeletonization(const std::vector<Vector_3>& points, const std::optional<Vector_3>& root)
      : m_points(points), m_graph(points), m_bridging(points, m_graph), m_distances(points, m_graph)
  {
    m_roots = Root_search(m_points, m_graph, m_bridging)(root);
    measure_distances();
    Slice_growth growth(m_points, m_graph, m_distances);
    for (const std::vector<Index>& roots : m_roots) {
      growth.grow(roots, m_slices);
    }
    Limb_finder finder(m_slices);
    finder();
    m_limbs = finder.limbs();
    const std::vector<Index> host = fit_sections(finder);
    const Tree_nodes tree_nodes(m_points, m_slices, m_sections, m_limbs);
    m_nodes = tree_nodes.nodes();
    m_branches = tree_nodes.branches();
    m_number_of_outcomes = tree_nodes.number_of_outcomes();
    assign_points(tree_nodes, host);
    name_objects();
  }

  const std::vector<Tree_node>& nodes() const { return m_nodes; }
  Index node_of_point(Index point) const { return m_node_of_point[point]; }
  const std::vector<Tree_branch>& branches() const { return m_branches; }
  /// The gaps that were bridged, the shortest first.
  const std::vector<Point_gap>& gaps() const { return m_gaps; }
  Index number_of_objects() const { return m_bridging.number_of_objects(); }
  bool is_debris(Index point) const { return m_bridging.object(point) == no_index; }
  const std::array<std::size_t, number_of_circle_outcomes>& number_of_outcomes() const { return m_number_of_outcomes; }
  /// The median of the spacing of the points.
  double spacing() const
  {
    std::vector<double> spacings;
    for (Index point = 0; point < m_points.size(); ++point) {
      spacings.push_back(m_graph.spacing(point));
    }
    const auto middle = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return *middle;
  }

private:
  /// Measures twice: the first time, to see by which bridge each piece is entered.
  void measure_distances()
  {
    measure_over(m_bridging.bridges());
    if (!m_bridging.bridges().empty()) {
      m_gaps = m_bridging.entries(m_distances);
      measure_over(m_gaps);
    }
  }

  void measure_over(const std::vector<Point_gap>& gaps)
  {
    std::vector<Neighbor_graph::Edge> bridges;
    bridges.reserve(gaps.size());
    for (const Point_gap& gap : gaps) {
      bridges.emplace_back(gap.a, gap.b);
    }
    m_graph.set_bridges(bridges);
    for (const std::vector<Index>& roots : m_roots) {
      m_distances.measure_from(roots);
    }
  }

  /// \return for every slice the one that has its points
  std::vector<Index> fit_sections(const Limb_finder& finder)
  {
    Section_fitting fitting(m_points, m_slices);
    const auto fit = [&] {
      for (const Limb& limb : m_limbs) {
        fitting.fit(limb);
      }
    };
    fit();
    fitting.estimate_noise();
    const std::vector<Index> absorbing = Limb_base_absorption(m_slices, fitting.sections(), m_limbs)();
    fit();
    limit_by_pipe_model(fitting);
    m_sections = fitting.sections();
    std::vector<Index> host;
    for (Index slice = 0; slice < m_slices.size(); ++slice) {
      host.push_back(absorbing[finder.host(slice)]);
    }
    return host;
  }

  /// Where no circle tells the radius, the scatter of the points, leaves among them, is no less than it. By the pipe
  /// model, the area of a section is proportional to the length of all that it carries: so much the parent tells.
  void limit_by_pipe_model(Section_fitting& fitting) const
  {
    std::vector<double> carried(m_slices.size(), 0);
    const auto center = [&](Index slice) -> const Vector_3& { return fitting.sections()[slice].center; };
    for (std::size_t limb = m_limbs.size(); limb-- > 0;) {
      const std::vector<Index>& slices = m_limbs[limb].slices;
      for (std::size_t i = slices.size(); i-- > 0;) {
        const Index before = i > 0 ? slices[i - 1] : m_limbs[limb].joint;
        if (before != no_index) {
          carried[before] += carried[slices[i]] + (center(slices[i]) - center(before)).norm();
        }
      }
    }
    for (const Limb& limb : m_limbs) {
      if (limb.joint != no_index && carried[limb.joint] > 0) {
        fitting.limit_radii(limb, fitting.sections()[limb.joint].radius / std::sqrt(carried[limb.joint]), carried);
      }
    }
  }

  void assign_points(const Tree_nodes& tree_nodes, const std::vector<Index>& host)
  {
    m_node_of_point.assign(m_points.size(), no_index);
    for (Index slice = 0; slice < m_slices.size(); ++slice) {
      for (Index point : m_slices[slice].points) {
        m_node_of_point[point] = tree_nodes.node(host[slice]);
      }
    }
    assign_to_nearest(m_points, m_node_of_point);
  }

  /// Limbs stand in the order of their slices, trunks in that of the objects.
  void name_objects()
  {
    std::size_t number_of_trunks = 0;
    for (Tree_branch& branch : m_branches) {
      branch.object = branch.parent == no_branch ? number_of_trunks++ : m_branches[branch.parent].object;
    }
  }

  const std::vector<Vector_3>& m_points;
  Neighbor_graph m_graph;
  Gap_bridging m_bridging;
  Root_distances m_distances;
  std::vector<std::vector<Index>> m_roots; // of every object
  std::vector<Point_gap> m_gaps;
  std::vector<Slice> m_slices;
  std::vector<Limb> m_limbs;
  std::vector<Section> m_sections; // of every slice
  std::vector<Tree_node> m_nodes;
  std::vector<Tree_branch> m_branches;
  std::array<std::size_t, number_of_circle_outcomes> m_number_of_outcomes{};
  std::vector<Index> m_node_of_point;
};

} // namespace CSCD::internal

#endif // CSCD_TREE_TREE_SKELETONIZATION_H
