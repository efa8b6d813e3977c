// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From many separators to few: packs disjoint ones and prunes branches that are mere bumps.

#ifndef CSCD_SELECTION_SEPARATOR_PACKING_H
#define CSCD_SELECTION_SEPARATOR_PACKING_H

#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Selection/Separator_arrangement.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// Greedy weighted set packing of separators (section 3.2.3), followed by pruning: the separators of a branch that no
/// limb stands on are banned, and what remains is packed again.
class Separator_packing
{
public:
  /// Packs `separators`, whose weights are `weights`: the lighter one of two that overlap is kept.
  Separator_packing(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                    const std::vector<double>& weights)
      : m_surface(surface), m_separators(separators), m_arrangement(surface), m_is_banned(separators.size(), 0)
  {
    m_cut_graph.emplace(surface, separators);
    sort_by_weight(weights);
    for (int round = 0; round < most_rounds; ++round) {
      pack();
      m_cut_graph->cut(m_arrangement);
      if (round + 1 == most_rounds || !ban_bumps()) {
        break;
      }
    }
  }

  /// The packed separators, as positions in the list of all separators, by increasing weight.
  const std::vector<Index>& packed() const { return m_packed; }
  /// The surface cut along them.
  const Cut_graph& cut_graph() const { return *m_cut_graph; }
  const Separator_arrangement& arrangement() const { return m_arrangement; }

  /// Packs the last separator of the list, which was appended after the others had been packed, if it crosses none of
  /// them and itself neither. The cut graph stays as it is until `cut_again()`. \return whether it was packed
  bool insert_last()
  {
    const auto separator = Index(m_separators.size() - 1);
    if (!m_arrangement.insert(separator, m_separators[separator].crossings)) {
      return false;
    }
    m_packed.push_back(separator);
    return true;
  }

  /// Cuts the surface along all packed separators, those inserted last included.
  void cut_again()
  {
    m_cut_graph.emplace(m_surface, m_separators);
    m_cut_graph->cut(m_arrangement);
  }

private:
  /// Packing and pruning are repeated until nothing is pruned, but at most this often.
  static constexpr int most_rounds = 3;
  /// The centers of packed separators keep this distance, relative to the radius of the shorter one.
  static constexpr double least_spacing = 0.3;
  /// A branch stands on a limb if one of its separators cuts off at least this area, relative to its squared length:
  /// that of a limb 0.76 radii long with a flat end.
  static constexpr double least_branch_area_ratio = 0.28;

  void sort_by_weight(const std::vector<double>& weights)
  {
    m_order.resize(m_separators.size());
    std::iota(m_order.begin(), m_order.end(), Index(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](Index a, Index b) { return weights[a] < weights[b]; });
  }

  void pack()
  {
    m_packed.clear();
    m_arrangement.clear();
    for (Index separator : m_order) {
      if (m_is_banned[separator] == 0 && is_spaced(separator) &&
          m_arrangement.insert(separator, m_separators[separator].crossings)) {
        m_packed.push_back(separator);
      }
    }
  }

  bool is_spaced(Index candidate) const
  {
    const Separator& a = m_separators[candidate];
    return std::none_of(m_packed.begin(), m_packed.end(), [&](Index packed) {
      const Separator& b = m_separators[packed];
      const double distance = least_spacing * std::min(a.radius(), b.radius());
      return (a.center - b.center).squaredNorm() < distance * distance;
    });
  }

  /// Bans the separators of the branches that end in a tip and stand on no limb. \return whether there was one
  bool ban_bumps()
  {
    bool has_banned = false;
    for (Index piece = 0; piece < m_cut_graph->pieces().size(); ++piece) {
      if (m_cut_graph->pieces()[piece].separators.size() == 1 && walk_branch(piece) && !is_limb()) {
        for (const Step& step : m_branch) {
          m_is_banned[m_packed[step.separator]] = 1;
        }
        has_banned = true;
      }
    }
    return has_banned;
  }

  /// Walks the branch that starts at the tip `piece`. \return whether it ends in a junction
  bool walk_branch(Index piece)
  {
    m_branch.clear();
    double area = 0;
    Index separator = m_cut_graph->pieces()[piece].separators.front();
    while (true) {
      area += m_cut_graph->pieces()[piece].area;
      m_branch.push_back({separator, area});
      piece = m_cut_graph->sides(separator).other(piece);
      const std::vector<Index>& around = m_cut_graph->pieces()[piece].separators;
      if (around.size() != 2) {
        return around.size() > 2;
      }
      separator = around[0] == separator ? around[1] : around[0];
    }
  }

  bool is_limb() const
  {
    return std::any_of(m_branch.begin(), m_branch.end(), [this](const Step& step) {
      const double length = m_separators[m_packed[step.separator]].length;
      return step.area_beyond >= least_branch_area_ratio * length * length;
    });
  }

  /// A packed separator of a branch and the area between it and the tip.
  struct Step
  {
    Index separator;
    double area_beyond;
  };

  const Triangulated_surface& m_surface;
  const std::vector<Separator>& m_separators;
  Separator_arrangement m_arrangement;
  std::optional<Cut_graph> m_cut_graph;
  std::vector<Index> m_order;
  std::vector<Index> m_packed;
  std::vector<std::uint8_t> m_is_banned;
  std::vector<Step> m_branch;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_PACKING_H
