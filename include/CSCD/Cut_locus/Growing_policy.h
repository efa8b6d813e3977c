// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus as what is connected to the farthest vertex.

#ifndef CSCD_CUT_LOCUS_GROWING_POLICY_H
#define CSCD_CUT_LOCUS_GROWING_POLICY_H

#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <vector>

namespace CSCD {

/// Keeps what can be reached from the root of the tree through cut points. Noise elsewhere does no harm, but one vertex
/// that is missed cuts off all that lies behind it. `Pruning_policy` is the other choice.
struct Growing_policy
{
  /// Adds to `cut` the vertices for which `is_cut(vertex)` holds; linear in the number of calls.
  template <class Predicate>
  void operator()(const Predicate& is_cut, internal::Cut_tree& cut) const
  {
    const internal::Org_tree::Graph& graph = cut.tree().graph();
    std::vector<internal::Index> reached = cut.tree().roots();
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const auto edge : boost::make_iterator_range(out_edges(reached[i], graph))) {
        if (is_cut(target(edge, graph))) {
          cut.keep(target(edge, graph));
          reached.push_back(target(edge, graph));
        }
      }
    }
  }
};

} // namespace CSCD

#endif // CSCD_CUT_LOCUS_GROWING_POLICY_H
