// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prunes, merges, joins, resamples and smooths a skeleton.

#include "Measure/count_skeleton.h"
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// The body, if it is known.
class Body
{
public:
  /// \param solid is referred to, or null
  explicit Body(const Triangulated_solid* solid) : m_solid(solid) {}

  /// Whether a straight edge lies inside; always, if the body is not known.
  bool holds(const Vector_3& from, const Vector_3& to) const
  {
    if (!is_known()) {
      return true;
    }
    const Vector_3 a = m_solid->normalization().from_input(from);
    const Vector_3 b = m_solid->normalization().from_input(to);
    std::vector<double> crossings;
    m_solid->crossings(a, b, crossings);
    return crossings.empty() && m_solid->is_inside(a) && m_solid->is_inside(b);
  }

  bool is_known() const { return m_solid != nullptr; }

private:
  const Triangulated_solid* m_solid;
};

/// Samples the branches of a skeleton anew.
class Branch_resampling
{
public:
  /// \param skeleton, body are referred to
  /// \param is_relative whether the spacing is in radii
  Branch_resampling(const Skeleton& skeleton, const Body& body, double spacing, bool is_relative)
      : m_skeleton(skeleton), m_body(body), m_spacing(spacing), m_is_relative(is_relative),
        m_is_fixed(skeleton.number_of_nodes(), 0), m_heir(skeleton.number_of_nodes(), no_index)
  {
  }

  /// \throw Input_error if there would be too many nodes
  void operator()()
  {
    const std::vector<Branch> branches = find_branches();
    add_fixed();
    for (const Branch& branch : branches) {
      m_ends.push_back(ends(branch));
    }
    std::sort(m_ends.begin(), m_ends.end());
    for (const Branch& branch : branches) {
      resample(branch);
    }
  }

  const Skeleton& result() const { return m_result; }
  /// For each node of the result the node that it was, or `no_index`.
  const std::vector<Index>& old_nodes() const { return m_old_node; }
  /// For each node that was, the nearest one of the result on its branch.
  const std::vector<Index>& heirs() const { return m_heir; }

private:
  using Branch = std::vector<Index>;

  /// So many that numbers of nodes cannot overflow, and memory suffices.
  static constexpr double max_nodes = 1e7;
  /// Radii count at least this much of the mean radius of their branch, since no spacing follows a radius of 0.
  static constexpr double min_relative_radius = 0.05;

  double radius(Index v) const { return m_skeleton.has_radii() ? m_skeleton.radii[v] : 0; }

  static std::array<Index, 2> ends(const Branch& branch)
  {
    return {std::min(branch.front(), branch.back()), std::max(branch.front(), branch.back())};
  }

  /// The branches of the skeleton without its joined edges, whose ends stay too.
  std::vector<Branch> find_branches()
  {
    std::vector<std::vector<Index>> neighbors = node_neighbors(m_skeleton);
    for (std::size_t e = 0; e < m_skeleton.edges.size(); ++e) {
      if (m_skeleton.is_joined[e] != 0) {
        const auto& [a, b] = m_skeleton.edges[e];
        neighbors[a].erase(std::find(neighbors[a].begin(), neighbors[a].end(), b));
        neighbors[b].erase(std::find(neighbors[b].begin(), neighbors[b].end(), a));
        m_is_fixed[a] = m_is_fixed[b] = 1;
      }
    }
    std::vector<Branch> result;
    for (const Branch& branch : split_into_branches(neighbors)) {
      m_is_fixed[branch.front()] = m_is_fixed[branch.back()] = 1;
      auto begin = branch.begin();
      for (auto node = branch.begin() + 1; node < branch.end(); ++node) {
        if (m_is_fixed[*node] != 0) {
          result.emplace_back(begin, node + 1);
          begin = node;
        }
      }
    }
    return result;
  }

  void add_fixed()
  {
    for (Index v = 0; v < m_heir.size(); ++v) {
      if (m_is_fixed[v] != 0) {
        m_heir[v] = add_node(m_skeleton.points[v], radius(v), v);
      }
    }
    for (std::size_t e = 0; e < m_skeleton.edges.size(); ++e) {
      if (m_skeleton.is_joined[e] != 0) {
        add_edge(m_heir[m_skeleton.edges[e][0]], m_heir[m_skeleton.edges[e][1]], 1);
      }
    }
  }

  Index add_node(const Vector_3& point, double radius, Index old_node)
  {
    m_result.points.push_back(point);
    if (m_skeleton.has_radii()) {
      m_result.radii.push_back(radius);
    }
    m_old_node.push_back(old_node);
    return Index(m_old_node.size() - 1);
  }

  void add_edge(Index a, Index b, char is_joined)
  {
    m_result.edges.push_back({a, b});
    m_result.is_joined.push_back(is_joined);
  }

  /// How many spacings each node is from the begin of the branch.
  std::vector<double> places(const Branch& branch) const
  {
    double mean_radius = 0;
    for (const Index v : branch) {
      mean_radius += radius(v) / double(branch.size());
    }
    std::vector<double> result{0};
    for (std::size_t i = 1; i < branch.size(); ++i) {
      const double local = std::max((radius(branch[i - 1]) + radius(branch[i])) / 2, min_relative_radius * mean_radius);
      const double unit = m_is_relative ? m_spacing * local : m_spacing;
      result.push_back(result.back() + (unit > 0 ? m_skeleton.length({branch[i - 1], branch[i]}) / unit : 0));
    }
    return result;
  }

  /// A cycle has at least three nodes, and of parallel branches only one could do without a node.
  std::size_t min_parts(const Branch& branch) const
  {
    const auto [first, last] = std::equal_range(m_ends.begin(), m_ends.end(), ends(branch));
    return branch.front() == branch.back() ? 3 : last - first > 1 ? 2 : 1;
  }

  void resample(const Branch& branch)
  {
    const std::vector<double> place = places(branch);
    const double total = place.back();
    if (!(double(m_old_node.size()) + total < max_nodes)) {
      throw Input_error("the spacing asks for more than ten million nodes: choose a greater one");
    }
    const std::size_t parts = std::max(std::size_t(std::lround(total)), min_parts(branch));
    if (!(total > 0) || (parts == 1 && branch.size() == 2)) {
      keep(branch);
      return;
    }
    std::vector<double> samples;
    for (std::size_t i = 0; i <= parts; ++i) {
      samples.push_back(double(i) / double(parts) * total);
    }
    if (m_body.is_known()) {
      refine(branch, place, samples);
    }
    std::vector<Index> nodes{m_heir[branch.front()]};
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
      const auto [edge, t] = locate(place, samples[i]);
      nodes.push_back(add_node(point(branch, place, samples[i]),
                               (1 - t) * radius(branch[edge]) + t * radius(branch[edge + 1]), no_index));
    }
    nodes.push_back(m_heir[branch.back()]);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      add_edge(nodes[i - 1], nodes[i], 0);
    }
    for (std::size_t i = 1; i + 1 < branch.size(); ++i) {
      const auto [edge, t] = locate(samples, place[i]);
      m_heir[branch[i]] = nodes[t > 1. / 2 ? edge + 1 : edge];
    }
  }

  void keep(const Branch& branch)
  {
    for (std::size_t i = 1; i < branch.size(); ++i) {
      if (i + 1 < branch.size()) {
        m_heir[branch[i]] = add_node(m_skeleton.points[branch[i]], radius(branch[i]), branch[i]);
      }
      add_edge(m_heir[branch[i - 1]], m_heir[branch[i]], 0);
    }
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
        const double middle = (samples[i - 1] + samples[i]) / 2;
        if (is_bent && samples[i - 1] < middle && middle < samples[i] &&
            !m_body.holds(point(branch, place, samples[i - 1]), point(branch, place, samples[i]))) {
          finer.push_back(middle);
        }
        finer.push_back(samples[i]);
      }
      samples = std::move(finer);
    }
  }

  /// Between which two of the ascending `places` the given one is, and where between them.
  static std::pair<std::size_t, double> locate(const std::vector<double>& places, double place)
  {
    const auto next = std::upper_bound(places.begin() + 1, places.end() - 1, place);
    const double from = *(next - 1);
    const double t = *next > from ? std::clamp((place - from) / (*next - from), 0., 1.) : 0;
    return {std::size_t(next - places.begin()) - 1, t};
  }

  Vector_3 point(const Branch& branch, const std::vector<double>& places, double place) const
  {
    const auto [edge, t] = locate(places, place);
    return (1 - t) * m_skeleton.points[branch[edge]] + t * m_skeleton.points[branch[edge + 1]];
  }

  const Skeleton& m_skeleton;
  const Body& m_body;
  double m_spacing;
  bool m_is_relative;
  std::vector<char> m_is_fixed;
  std::vector<Index> m_heir;
  std::vector<std::array<Index, 2>> m_ends; ///< of all branches, in order
  Skeleton m_result;
  std::vector<Index> m_old_node;
};

/// Applies one operation after the other to a skeleton.
class Skeleton_simplification
{
public:
  Skeleton_simplification(Skeleton&& skeleton, const Triangulated_solid* solid)
      : m_skeleton(std::move(skeleton)), m_body(solid), m_origin(m_skeleton.number_of_nodes())
  {
    std::iota(m_origin.begin(), m_origin.end(), Index(0));
    m_heir = m_origin;
    m_skeleton.is_joined.resize(m_skeleton.edges.size(), 0);
  }

  /// Removes components of less than `least` vertices, but the largest.
  void remove_small_components(std::size_t least, const std::vector<std::size_t>& number_of_vertices)
  {
    const bool has_vertices =
        std::any_of(number_of_vertices.begin(), number_of_vertices.end(), [](std::size_t n) { return n > 0; });
    std::vector<Index> component = components();
    std::vector<std::size_t> size(component.size(), 0);
    for (Index v = 0; v < component.size(); ++v) {
      size[component[v]] += has_vertices ? number_of_vertices[v] : 1;
    }
    const std::size_t largest = size.empty() ? 0 : *std::max_element(size.begin(), size.end());
    std::vector<Index> heir(component.size());
    for (Index v = 0; v < heir.size(); ++v) {
      const bool is_kept = size[component[v]] >= std::min(least, largest);
      heir[v] = is_kept ? v : no_index;
      if (!is_kept) {
        m_report.number_of_removed_components += component[v] == v ? 1 : 0;
        m_report.number_of_removed_vertices += number_of_vertices[v];
      }
    }
    keep(heir, std::vector<char>(m_skeleton.edges.size(), 1));
  }

  /// Cuts limbs of which the measure is below `threshold`. Their vertices go to the nodes where they are cut.
  void prune(Branch_measure measure, double threshold)
  {
    const Branch_levels limbs = branch_levels(m_skeleton, measure);
    std::vector<char> is_kept(m_skeleton.edges.size());
    std::vector<char> is_node_kept(m_skeleton.number_of_nodes(), 0);
    std::vector<char> has_edge(m_skeleton.number_of_nodes(), 0);
    for (Index e = 0; e < is_kept.size(); ++e) {
      is_kept[e] = limbs.levels[e] >= threshold || limbs.is_last[e] != 0 ? 1 : 0;
      for (const Index v : m_skeleton.edges[e]) {
        has_edge[v] = 1;
        is_node_kept[v] = is_node_kept[v] != 0 || is_kept[e] != 0 ? 1 : 0;
      }
    }
    std::vector<Index> heir(m_skeleton.number_of_nodes(), no_index);
    std::vector<Index> open;
    for (Index v = 0; v < heir.size(); ++v) {
      if (is_node_kept[v] != 0 || has_edge[v] == 0) {
        heir[v] = v;
        open.push_back(v);
      }
    }
    const std::vector<std::vector<Index>> neighbors = node_neighbors(m_skeleton);
    while (!open.empty()) { // what is cut off a node is a tree, which only one node can be reached from
      const Index v = open.back();
      open.pop_back();
      for (const Index w : neighbors[v]) {
        if (heir[w] == no_index) {
          heir[w] = heir[v];
          open.push_back(w);
        }
      }
    }
    const std::size_t before = m_skeleton.number_of_nodes();
    keep(heir, is_kept);
    m_report.number_of_removed_nodes += before - m_skeleton.number_of_nodes();
  }

  /// Merges branches between junctions that are shorter than `threshold` times the mean of the radii there.
  void merge_junctions(double threshold)
  {
    while (merge_some_junctions(threshold)) {
    }
  }

  /// Joins components by straight edges, those of the minimum spanning tree of the components, by Prim's algorithm from
  /// the largest on: O(e n) for n nodes and e ends.
  /// \throw Input_error if there are too many nodes
  void join_components();

  /// Replaces the nodes of branches by evenly spaced ones.
  /// \param is_relative whether the spacing is in radii
  void resample(double spacing, bool is_relative);

  /// Moves the nodes of degree 2 halfway to the middle of their neighbors.
  void smooth(std::size_t number_of_steps);

  Simplified_skeleton release()
  {
    m_report.number_of_nodes = m_skeleton.number_of_nodes();
    m_report.number_of_edges = m_skeleton.edges.size();
    const Skeleton_counts counts = count_skeleton(m_skeleton);
    m_report.number_of_components = counts.number_of_components;
    m_report.betti_number = counts.betti_number;
    m_report.number_of_tips = counts.number_of_tips;
    m_report.number_of_junctions = counts.number_of_junctions;
    return {std::move(m_skeleton), std::move(m_origin), std::move(m_heir), m_report};
  }

private:
  using Branch = std::vector<Index>;

  /// A place on a branch.
  struct Branch_point
  {
    Vector_3 point = Vector_3::Zero();
    double radius = 0;
  };

  double radius(Index v) const { return m_skeleton.has_radii() ? m_skeleton.radii[v] : 0; }
  double distance(Index v, Index w) const { return (m_skeleton.points[w] - m_skeleton.points[v]).norm(); }

  double length(const Branch& branch) const
  {
    double result = 0;
    for (std::size_t i = 1; i < branch.size(); ++i) {
      result += distance(branch[i - 1], branch[i]);
    }
    return result;
  }

  std::vector<Index> numbers() const
  {
    std::vector<Index> result(m_skeleton.number_of_nodes());
    std::iota(result.begin(), result.end(), Index(0));
    return result;
  }

  /// For each node one of its component, always the same.
  std::vector<Index> components() const
  {
    Disjoint_sets sets(m_skeleton.number_of_nodes());
    for (const auto& [a, b] : m_skeleton.edges) {
      sets.join(a, b);
    }
    std::vector<Index> result = numbers();
    for (Index& v : result) {
      v = sets.find(v);
    }
    return result;
  }

  /// For each node whether edges that join components begin there: tips and isolated nodes, and all nodes of components
  /// that have none.
  std::vector<char> ends_of_components(const std::vector<Index>& component) const
  {
    const std::vector<std::vector<Index>> neighbors = node_neighbors(m_skeleton);
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

  /// A straight edge that could join two components; the first is the better one.
  struct Joint
  {
    double squared_distance = std::numeric_limits<double>::infinity();
    Index from = no_index;
    Index to = no_index;
  };

  /// By length; of equal ones by position, so that the numbering does not matter.
  bool is_before(const Joint& a, const Joint& b) const
  {
    if (a.from == no_index || b.from == no_index) {
      return a.from != no_index; // also where squares overflow
    }
    if (a.squared_distance != b.squared_distance) {
      return a.squared_distance < b.squared_distance;
    }
    const auto key = [this](const Joint& joint) {
      const auto position = [this](Index v) {
        const Vector_3& p = m_skeleton.points[v];
        return std::make_tuple(p.x(), p.y(), p.z(), v);
      };
      return std::minmax({position(joint.from), position(joint.to)});
    };
    return key(a) < key(b);
  }

  /// Keeps the nodes that are their own heirs, and the edges of `is_kept` between such.
  /// \param heir of each node, which is kept; or `no_index`
  void keep(const std::vector<Index>& heir, const std::vector<char>& is_kept)
  {
    std::vector<Index> number(heir.size(), no_index);
    Skeleton result;
    std::vector<Index> origin;
    for (Index v = 0; v < heir.size(); ++v) {
      if (heir[v] == v) {
        number[v] = Index(result.points.size());
        result.points.push_back(m_skeleton.points[v]);
        if (m_skeleton.has_radii()) {
          result.radii.push_back(m_skeleton.radii[v]);
        }
        origin.push_back(m_origin[v]);
      }
    }
    for (std::size_t e = 0; e < m_skeleton.edges.size(); ++e) {
      const auto& [a, b] = m_skeleton.edges[e];
      if (is_kept[e] != 0 && number[a] != no_index && number[b] != no_index) {
        result.edges.push_back({number[a], number[b]});
        result.is_joined.push_back(m_skeleton.is_joined[e]);
      }
    }
    for (Index& v : m_heir) {
      v = v == no_index || heir[v] == no_index ? no_index : number[heir[v]];
    }
    m_skeleton = std::move(result);
    m_origin = std::move(origin);
  }

  bool is_inside(Index a, Index b) const { return m_body.holds(m_skeleton.points[a], m_skeleton.points[b]); }

  bool merge_some_junctions(double threshold);
  std::vector<Branch> short_branches(double threshold, const std::vector<std::vector<Index>>& neighbors) const;
  void redirect_edges(const std::vector<Index>& heir);
  bool can_merge(const Branch& branch, const std::vector<std::vector<Index>>& neighbors) const;
  bool stays_inside(const Branch& branch, const std::vector<std::vector<Index>>& neighbors,
                    const Branch_point& place) const;
  Branch_point point_on_branch(const Branch& branch, double place) const;

  Skeleton m_skeleton;
  Body m_body;
  std::vector<Index> m_origin;
  std::vector<Index> m_heir;
  Simplification_report m_report;
};

void Skeleton_simplification::join_components()
{
  const std::vector<Index> component = components();
  const std::vector<char> is_end = ends_of_components(component);
  std::vector<std::vector<Index>> members(component.size()); // of each component, at the node that stands for it
  for (Index v = 0; v < component.size(); ++v) {
    members[component[v]].push_back(v);
  }
  std::vector<Index> open; // components that are not joined yet
  for (Index c = 0; c < component.size(); ++c) {
    if (!members[c].empty()) {
      open.push_back(c);
    }
  }
  if (open.size() < 2) {
    return;
  }
  auto next = std::max_element(open.begin(), open.end(),
                               [&](Index a, Index b) { return members[a].size() < members[b].size(); });
  std::vector<Joint> best(component.size()); // from what is joined to each open component
  for (double number_of_pairs = 0; !open.empty();) {
    const Index joined = *next;
    open.erase(next);
    if (best[joined].from != no_index) {
      m_skeleton.edges.push_back({best[joined].from, best[joined].to});
      m_skeleton.is_joined.push_back(1);
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
            const Joint joint{(m_skeleton.points[v] - m_skeleton.points[w]).squaredNorm(), v, w};
            best[c] = is_before(joint, best[c]) ? joint : best[c];
          }
        }
      }
    }
    next = std::min_element(open.begin(), open.end(), [&](Index a, Index b) { return is_before(best[a], best[b]); });
  }
}

/// The point of the branch at this length from its begin.
Skeleton_simplification::Branch_point Skeleton_simplification::point_on_branch(const Branch& branch, double place) const
{
  for (std::size_t i = 1; i < branch.size(); ++i) {
    const double edge = distance(branch[i - 1], branch[i]);
    if (place <= edge && edge > 0) {
      const double t = place / edge;
      return {(1 - t) * m_skeleton.points[branch[i - 1]] + t * m_skeleton.points[branch[i]],
              (1 - t) * radius(branch[i - 1]) + t * radius(branch[i])};
    }
    place -= edge;
  }
  return {m_skeleton.points[branch.back()], radius(branch.back())};
}

/// Whether the ends of the branch can become one node without edges that are loops or parallel.
bool Skeleton_simplification::can_merge(const Branch& branch, const std::vector<std::vector<Index>>& neighbors) const
{
  std::vector<Index> around;
  for (const auto& [end, next] :
       {std::pair(branch.front(), branch[1]), std::pair(branch.back(), branch[branch.size() - 2])}) {
    const auto own = std::find(neighbors[end].begin(), neighbors[end].end(), next) - neighbors[end].begin();
    for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(neighbors[end].size()); ++i) {
      if (i != own) {
        around.push_back(neighbors[end][std::size_t(i)]);
      }
    }
  }
  around.push_back(branch.front());
  around.push_back(branch.back());
  std::sort(around.begin(), around.end());
  return std::adjacent_find(around.begin(), around.end()) == around.end();
}

/// Whether the edges at the ends of the branch that are inside the body are so if the ends move to `place`.
bool Skeleton_simplification::stays_inside(const Branch& branch, const std::vector<std::vector<Index>>& neighbors,
                                           const Branch_point& place) const
{
  for (const auto& [end, next] :
       {std::pair(branch.front(), branch[1]), std::pair(branch.back(), branch[branch.size() - 2])}) {
    for (const Index neighbor : neighbors[end]) {
      if (neighbor != next && is_inside(end, neighbor) && !m_body.holds(place.point, m_skeleton.points[neighbor])) {
        return false;
      }
    }
  }
  return true;
}

/// The branches between junctions that are shorter than `threshold` radii and can be merged, shortest first.
std::vector<Skeleton_simplification::Branch>
Skeleton_simplification::short_branches(double threshold, const std::vector<std::vector<Index>>& neighbors) const
{
  std::vector<char> is_at_joint(m_skeleton.number_of_nodes(), 0);
  for (std::size_t e = 0; e < m_skeleton.edges.size(); ++e) {
    for (const Index v : m_skeleton.edges[e]) {
      is_at_joint[v] = is_at_joint[v] != 0 || m_skeleton.is_joined[e] != 0 ? 1 : 0;
    }
  }
  // By length in radii; of equal ones by position, so that the numbering does not matter.
  std::vector<std::tuple<double, double, double, double, Branch>> found;
  for (const Branch& branch : split_into_branches(neighbors)) {
    const Index a = branch.front();
    const Index b = branch.back();
    const double total = length(branch);
    const double mean_radius = (radius(a) + radius(b)) / 2;
    if (a != b && neighbors[a].size() > 2 && neighbors[b].size() > 2 && total < threshold * mean_radius &&
        std::none_of(branch.begin(), branch.end(), [&](Index v) { return is_at_joint[v] != 0; }) &&
        can_merge(branch, neighbors)) {
      const Vector_3 middle = point_on_branch(branch, total / 2).point;
      found.emplace_back(total / mean_radius, middle.x(), middle.y(), middle.z(), branch);
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<Branch> result;
  result.reserve(found.size());
  for (auto& one : found) {
    result.push_back(std::move(std::get<Branch>(one)));
  }
  return result;
}

/// Merges short branches, shortest first, that do not touch each other. \return whether there were any
bool Skeleton_simplification::merge_some_junctions(double threshold)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(m_skeleton);
  std::vector<char> is_touched(m_skeleton.number_of_nodes(), 0);
  std::vector<Index> heir = numbers();
  bool is_merged = false;
  for (const Branch& branch : short_branches(threshold, neighbors)) {
    Branch around = branch;
    around.insert(around.end(), neighbors[branch.front()].begin(), neighbors[branch.front()].end());
    around.insert(around.end(), neighbors[branch.back()].begin(), neighbors[branch.back()].end());
    const Branch_point middle = point_on_branch(branch, length(branch) / 2);
    if (std::any_of(around.begin(), around.end(), [&](Index v) { return is_touched[v] != 0; }) ||
        (m_body.is_known() && !stays_inside(branch, neighbors, middle))) {
      continue;
    }
    for (const Index v : around) {
      is_touched[v] = 1;
    }
    const Index into = radius(branch.front()) >= radius(branch.back()) ? branch.front() : branch.back();
    for (const Index v : branch) {
      heir[v] = into;
    }
    m_skeleton.points[into] = middle.point;
    if (m_skeleton.has_radii()) {
      m_skeleton.radii[into] = middle.radius;
    }
    ++m_report.number_of_merged_branches;
    is_merged = true;
  }
  redirect_edges(heir);
  return is_merged;
}

/// Leads the edges of nodes to their heirs, and drops those between nodes that have become one.
void Skeleton_simplification::redirect_edges(const std::vector<Index>& heir)
{
  std::vector<char> is_kept;
  for (auto& [a, b] : m_skeleton.edges) {
    is_kept.push_back(heir[a] != heir[b] || a == b ? 1 : 0);
    a = heir[a];
    b = heir[b];
  }
  keep(heir, is_kept);
}

void Skeleton_simplification::resample(double spacing, bool is_relative)
{
  Branch_resampling resampling(m_skeleton, m_body, spacing, is_relative);
  resampling();
  for (Index& v : m_heir) {
    v = v == no_index ? no_index : resampling.heirs()[v];
  }
  std::vector<Index> origin;
  for (const Index v : resampling.old_nodes()) {
    origin.push_back(v == no_index ? no_index : m_origin[v]);
  }
  m_origin = std::move(origin);
  m_skeleton = Skeleton(resampling.result());
}

void Skeleton_simplification::smooth(std::size_t number_of_steps)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(m_skeleton);
  std::vector<std::array<Index, 2>> guarded;
  if (m_body.is_known()) {
    std::copy_if(m_skeleton.edges.begin(), m_skeleton.edges.end(), std::back_inserter(guarded),
                 [this](const std::array<Index, 2>& edge) { return is_inside(edge[0], edge[1]); });
  }
  for (std::size_t step = 0; step < number_of_steps; ++step) {
    const std::vector<Vector_3> before = m_skeleton.points;
    for (Index v = 0; v < neighbors.size(); ++v) {
      if (neighbors[v].size() == 2) {
        m_skeleton.points[v] = before[v] / 2 + (before[neighbors[v][0]] + before[neighbors[v][1]]) / 4;
      }
    }
    // Nodes of edges that leave the body go back, until no further edge does.
    for (bool is_settled = false; !is_settled;) {
      is_settled = true;
      for (const auto& [a, b] : guarded) {
        const bool is_moved = m_skeleton.points[a] != before[a] || m_skeleton.points[b] != before[b];
        if (is_moved && !is_inside(a, b)) {
          m_skeleton.points[a] = before[a];
          m_skeleton.points[b] = before[b];
          is_settled = false;
        }
      }
    }
  }
}

/// \throw Input_error if a number is not finite or negative
void check_simplification(const Skeleton& skeleton, const Simplification_parameters& parameters)
{
  const auto is_length = [](double value) { return value >= 0 && value <= std::numeric_limits<double>::max(); };
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    if (!skeleton.points[v].allFinite()) {
      throw Input_error("node " + std::to_string(v) +
                        " of the skeleton has a coordinate that is not finite: correct it or remove the node");
    }
    if (skeleton.has_radii() && !is_length(skeleton.radii[v])) {
      throw Input_error("node " + std::to_string(v) +
                        " of the skeleton has a radius that is negative or not finite: correct it");
    }
  }
  for (const auto& [name, value] :
       {std::pair("minimum_significance", parameters.min_significance),
        std::pair("minimum_branch_length", parameters.min_length),
        std::pair("minimum_length_over_radius", parameters.min_length_over_radius),
        std::pair("junction_distance", parameters.junction_distance), std::pair("spacing", parameters.spacing),
        std::pair("spacing_over_radius", parameters.spacing_over_radius)}) {
    if (!is_length(value)) {
      throw Input_error(std::string(name) + " is negative or not finite: choose a number that is at least 0");
    }
  }
  if (parameters.spacing > 0 && parameters.spacing_over_radius > 0) {
    throw Input_error("spacing and spacing_over_radius cannot both be followed: leave one out");
  }
  const bool needs_radii = parameters.min_significance > 0 || parameters.min_length_over_radius > 0 ||
                           parameters.junction_distance > 0 || parameters.spacing_over_radius > 0;
  if (needs_radii && skeleton.number_of_nodes() > 0 &&
      std::none_of(skeleton.radii.begin(), skeleton.radii.end(), [](double radius) { return radius > 0; })) {
    throw Input_error("the skeleton has no radii, in which significance and relative lengths are measured: use lengths "
                      "in the unit of the skeleton, or one that has radii");
  }
}

} // namespace

Simplified_skeleton simplify_skeleton(Skeleton&& skeleton, const std::vector<std::size_t>& number_of_vertices,
                                      const Simplification_parameters& parameters, const Triangulated_solid* solid)
{
  check_simplification(skeleton, parameters);
  Skeleton_simplification simplification(std::move(skeleton), solid);
  if (parameters.min_component_size > 0) {
    simplification.remove_small_components(parameters.min_component_size, number_of_vertices);
  }
  for (const auto& [measure, threshold] :
       {std::pair(Branch_measure::significance, parameters.min_significance),
        std::pair(Branch_measure::length, parameters.min_length),
        std::pair(Branch_measure::length_over_radius, parameters.min_length_over_radius)}) {
    if (threshold > 0) {
      simplification.prune(measure, threshold);
    }
  }
  if (parameters.junction_distance > 0) {
    simplification.merge_junctions(parameters.junction_distance);
  }
  if (parameters.joins_components) {
    simplification.join_components();
  }
  if (parameters.spacing > 0 || parameters.spacing_over_radius > 0) {
    simplification.resample(std::max(parameters.spacing, parameters.spacing_over_radius),
                            parameters.spacing_over_radius > 0);
  }
  simplification.smooth(parameters.number_of_smoothing_steps);
  return simplification.release();
}

} // namespace CSCD::internal
