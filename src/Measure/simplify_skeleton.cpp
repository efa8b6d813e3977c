// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prunes, joins and resamples a skeleton.

#include "Measure/skeleton_tools.h"
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

using Branch = std::vector<Index>;
using Neighbors = std::vector<std::vector<Index>>;

/// A place on a branch.
struct Branch_point
{
  Vector3 point = Vector3::Zero();
  double radius = 0;
};

/// A straight edge that could join two components.
struct Joint
{
  double squared_distance = std::numeric_limits<double>::infinity();
  Index from = no_index;
  Index to = no_index;
};

void add_edge(Skeleton& skeleton, Index a, Index b, char is_joined)
{
  skeleton.edges.push_back({a, b});
  skeleton.is_joined.push_back(is_joined);
}

/// The two of the ascending `places` around the given one, and its position between them.
std::pair<std::size_t, double> locate(const std::vector<double>& places, double place)
{
  const auto next = std::upper_bound(places.begin() + 1, places.end() - 1, place);
  const double from = *(next - 1);
  const double t = *next > from ? std::clamp((place - from) / (*next - from), 0., 1.) : 0;
  return {std::size_t(next - places.begin()) - 1, t};
}

/// Applies one operation after the other to a skeleton.
class Skeleton_simplification
{
public:
  /// \param solid the body, which is referred to, or null
  Skeleton_simplification(Skeleton skeleton, const Triangulated_solid* solid)
      : m_skeleton(std::move(skeleton)), m_solid(solid)
  {
    m_skeleton.is_joined.resize(m_skeleton.edges.size(), 0);
    m_skeleton.is_opening.resize(m_skeleton.number_of_nodes(), 0);
    m_skeleton.vertices.resize(m_skeleton.number_of_nodes());
  }

  /// Removes components of less than `least` vertices, except the largest.
  void remove_small_components(std::size_t least)
  {
    const std::vector<std::vector<Index>>& vertices = m_skeleton.vertices;
    const bool has_vertices =
        std::any_of(vertices.begin(), vertices.end(), [](const std::vector<Index>& its) { return !its.empty(); });
    const std::vector<Index> component = components();
    std::vector<std::size_t> size(component.size(), 0);
    for (Index v = 0; v < component.size(); ++v) {
      size[component[v]] += has_vertices ? vertices[v].size() : 1;
    }
    const std::size_t largest = size.empty() ? 0 : *std::max_element(size.begin(), size.end());
    std::vector<Index> heir = all_indices(m_skeleton.number_of_nodes());
    for (Index v = 0; v < heir.size(); ++v) {
      if (size[component[v]] < std::min(least, largest)) {
        heir[v] = no_index;
        m_report.number_of_removed_components += component[v] == v ? 1 : 0;
        m_report.number_of_removed_vertices += vertices[v].size();
      }
    }
    keep(heir, std::vector<char>(m_skeleton.edges.size(), 1));
  }

  /// Cuts limbs whose measure is below `threshold`. Their vertices go to the nodes where they are cut.
  void prune(Branch_measure measure, double threshold)
  {
    const Branch_hierarchy limbs(m_skeleton, measure);
    std::vector<char> is_kept(m_skeleton.edges.size());
    std::vector<char> is_node_kept(m_skeleton.number_of_nodes(), 1);
    Disjoint_sets cut_off(is_node_kept.size()); // together with the only node that all of it was cut from
    for (std::size_t e = 0; e < is_kept.size(); ++e) {
      const auto& [a, b] = m_skeleton.edges[e];
      is_kept[e] = limbs.levels()[e] >= threshold || limbs.is_last(Index(e)) ? 1 : 0;
      if (is_kept[e] == 0) {
        is_node_kept[a] = is_node_kept[b] = 0;
        cut_off.join(a, b);
      }
    }
    for (std::size_t e = 0; e < is_kept.size(); ++e) {
      if (is_kept[e] != 0) {
        is_node_kept[m_skeleton.edges[e][0]] = is_node_kept[m_skeleton.edges[e][1]] = 1;
      }
    }
    std::vector<Index> kept_node(is_node_kept.size(), no_index);
    std::vector<Index> heir = all_indices(m_skeleton.number_of_nodes());
    for (const Index v : heir) {
      if (is_node_kept[v] != 0) {
        kept_node[cut_off.find(v)] = v;
      }
    }
    for (Index& v : heir) {
      v = is_node_kept[v] != 0 ? v : kept_node[cut_off.find(v)];
    }
    const std::size_t before = m_skeleton.number_of_nodes();
    keep(heir, is_kept);
    m_report.number_of_removed_nodes += before - m_skeleton.number_of_nodes();
  }

  /// Joins components by straight edges, those of the minimum spanning tree of the components, by Prim's algorithm from
  /// the largest on: O(e n) for n nodes and e ends.
  /// \throw Input_error if there are too many nodes
  void join_components()
  {
    const std::vector<Index> component = components();
    const std::vector<char> is_end = ends_of_components(component);
    std::vector<std::vector<Index>> members(component.size()); // of each component, at the node that stands for it
    for (Index v = 0; v < component.size(); ++v) {
      members[component[v]].push_back(v);
    }
    std::vector<Index> open = all_indices(component.size()); // components that are not joined yet
    open.erase(std::remove_if(open.begin(), open.end(), [&](Index c) { return members[c].empty(); }), open.end());
    if (open.size() < 2) {
      return;
    }
    auto next = std::max_element(open.begin(), open.end(),
                                 [&](Index a, Index b) { return members[a].size() < members[b].size(); });
    std::vector<Joint> best(component.size()); // from the joined part to each open component
    for (double number_of_pairs = 0; !open.empty();) {
      const Index joined = *next;
      open.erase(next);
      if (best[joined].from != no_index) {
        add_edge(m_skeleton, best[joined].from, best[joined].to, 1);
        ++m_report.number_of_joined_edges;
      }
      for (const Index c : open) {
        number_of_pairs += double(members[joined].size()) * double(members[c].size());
        constexpr double max_number_of_pairs = 1ULL << 34; // a minute
        if (number_of_pairs > max_number_of_pairs) {
          throw Input_error(
              "the components have too many nodes to be joined: remove small ones or resample branches first");
        }
        for (const Index v : members[joined]) {
          for (const Index w : members[c]) {
            if (is_end[v] != 0 || is_end[w] != 0) {
              const Joint joint{(point(v) - point(w)).squaredNorm(), v, w};
              best[c] = is_before(joint, best[c]) ? joint : best[c];
            }
          }
        }
      }
      next = std::min_element(open.begin(), open.end(), [&](Index a, Index b) { return is_before(best[a], best[b]); });
    }
  }

  /// Replaces the nodes of branches by evenly spaced ones.
  /// \param is_relative whether the spacing is in radii
  /// \throw Input_error if there would be too many nodes
  void resample(double spacing, bool is_relative)
  {
    std::vector<char> is_fixed(m_skeleton.number_of_nodes(), 0);
    const std::vector<Branch> branches = branches_between_fixed(is_fixed);
    Skeleton next;
    std::vector<Index> heir = all_indices(m_skeleton.number_of_nodes());
    for (Index& v : heir) {
      v = is_fixed[v] != 0 ? copy_node(next, v) : no_index;
    }
    for (std::size_t e = 0; e < m_skeleton.edges.size(); ++e) {
      if (m_skeleton.is_joined[e] != 0) {
        add_edge(next, heir[m_skeleton.edges[e][0]], heir[m_skeleton.edges[e][1]], 1);
      }
    }
    const auto ends_of = [](const Branch& branch) -> std::pair<Index, Index> {
      return std::minmax(branch.front(), branch.back());
    };
    std::map<std::pair<Index, Index>, int> number_between; // of branches between the same ends
    for (const Branch& branch : branches) {
      ++number_between[ends_of(branch)];
    }
    for (const Branch& branch : branches) {
      const std::vector<double> place = places(branch, spacing, is_relative);
      if (!(double(next.number_of_nodes()) + place.back() < max_nodes)) {
        throw Input_error("the spacing asks for more than ten million nodes: choose a greater one");
      }
      // A cycle has at least three nodes, and of parallel branches only one could do without a node.
      const std::size_t min_parts = branch.front() == branch.back() ? 3 : number_between[ends_of(branch)] > 1 ? 2 : 1;
      const std::size_t parts = std::max(std::size_t(std::lround(place.back())), min_parts);
      if (place.back() > 0) {
        resample(branch, place, parts, next, heir);
        continue;
      }
      for (std::size_t i = 1; i < branch.size(); ++i) {
        if (i + 1 < branch.size()) {
          heir[branch[i]] = copy_node(next, branch[i]);
        }
        add_edge(next, heir[branch[i - 1]], heir[branch[i]], 0);
      }
    }
    replace(std::move(next), heir);
  }

  /// Moves the result to `skeleton`. \return the changes
  Simplification_report move_to(Skeleton& skeleton)
  {
    static_cast<Skeleton_counts&>(m_report) = count_skeleton(m_skeleton);
    const Neighbors neighbors = node_neighbors(m_skeleton);
    for (Index v = 0; v < neighbors.size(); ++v) {
      char& is_opening = m_skeleton.is_opening[v];
      is_opening = is_opening != 0 && neighbors[v].size() < 2 ? 1 : 0; // a joined end is not an end
    }
    m_skeleton.significance = significance_levels(m_skeleton);
    m_skeleton.separators = std::move(skeleton.separators);
    skeleton = std::move(m_skeleton);
    return m_report;
  }

private:
  /// So many nodes that their numbers cannot overflow, and memory suffices.
  static constexpr double max_nodes = 1e7;
  /// Radii count at least this much of the mean radius of their branch, since no spacing follows a radius of 0.
  static constexpr double min_relative_radius = 0.05;

  const Vector3& point(Index v) const { return m_skeleton.points[v]; }
  double radius(Index v) const { return m_skeleton.has_radii() ? m_skeleton.radii[v] : 0; }

  /// Whether a straight edge lies inside; always, if the body is not known.
  bool is_inside(const Vector3& from, const Vector3& to) const
  {
    if (m_solid == nullptr) {
      return true;
    }
    const Vector3 a = m_solid->normalization().from_input(from);
    const Vector3 b = m_solid->normalization().from_input(to);
    std::vector<double> crossings;
    m_solid->crossings(a, b, crossings);
    return crossings.empty() && m_solid->is_inside(a) && m_solid->is_inside(b);
  }

  /// For each node one of its component, always the same.
  std::vector<Index> components() const
  {
    Disjoint_sets sets(m_skeleton.number_of_nodes(), m_skeleton.edges);
    std::vector<Index> result = all_indices(m_skeleton.number_of_nodes());
    std::transform(result.begin(), result.end(), result.begin(), [&sets](Index v) { return sets.find(v); });
    return result;
  }

  Index add_node(Skeleton& to, const Branch_point& place, char is_opening) const
  {
    to.points.push_back(place.point);
    if (m_skeleton.has_radii()) {
      to.radii.push_back(place.radius);
    }
    to.is_opening.push_back(is_opening);
    to.vertices.emplace_back();
    return Index(to.number_of_nodes() - 1);
  }
  Index copy_node(Skeleton& to, Index v) const { return add_node(to, {point(v), radius(v)}, m_skeleton.is_opening[v]); }

  /// \param heir of each node, the node of `next` that its vertices go to, or `no_index`
  void replace(Skeleton&& next, const std::vector<Index>& heir)
  {
    for (Index v = 0; v < heir.size(); ++v) {
      if (heir[v] != no_index) {
        const std::vector<Index>& vertices = m_skeleton.vertices[v];
        next.vertices[heir[v]].insert(next.vertices[heir[v]].end(), vertices.begin(), vertices.end());
      }
    }
    m_skeleton = std::move(next);
  }

  /// Keeps the nodes that are their own heirs, and the edges of `is_kept` between such.
  /// \param heir of each node, which is kept; or `no_index`
  void keep(std::vector<Index> heir, const std::vector<char>& is_kept)
  {
    Skeleton next;
    std::vector<Index> number(heir.size(), no_index);
    for (Index v = 0; v < heir.size(); ++v) {
      number[v] = heir[v] == v ? copy_node(next, v) : no_index;
    }
    for (std::size_t e = 0; e < is_kept.size(); ++e) {
      const auto& [a, b] = m_skeleton.edges[e];
      if (is_kept[e] != 0 && number[a] != no_index && number[b] != no_index) {
        add_edge(next, number[a], number[b], m_skeleton.is_joined[e]);
      }
    }
    for (Index& v : heir) {
      v = v == no_index ? no_index : number[v];
    }
    replace(std::move(next), heir);
  }

  /// Whether `a` is the better one: by length; of equal ones by position, so that the numbering does not matter.
  bool is_before(const Joint& a, const Joint& b) const
  {
    if (a.from == no_index || b.from == no_index) {
      return a.from != no_index; // also where squares overflow
    }
    if (a.squared_distance != b.squared_distance) {
      return a.squared_distance < b.squared_distance;
    }
    const auto key = [this](const Joint& joint) {
      const auto position = [this](Index v) { return std::make_tuple(point(v).x(), point(v).y(), point(v).z(), v); };
      return std::minmax({position(joint.from), position(joint.to)});
    };
    return key(a) < key(b);
  }

  /// For each node whether edges that join components begin there: tips and isolated nodes, and all nodes of components
  /// that have none.
  std::vector<char> ends_of_components(const std::vector<Index>& component) const
  {
    const Neighbors neighbors = node_neighbors(m_skeleton);
    std::vector<char> has_tip(component.size(), 0);
    for (Index v = 0; v < component.size(); ++v) {
      has_tip[component[v]] = has_tip[component[v]] != 0 || neighbors[v].size() < 2 ? 1 : 0;
    }
    std::vector<char> is_end(component.size());
    for (Index v = 0; v < component.size(); ++v) {
      is_end[v] = neighbors[v].size() < 2 || has_tip[component[v]] == 0 ? 1 : 0;
    }
    return is_end;
  }

  /// The branches of the skeleton without its joined edges, cut at the ends of these.
  /// \param is_fixed is set for the ends of all branches
  std::vector<Branch> branches_between_fixed(std::vector<char>& is_fixed) const
  {
    Skeleton without_joints{m_skeleton.points};
    for (std::size_t e = 0; e < m_skeleton.edges.size(); ++e) {
      const auto& [a, b] = m_skeleton.edges[e];
      if (m_skeleton.is_joined[e] != 0) {
        is_fixed[a] = is_fixed[b] = 1;
      } else {
        without_joints.edges.push_back({a, b});
      }
    }
    std::vector<Branch> result;
    for (const Branch& branch : split_into_branches(node_neighbors(without_joints))) {
      is_fixed[branch.front()] = is_fixed[branch.back()] = 1;
      auto begin = branch.begin();
      for (auto node = branch.begin() + 1; node < branch.end(); ++node) {
        if (is_fixed[*node] != 0) {
          result.emplace_back(begin, node + 1);
          begin = node;
        }
      }
    }
    return result;
  }

  /// How many spacings each node is from the begin of the branch.
  std::vector<double> places(const Branch& branch, double spacing, bool is_relative) const
  {
    double mean_radius = 0;
    for (const Index v : branch) {
      mean_radius += radius(v) / double(branch.size());
    }
    std::vector<double> result{0};
    for (std::size_t i = 1; i < branch.size(); ++i) {
      const double local = std::max((radius(branch[i - 1]) + radius(branch[i])) / 2, min_relative_radius * mean_radius);
      const double unit = is_relative ? spacing * local : spacing;
      result.push_back(result.back() + (unit > 0 ? m_skeleton.length({branch[i - 1], branch[i]}) / unit : 0));
    }
    return result;
  }

  Branch_point point_at(const Branch& branch, const std::vector<double>& places, double place) const
  {
    const auto [edge, t] = locate(places, place);
    return {(1 - t) * point(branch[edge]) + t * point(branch[edge + 1]),
            (1 - t) * radius(branch[edge]) + t * radius(branch[edge + 1])};
  }

  /// Halves stretches that leave the body, unless they are parts of one edge that does.
  void refine(const Branch& branch, const std::vector<double>& place, std::vector<double>& samples) const
  {
    for (std::size_t size = 0; size != samples.size();) {
      size = samples.size();
      std::vector<double> finer{samples.front()};
      for (std::size_t i = 1; i < samples.size(); ++i) {
        const bool is_bent = std::upper_bound(place.begin(), place.end(), samples[i - 1]) !=
                             std::lower_bound(place.begin(), place.end(), samples[i]);
        const double halfway = (samples[i - 1] + samples[i]) / 2;
        if (is_bent && samples[i - 1] < halfway && halfway < samples[i] &&
            !is_inside(point_at(branch, place, samples[i - 1]).point, point_at(branch, place, samples[i]).point)) {
          finer.push_back(halfway);
        }
        finer.push_back(samples[i]);
      }
      samples = std::move(finer);
    }
  }

  /// Replaces a branch by one of evenly spaced nodes; its ends are in `next` already.
  void resample(const Branch& branch, const std::vector<double>& place, std::size_t parts, Skeleton& next,
                std::vector<Index>& heir) const
  {
    std::vector<double> samples;
    for (std::size_t i = 0; i <= parts; ++i) {
      samples.push_back(double(i) / double(parts) * place.back());
    }
    if (m_solid != nullptr) {
      refine(branch, place, samples);
    }
    std::vector<Index> nodes{heir[branch.front()]};
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
      nodes.push_back(add_node(next, point_at(branch, place, samples[i]), 0));
    }
    nodes.push_back(heir[branch.back()]);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      add_edge(next, nodes[i - 1], nodes[i], 0);
    }
    for (std::size_t i = 1; i + 1 < branch.size(); ++i) {
      const auto [edge, t] = locate(samples, place[i]);
      heir[branch[i]] = nodes[t > 1. / 2 ? edge + 1 : edge];
    }
  }

  Skeleton m_skeleton;
  Simplification_report m_report;
  const Triangulated_solid* m_solid;
};

/// \throw Input_error if a number is not finite or negative
void check_simplification(const Skeleton& skeleton, const Simplification_parameters& parameters)
{
  const auto is_length = [](double value) { return value >= 0 && value <= std::numeric_limits<double>::max(); };
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    check_finite(skeleton, v);
    if (skeleton.has_radii() && !is_length(skeleton.radii[v])) {
      fail_at_node(v, "has a radius that is negative or not finite: correct it");
    }
  }
  for (const auto& [name, value] :
       {std::pair("minimum_significance", parameters.min_significance),
        std::pair("minimum_branch_length", parameters.min_length),
        std::pair("minimum_length_over_radius", parameters.min_length_over_radius),
        std::pair("spacing", parameters.spacing), std::pair("spacing_over_radius", parameters.spacing_over_radius)}) {
    if (!is_length(value)) {
      throw Input_error(std::string(name) + " is negative or not finite: choose a number that is at least 0");
    }
  }
  if (parameters.spacing > 0 && parameters.spacing_over_radius > 0) {
    throw Input_error("nodes cannot have a spacing by length and one by radius: leave one out");
  }
  const bool needs_radii =
      parameters.min_significance > 0 || parameters.min_length_over_radius > 0 || parameters.spacing_over_radius > 0;
  if (needs_radii && skeleton.number_of_nodes() > 0 &&
      std::none_of(skeleton.radii.begin(), skeleton.radii.end(), [](double radius) { return radius > 0; })) {
    throw Input_error("the skeleton has no radii, in which significance and relative lengths are measured: use lengths "
                      "in the unit of the skeleton, or one that has radii");
  }
}

} // namespace

Simplification_report simplify_skeleton(Skeleton& skeleton, const Simplification_parameters& parameters,
                                        const Triangulated_solid* solid)
{
  check_simplification(skeleton, parameters);
  Skeleton_simplification simplification(skeleton, solid);
  if (parameters.min_component_size > 0) {
    simplification.remove_small_components(parameters.min_component_size);
  }
  for (const auto& [measure, threshold] :
       {std::pair(Branch_measure::significance, parameters.min_significance),
        std::pair(Branch_measure::length, parameters.min_length),
        std::pair(Branch_measure::length_over_radius, parameters.min_length_over_radius)}) {
    if (threshold > 0) {
      simplification.prune(measure, threshold);
    }
  }
  if (parameters.joins_components) {
    simplification.join_components();
  }
  if (parameters.spacing > 0 || parameters.spacing_over_radius > 0) {
    simplification.resample(std::max(parameters.spacing, parameters.spacing_over_radius),
                            parameters.spacing_over_radius > 0);
  }
  return simplification.move_to(skeleton);
}

} // namespace CSCD::internal
