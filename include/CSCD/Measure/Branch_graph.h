// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the branches of a skeleton are joined.

#ifndef CSCD_MEASURE_BRANCH_GRAPH_H
#define CSCD_MEASURE_BRANCH_GRAPH_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton/split_into_branches.h>
#include <CSCD/Vector_3.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The graph of which the vertices are the nodes of a skeleton that do not have two edges, and the edges the branches
/// between them. Closed cycles without such a node are set apart.
struct Branch_graph
{
  /// Linear.
  explicit Branch_graph(const Indexed_skeleton& skeleton)
  {
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(skeleton.number_of_nodes());
    for (const auto& [u, v] : skeleton.edges) {
      add_edge(u, v, graph);
    }
    std::vector<Index> number(skeleton.number_of_nodes(), no_index);
    for (Index v = 0; v < number.size(); ++v) {
      if (out_degree(v, graph) != 2) {
        number[v] = Index(nodes.size());
        nodes.push_back(v);
        degrees.push_back(out_degree(v, graph));
      }
    }
    for (const auto& path : split_into_branches(graph)) {
      if (path.size() == 1) {
        continue; // an isolated node
      }
      branches.emplace_back(path.begin(), path.end());
      const Index source = number[path.front()];
      const Index target = number[path.back()];
      if (source == no_index) {
        ++number_of_closed_cycles;
      } else {
        edges.push_back({source, target});
      }
    }
  }

  std::vector<Index> nodes;                 ///< of the skeleton: isolated ones, tips and junctions
  std::vector<std::size_t> degrees;         ///< of `nodes`
  std::vector<std::array<Index, 2>> edges;  ///< between `nodes`, as positions there
  std::vector<std::vector<Index>> branches; ///< the nodes of the skeleton along each branch, closed cycles included
  std::size_t number_of_closed_cycles = 0;
};

/// Labels the vertices of several branch graphs by their surroundings, farther with every refinement: the color
/// refinement of B. Weisfeiler and A. Leman.
class Branch_labels
{
public:
  explicit Branch_labels(const Branch_graph& graph) : m_neighbors(graph.nodes.size())
  {
    for (const auto& [u, v] : graph.edges) {
      m_neighbors[u].push_back(v);
      m_neighbors[v].push_back(u);
    }
    m_labels.assign(graph.degrees.begin(), graph.degrees.end());
  }

  /// What a label stands for, and the label; shared by the graphs that are compared.
  using Dictionary = std::map<std::vector<std::size_t>, std::size_t>;

  /// Replaces the label of each vertex by one for its label and those of its neighbours.
  void refine(Dictionary& dictionary)
  {
    std::vector<std::size_t> refined;
    refined.reserve(m_labels.size());
    for (std::size_t v = 0; v < m_labels.size(); ++v) {
      std::vector<std::size_t> surroundings;
      for (const Index w : m_neighbors[v]) {
        surroundings.push_back(m_labels[w]);
      }
      std::sort(surroundings.begin(), surroundings.end());
      surroundings.push_back(m_labels[v]);
      refined.push_back(dictionary.try_emplace(std::move(surroundings), dictionary.size()).first->second);
    }
    m_labels = std::move(refined);
  }

  std::vector<std::size_t> sorted() const
  {
    std::vector<std::size_t> result = m_labels;
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  std::vector<std::vector<Index>> m_neighbors;
  std::vector<std::size_t> m_labels;
};

/// Whether the branches of two skeletons are joined in the same way, by color refinement: that decides it for forests,
/// and for graphs with cycles unless they are of a regularity that skeletons do not have. O(r n log n) for n nodes that
/// do not have two edges and r refinements, no more than the farthest of them are branches apart.
inline bool have_same_structure(const Branch_graph& a, const Branch_graph& b)
{
  if (a.nodes.size() != b.nodes.size() || a.edges.size() != b.edges.size() ||
      a.number_of_closed_cycles != b.number_of_closed_cycles) {
    return false;
  }
  Branch_labels labels_of_a(a);
  Branch_labels labels_of_b(b);
  std::size_t number_of_labels = 0;
  while (true) {
    if (labels_of_a.sorted() != labels_of_b.sorted()) {
      return false;
    }
    Branch_labels::Dictionary dictionary;
    labels_of_a.refine(dictionary);
    labels_of_b.refine(dictionary);
    if (dictionary.size() == number_of_labels) {
      return labels_of_a.sorted() == labels_of_b.sorted();
    }
    number_of_labels = dictionary.size();
  }
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_BRANCH_GRAPH_H
