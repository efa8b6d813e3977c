// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distinguishes the branches of a cut graph on a limb from those on a bump.

#ifndef CSCD_PACKING_SPURIOUS_BRANCHES_H
#define CSCD_PACKING_SPURIOUS_BRANCHES_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Enclosed_area_test.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <vector>

namespace CSCD::internal {

/// Finds the branches of a cut graph that lead from a junction to a tip and stand on no limb, and the ends of branches
/// that lead into a corner of a sheet.
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
      if (cut_graph.pieces()[piece].separators.size() == 1) {
        const bool is_bump = walk_branch(piece) && !is_limb();
        for (auto step = m_branch.begin(); step != m_branch.end() && (is_bump || is_corner(*step)); ++step) {
          m_bumps.push_back(m_packed[step->separator]);
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
    return std::any_of(m_branch.begin(), m_branch.end(), [this](const Step& step) { return cuts_off_enough(step); });
  }

  /// Whether the separator is open and cuts off no more than a corner of its sheet: even at the end of a limb, it turns
  /// the branch aside.
  bool is_corner(const Step& step) const { return separator(step).is_open && !cuts_off_enough(step); }

  bool cuts_off_enough(const Step& step) const
  {
    const double length = separator(step).length;
    return step.area_beyond >= (separator(step).is_open ? open_area_factor : 1) * m_min_area_ratio * length * length;
  }

  const Separator& separator(const Step& step) const { return m_separators[m_packed[step.separator]]; }

  const Cut_graph& m_cut_graph;
  const std::vector<Separator>& m_separators;
  const std::vector<Index>& m_packed;
  double m_min_area_ratio;
  std::vector<Step> m_branch;
  std::vector<Index> m_bumps;
};

} // namespace CSCD::internal

#endif // CSCD_PACKING_SPURIOUS_BRANCHES_H
