// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The significance of each branch of a finished skeleton, and the order of pruning.

#ifndef CSCD_SKELETON_BRANCH_HIERARCHY_H
#define CSCD_SKELETON_BRANCH_HIERARCHY_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <vector>

namespace CSCD {
namespace internal {

/// The measure for pruning branches.
enum class Branch_measure
{
  significance,      ///< how far the limb reaches beyond the body it stands on, in its mean radii
  length,            ///< along the branch
  length_over_radius ///< the length in mean radii of the branch
};

/// A path from a tip; lengths and integrals of the radius are measured from there.
class Limb
{
public:
  explicit Limb(Index tip) : m_nodes{tip}, m_length{0}, m_integral{0} {}

  /// Adds the next node.
  void append(const Skeleton& skeleton, Index edge, Index node)
  {
    const double length = skeleton.length(skeleton.edges[edge]);
    m_integral.push_back(m_integral.back() + length * (radius(skeleton, end()) + radius(skeleton, node)) / 2);
    m_length.push_back(m_length.back() + length);
    m_nodes.push_back(node);
    m_edges.push_back(edge);
  }

  Index tip() const { return m_nodes.front(); }
  Index end() const { return m_nodes.back(); }
  const std::vector<Index>& edges() const { return m_edges; }
  double length() const { return m_length.back(); }

  /// The measure of the limb, which stands on the ball of its last node or, if it `ends_in_tip`, on that of its mean
  /// radius.
  double measure(const Skeleton& skeleton, Branch_measure measure, bool ends_in_tip) const
  {
    if (measure == Branch_measure::length) {
      return length();
    }
    const double mean = mean_radius(length(), skeleton);
    if (measure == Branch_measure::length_over_radius) {
      return ratio(length(), mean);
    }
    const double tip_radius = radius(skeleton, tip());
    const double end_radius = radius(skeleton, end());
    return ends_in_tip
               ? ratio(std::max((length() + tip_radius + end_radius) / 2 - mean, 0.), mean)
               : ratio(std::max(length() + tip_radius - end_radius, 0.), mean_radius(length() - end_radius, skeleton));
  }

private:
  static double radius(const Skeleton& skeleton, Index node) { return skeleton.has_radii() ? skeleton.radii[node] : 0; }

  /// A limb without a radius is infinitely slender.
  static double ratio(double length, double radius)
  {
    return length <= 0 ? 0 : radius > 0 ? length / radius : std::numeric_limits<double>::infinity();
  }

  /// The mean over the first stretch of this length; the radius of the tip if `length` is not positive.
  double mean_radius(double length, const Skeleton& skeleton) const
  {
    if (!(length > 0)) {
      return radius(skeleton, tip());
    }
    const auto last = std::lower_bound(m_length.begin() + 1, m_length.end() - 1, length) - m_length.begin();
    const auto i = std::size_t(last);
    const double rest = length - m_length[i - 1];
    const double part = m_length[i] > m_length[i - 1] ? std::min(rest / (m_length[i] - m_length[i - 1]), 1.) : 0;
    const double from = radius(skeleton, m_nodes[i - 1]);
    const double to = from + part * (radius(skeleton, m_nodes[i]) - from);
    return (m_integral[i - 1] + rest * (from + to) / 2) / length;
  }

  std::vector<Index> m_nodes;
  std::vector<Index> m_edges;
  std::vector<double> m_length;   ///< from the tip to each node
  std::vector<double> m_integral; ///< of the radius, likewise
};

/// Cuts the limbs of a skeleton, the least first, and records when each edge falls.
///
/// A limb is a branch that ends in a tip. When only two branches are left at a junction, they are one from then on,
/// which is measured anew, but never less than a branch that was cut there. So the edges that fall last are the body.
/// Edges on cycles and between cycles are never cut. O(n log n). Ties are broken by position, so that the answer does
/// not depend on the numbering.
class Branch_hierarchy
{
public:
  /// \param skeleton is referred to while this is constructed
  Branch_hierarchy(const Skeleton& skeleton, Branch_measure measure)
      : m_skeleton(skeleton), m_measure(measure), m_incident(skeleton.number_of_nodes()),
        m_degree(skeleton.number_of_nodes(), 0), m_limb_of_edge(skeleton.edges.size(), no_index),
        m_level(skeleton.edges.size(), never), m_is_cut(skeleton.edges.size(), 0), m_is_last(skeleton.edges.size(), 0)
  {
    for (Index edge = 0; edge < skeleton.edges.size(); ++edge) {
      for (const Index node : skeleton.edges[edge]) {
        m_incident[node].push_back(edge);
        ++m_degree[node];
      }
    }
    for (Index node = 0; node < m_degree.size(); ++node) {
      if (m_degree[node] == 1 && m_limb_of_edge[m_incident[node][0]] == no_index) {
        m_limbs.emplace_back(node);
        grow(Index(m_limbs.size() - 1), 0);
      }
    }
    while (!m_queue.empty()) {
      const Candidate least = m_queue.top();
      m_queue.pop();
      if (is_current(least)) {
        cut(least);
      }
    }
  }

  /// The level of edges that are never cut.
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// For each edge, the greatest threshold that keeps it when lower levels are cut.
  const std::vector<double>& levels() const { return m_level; }
  /// Whether `edge` belongs to the path that is left last of a component without cycles.
  bool is_last(Index edge) const { return m_is_last[edge] != 0; }

private:
  /// A limb that may be cut.
  struct Candidate
  {
    double level;
    double length;
    Vector3 tip; ///< its position
    Index limb;
    Index end; ///< the last node of the limb

    /// Whether this one is cut later than `other`.
    bool operator<(const Candidate& other) const
    {
      return level != other.level     ? level > other.level
             : length != other.length ? length > other.length
             : tip != other.tip       ? is_lexicographically_less(other.tip, tip)
                                      : limb > other.limb;
    }
  };

  /// Whether the limb has neither been cut nor grown since.
  bool is_current(const Candidate& candidate) const
  {
    const Limb& limb = m_limbs[candidate.limb];
    const Index edge = limb.edges().front();
    return limb.end() == candidate.end && m_limb_of_edge[edge] == candidate.limb && m_is_cut[edge] == 0;
  }

  /// Prolongs a limb to the next junction, where it may be cut; or settles it if it ends in a tip.
  /// \param least a lower bound of its worth
  void grow(Index number, double least)
  {
    Limb& limb = m_limbs[number];
    follow(limb, number);
    if (m_degree[limb.end()] == 1) {
      settle(limb, least);
      return;
    }
    const double level = std::max(limb.measure(m_skeleton, m_measure, false), least);
    m_queue.push({level, limb.length(), m_skeleton.points[limb.tip()], number, limb.end()});
  }

  void follow(Limb& limb, Index number)
  {
    do {
      const Index node = limb.end();
      for (const Index edge : m_incident[node]) {
        if (m_is_cut[edge] == 0 && m_limb_of_edge[edge] != number) {
          m_limb_of_edge[edge] = number;
          const auto& [a, b] = m_skeleton.edges[edge];
          limb.append(m_skeleton, edge, a == node ? b : a);
          break;
        }
      }
    } while (m_degree[limb.end()] == 2);
  }

  /// The last path of a component is measured from that of its tips which comes first in space.
  void settle(const Limb& limb, double least)
  {
    Limb path = limb;
    if (is_lexicographically_less(m_skeleton.points[limb.end()], m_skeleton.points[limb.tip()])) {
      path = Limb(limb.end());
      for (auto edge = limb.edges().rbegin(); edge != limb.edges().rend(); ++edge) {
        const auto& [a, b] = m_skeleton.edges[*edge];
        path.append(m_skeleton, *edge, a == path.end() ? b : a);
      }
    }
    const double level = std::max(path.measure(m_skeleton, m_measure, true), least);
    for (const Index edge : path.edges()) {
      m_level[edge] = level;
      m_is_last[edge] = 1;
    }
  }

  void cut(const Candidate& candidate)
  {
    for (const Index edge : m_limbs[candidate.limb].edges()) {
      m_level[edge] = candidate.level;
      m_is_cut[edge] = 1;
    }
    if (--m_degree[candidate.end] != 2) {
      return;
    }
    // Only two branches are left here: a limb among them grows, over the other one.
    for (const Index edge : m_incident[candidate.end]) {
      if (m_is_cut[edge] == 0 && m_limb_of_edge[edge] != no_index) {
        grow(m_limb_of_edge[edge], candidate.level);
        return;
      }
    }
  }

  const Skeleton& m_skeleton;
  Branch_measure m_measure;
  std::vector<std::vector<Index>> m_incident; ///< edges at each node; a loop stands twice
  std::vector<std::size_t> m_degree;          ///< without cut edges
  std::vector<Limb> m_limbs;
  std::vector<Index> m_limb_of_edge;
  std::priority_queue<Candidate> m_queue; ///< also holds candidates that are not current
  std::vector<double> m_level;
  std::vector<char> m_is_cut;
  std::vector<char> m_is_last;
};

/// The significance of every edge of `skeleton`; infinite for all where nodes have no radii. See
/// `compute_significance()`.
inline std::vector<double> significance_levels(const Skeleton& skeleton)
{
  return Branch_hierarchy(skeleton, Branch_measure::significance).levels();
}

} // namespace internal

/// computes the significance of every branch of a finished skeleton and writes it to its edges: how far the limb
/// reaches beyond the body it stands on, in radii of the limb.
///
/// For a branch of length *l* from a tip of radius *t* to a junction of radius *j*, with the mean radius *m* over the
/// part farther than *j* from the junction along the branch (*t* if nothing is), it is max(0, *l* + *t* - *j*) / *m*: a
/// cylinder that stands out by *h* has about *h* over its radius, a bump 0. The cutting of branches is simulated, the
/// least first; two that are then alone at a junction are one from then on, at least as significant as a branch that
/// was cut there. All edges get the value that their branch has when it falls. The last branch of a tree, from tip to
/// tip, has (*l* + the radii of both tips) / (2 *m*) - 1, at least 0. Edges on cycles and between cycles are infinitely
/// significant, and so is all that has no radius. So pruning leaves the edges of at least a given significance, and the
/// last branch of each tree, which always stays; and the figures do not change when the skeleton is moved, turned,
/// scaled or renumbered, or pruned. O(n log n) for n nodes.
/// \tparam Skeleton a `CurveSkeletonGraph` whose edges have a `significance`, as in `Skeleton_graph`; others are left
///         unchanged
/// \pre coordinates and radii are finite
template <class Skeleton>
void compute_significance([[maybe_unused]] Skeleton& skeleton)
{
  if constexpr (has_significance_v<Skeleton>) {
    const CSCD::Skeleton indexed = internal::index_skeleton(skeleton);
    const std::vector<double> levels = internal::significance_levels(indexed);
    auto level = levels.begin();
    for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
      skeleton[edge].significance = *level++;
    }
  }
}

} // namespace CSCD

#endif // CSCD_SKELETON_BRANCH_HIERARCHY_H
