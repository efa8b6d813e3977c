// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of a skeleton, node by node.

#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {
namespace {

/// Walks along the branches of a skeleton; see `split_into_branches()`.
class Branch_splitter
{
public:
  using Branch = std::vector<Index>;

  explicit Branch_splitter(const std::vector<std::vector<Index>>& neighbors)
      : m_neighbors(neighbors), m_is_walked(neighbors.size(), 0)
  {
    for (Index v = 0; v < neighbors.size(); ++v) {
      if (!is_inner(v)) {
        walk_all_from(v);
      }
    }
    for (Index v = 0; v < neighbors.size(); ++v) {
      if (is_inner(v) && m_is_walked[v] == 0) {
        walk_cycle(v);
      }
    }
  }

  std::vector<Branch> release() { return std::move(m_branches); }

private:
  bool is_inner(Index v) const { return m_neighbors[v].size() == 2; }

  void walk_all_from(Index end)
  {
    if (m_neighbors[end].empty()) {
      m_branches.push_back({end});
    }
    std::size_t number_of_loop_ends = 0; // an edge from a node to itself is listed twice among its edges
    for (const Index next : m_neighbors[end]) {
      if (is_inner(next)) {
        if (m_is_walked[next] == 0) {
          walk(end, next);
        }
      } else if (end < next || (end == next && number_of_loop_ends++ % 2 == 0)) {
        m_branches.push_back({end, next});
      }
    }
  }

  void walk(Index previous, Index current)
  {
    Branch branch{previous};
    while (is_inner(current) && m_is_walked[current] == 0) {
      m_is_walked[current] = 1;
      branch.push_back(current);
      const Index next = m_neighbors[current][m_neighbors[current][0] == previous ? 1 : 0];
      previous = current;
      current = next;
    }
    branch.push_back(current);
    m_branches.push_back(std::move(branch));
  }

  void walk_cycle(Index first)
  {
    m_is_walked[first] = 1;
    walk(first, m_neighbors[first][0]);
  }

  const std::vector<std::vector<Index>>& m_neighbors;
  std::vector<char> m_is_walked;
  std::vector<Branch> m_branches;
};

} // namespace

std::vector<std::vector<Index>> split_into_branches(const std::vector<std::vector<Index>>& neighbors)
{
  return Branch_splitter(neighbors).release();
}

} // namespace CSCD::internal
