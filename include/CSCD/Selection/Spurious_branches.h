// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distinguishes the branches of a cut graph on a limb from those on a bump.

#ifndef CSCD_SELECTION_SPURIOUS_BRANCHES_H
#define CSCD_SELECTION_SPURIOUS_BRANCHES_H

#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <vector>

namespace CSCD::internal {

/// Finds the branches of a cut graph that lead from a junction to a tip and stand on no limb.
class Spurious_branches
{
public:
  /// Seeks them in `cut_graph`, the surface cut along the separators `packed` of the list `separators`; linear.
  /// \param min_area_ratio a branch stands on a limb if one of its separators cuts off at least this area, relative to
  ///        its squared length
  Spurious_branches(const Cut_graph& cut_graph, const std::vector<Separator>& separators,
                    const std::vector<Index>& packed, double min_area_ratio)
      : m_cut_graph(cut_graph), m_separators(separators), m_packed(packed), m_min_area_ratio(min_area_ratio)
  {
    for (Index piece = 0; piece < cut_graph.pieces().size(); ++piece) {
      if (cut_graph.pieces()[piece].separators.size() == 1 && walk_branch(piece) && !is_limb()) {
        for (const Step& step : m_branch) {
          m_bumps.push_back(m_packed[step.separator]);
        }
      }
    }
  }

  /// The separators of the bumps, as positions in the list of all separators.
  const std::vector<Index>& separators() const { return m_bumps; }

private:
  /// A packed separator of a branch and the area between it and the tip.
  struct Step
  {
    Index separator;
    double area_beyond;
  };

  /// Walks the branch that starts at the tip `piece`. \return whether it ends in a junction
  bool walk_branch(Index piece)
  {
    m_branch.clear();
    double area = 0;
    Index separator = m_cut_graph.pieces()[piece].separators.front();
    while (true) {
      area += m_cut_graph.pieces()[piece].area;
      m_branch.push_back({separator, area});
      piece = m_cut_graph.sides(separator).other(piece);
      const std::vector<Index>& around = m_cut_graph.pieces()[piece].separators;
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
      return step.area_beyond >= m_min_area_ratio * length * length;
    });
  }

  const Cut_graph& m_cut_graph;
  const std::vector<Separator>& m_separators;
  const std::vector<Index>& m_packed;
  double m_min_area_ratio;
  std::vector<Step> m_branch;
  std::vector<Index> m_bumps;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SPURIOUS_BRANCHES_H
