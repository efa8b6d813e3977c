// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The agreement of the branches of a skeleton with the limbs of a known tree.

#ifndef CSCD_TEST_SUPPORT_TREE_MATCH_H
#define CSCD_TEST_SUPPORT_TREE_MATCH_H

#include "Shape.h"
#include "Synthetic_tree.h"
#include <CSCD/Tree/Tree_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::test {

/// A branch of a skeleton.
struct Found_branch
{
  std::vector<Triple> axis; ///< begins at the joint
  std::vector<double> radii;
  std::optional<std::size_t> parent;
  std::size_t order = 0;
};

/// The branches of the skeleton of a tree. \tparam Skeleton a `Skeleton_graph`
template <class Skeleton>
std::vector<Found_branch> found_branches(const Skeleton& skeleton, const Tree_report& report)
{
  std::vector<Found_branch> result;
  for (const Tree_branch& branch : report.branches) {
    Found_branch found;
    for (const std::size_t node : branch.nodes) {
      const auto& p = skeleton[node].point;
      found.axis.push_back({p.x(), p.y(), p.z()});
      found.radii.push_back(skeleton[node].radius);
    }
    if (branch.parent != no_branch) {
      found.parent = branch.parent;
    }
    found.order = branch.order;
    result.push_back(std::move(found));
  }
  return result;
}

/// The result of matching a tree.
struct Tree_match
{
  std::size_t number_of_limbs = 0; ///< those long enough to be seen
  std::size_t number_of_branches = 0;
  std::size_t found = 0;         ///< limbs with a branch of their own along most of their length
  std::size_t missed = 0;        ///< other limbs
  std::size_t superfluous = 0;   ///< branches that do not match any limb
  std::size_t right_parents = 0; ///< found limbs whose branch grows from the branch of their parent
  std::size_t right_orders = 0;  ///< found limbs whose branch has their order
  double length_error = 0;       ///< sum over the found limbs of the differences of lengths, relative to their lengths
  double radius_error = 0;       ///< median over the nodes of those branches, relative to the radius of the limb
  double radius_bias = 0;        ///< the same with sign
  double distance = 0;           ///< median distance of those nodes from the axis, relative to the radius of the limb
};

/// Matches limbs and branches.
class Tree_matching
{
public:
  /// \param shortest the length of the shortest limb, beyond its parent, that can be seen
  /// \param tolerance the distance, in addition to the radius, of two curves that count as the same
  /// \param thick the least radius of limbs where radii are compared
  Tree_matching(const std::vector<Tree_limb>& limbs, const std::vector<Found_branch>& branches, double shortest,
                double tolerance, double thick)
      : m_limbs(limbs), m_branches(branches), m_tolerance(tolerance), m_thick(thick),
        m_branch_of_limb(limbs.size(), none), m_limb_of_branch(branches.size(), none)
  {
    for (const Tree_limb& limb : limbs) {
      m_samples.push_back(samples_beyond_parent(limb));
    }
    match();
    m_result.number_of_branches = branches.size();
    for (std::size_t limb = 0; limb < limbs.size(); ++limb) {
      const bool is_seen = double(m_samples[limb].size()) * step >= shortest;
      m_result.number_of_limbs += is_seen ? 1 : 0;
      if (m_branch_of_limb[limb] != none && is_seen) {
        count(limb);
      } else if (is_seen) {
        ++m_result.missed;
      }
    }
    m_result.superfluous = std::size_t(std::count(m_limb_of_branch.begin(), m_limb_of_branch.end(), none));
    if (m_true_length > 0) {
      m_result.length_error /= m_true_length;
    }
    m_result.radius_error = median(m_radius_errors);
    m_result.radius_bias = median(m_radius_biases);
    m_result.distance = median(m_distances);
  }

  const Tree_match& result() const { return m_result; }
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

private:
  static constexpr double step = 0.02;     // between samples of an axis
  static constexpr double min_share = 0.5; // of a limb that a branch must follow, and of a branch that must be on it

  static double median(std::vector<double>& values)
  {
    if (values.empty()) {
      return 0;
    }
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  static std::vector<Triple> sampled_axis(const std::vector<Triple>& axis)
  {
    std::vector<Triple> result;
    for (std::size_t i = 1; i < axis.size(); ++i) {
      const double length = norm(axis[i] - axis[i - 1]);
      const auto number = std::size_t(std::ceil(length / step));
      for (std::size_t k = 0; k < number; ++k) {
        const double t = (double(k) + 0.5) / double(number);
        result.push_back((1 - t) * axis[i - 1] + t * axis[i]);
      }
    }
    return result;
  }

  /// The distance to a curve, and the radius of it there.
  static std::pair<double, double> nearest(const std::vector<Triple>& axis, const std::vector<double>& radii,
                                           const Triple& p)
  {
    std::pair<double, double> result{std::numeric_limits<double>::max(), 0};
    for (std::size_t i = 1; i < axis.size(); ++i) {
      const Centreline_segment segment{axis[i - 1], axis[i], radii[i - 1], radii[i]};
      const double d = test::distance(segment, p);
      if (d < result.first) {
        result = {d, radius_near(segment, p)};
      }
    }
    return result;
  }

  std::vector<Triple> samples_beyond_parent(const Tree_limb& limb) const
  {
    std::vector<Triple> result;
    for (const Triple& p : sampled_axis(limb.axis)) {
      if (limb.parent) {
        const auto [distance, radius] = nearest(m_limbs[*limb.parent].axis, m_limbs[*limb.parent].radii, p);
        if (distance <= radius) {
          continue;
        }
      }
      result.push_back(p);
    }
    return result;
  }

  /// The part of `samples` that are near the curve of a branch.
  double share(const std::vector<Triple>& samples, const Tree_limb& limb, const Found_branch& branch) const
  {
    std::size_t number = 0;
    for (const Triple& p : samples) {
      const double limit = m_tolerance + nearest(limb.axis, limb.radii, p).second;
      number += nearest(branch.axis, branch.radii, p).first <= limit ? 1 : 0;
    }
    return samples.empty() ? 0 : double(number) / double(samples.size());
  }

  /// Pairs by the share that both have of each other, the best first.
  void match()
  {
    struct Pair
    {
      double score;
      std::size_t limb;
      std::size_t branch;
    };
    std::vector<Pair> pairs;
    for (std::size_t branch = 0; branch < m_branches.size(); ++branch) {
      std::vector<Triple> own = m_branches[branch].axis;
      if (m_branches[branch].parent && own.size() > 2) {
        own.erase(own.begin()); // the way from the axis of the parent
      }
      const std::vector<Triple> samples = sampled_axis(own);
      for (std::size_t limb = 0; limb < m_limbs.size(); ++limb) {
        const double of_limb = share(m_samples[limb], m_limbs[limb], m_branches[branch]);
        if (of_limb < min_share) {
          continue;
        }
        std::size_t near = 0;
        for (const Triple& p : samples) {
          const auto [distance, radius] = nearest(m_limbs[limb].axis, m_limbs[limb].radii, p);
          near += distance <= m_tolerance + radius ? 1 : 0;
        }
        const double of_branch = samples.empty() ? 0 : double(near) / double(samples.size());
        if (of_branch >= min_share) {
          pairs.push_back({of_limb + of_branch, limb, branch});
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.score > b.score; });
    for (const Pair& pair : pairs) {
      if (m_branch_of_limb[pair.limb] == none && m_limb_of_branch[pair.branch] == none) {
        m_branch_of_limb[pair.limb] = pair.branch;
        m_limb_of_branch[pair.branch] = pair.limb;
      }
    }
  }

  void count(std::size_t limb)
  {
    const Tree_limb& l = m_limbs[limb];
    const Found_branch& branch = m_branches[m_branch_of_limb[limb]];
    ++m_result.found;
    m_result.right_orders += branch.order == l.order ? 1 : 0;
    m_result.right_parents +=
        l.parent ? (branch.parent && m_branch_of_limb[*l.parent] == *branch.parent ? 1 : 0) : (branch.parent ? 0 : 1);
    const double true_length = length(l);
    double found_length = 0;
    for (std::size_t i = 1; i < branch.axis.size(); ++i) {
      found_length += norm(branch.axis[i] - branch.axis[i - 1]);
    }
    m_true_length += true_length;
    m_result.length_error += std::abs(found_length - true_length);
    for (std::size_t i = branch.parent ? 1 : 0; i < branch.axis.size(); ++i) {
      const auto [distance, radius] = nearest(l.axis, l.radii, branch.axis[i]);
      if (radius < m_thick) {
        continue;
      }
      m_radius_errors.push_back(std::abs(branch.radii[i] - radius) / radius);
      m_radius_biases.push_back((branch.radii[i] - radius) / radius);
      m_distances.push_back(distance / radius);
    }
  }

  const std::vector<Tree_limb>& m_limbs;
  const std::vector<Found_branch>& m_branches;
  double m_tolerance;
  double m_thick;
  std::vector<std::vector<Triple>> m_samples; // of the limbs, beyond their parents
  std::vector<std::size_t> m_branch_of_limb;
  std::vector<std::size_t> m_limb_of_branch;
  double m_true_length = 0;
  std::vector<double> m_radius_errors; // of the nodes that count
  std::vector<double> m_radius_biases;
  std::vector<double> m_distances;
  Tree_match m_result;
};

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_TREE_MATCH_H
