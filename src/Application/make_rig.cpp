// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places joints, and finds which of them move a vertex.

#include <CSCD/Application/make_rig.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

namespace {

/// Chooses the nodes of a rooted skeleton that get joints.
class Joint_placement
{
public:
  /// \param size of the body: the largest side of its box
  Joint_placement(const Skeleton& skeleton, const Rooted_forest& forest, double size)
      : m_skeleton(skeleton), m_spacing(relative_spacing * size), m_children(skeleton.number_of_nodes()),
        m_is_joint(skeleton.number_of_nodes(), 0)
  {
    for (const Index node : forest.order()) {
      if (!forest.is_root(node)) {
        m_children[forest.parent(node)].push_back(node);
      }
    }
    for (const Index node : forest.order()) {
      m_is_joint[node] = char(is_end(forest, node));
    }
    for (const Index node : forest.order()) {
      if (is_end(forest, node)) {
        for (const Index child : m_children[node]) {
          place_along(chain_from(node, child));
        }
      }
    }
  }

  bool is_joint(Index node) const { return m_is_joint[node] != 0; }
  bool is_leaf(Index node) const { return m_children[node].empty(); }
  const std::vector<Index>& children(Index node) const { return m_children[node]; }

private:
  using Chain = std::vector<Index>;

  /// The distance of joints along a limb, relative to the size of the body, ...
  static constexpr double relative_spacing = 0.06;
  /// ... and the number of parts of a limb. Both are near those of artists on 57 animals, people and machines.
  static constexpr double max_number_of_parts = 6;
  /// Where the first joint of a limb is, in radii of the junction that the limb begins at.
  static constexpr double start_over_radius = 0.5;

  /// Whether chains begin or end at `node`.
  bool is_end(const Rooted_forest& forest, Index node) const
  {
    return forest.is_root(node) || m_children[node].size() != 1;
  }

  Chain chain_from(Index end, Index child) const
  {
    Chain chain{end, child};
    while (m_children[chain.back()].size() == 1) {
      chain.push_back(m_children[chain.back()].front());
    }
    return chain;
  }

  /// How far the joints of a limb stay from its end `node`.
  double margin(Index node) const
  {
    return m_children[node].size() > 1 ? start_over_radius * m_skeleton.radii[node] : 0;
  }

  /// Places joints at even distances along `chain`, at its inner nodes.
  void place_along(const Chain& chain)
  {
    std::vector<double> distance{0};
    for (std::size_t i = 1; i < chain.size(); ++i) {
      distance.push_back(distance.back() + m_skeleton.length({chain[i - 1], chain[i]}));
    }
    const double first = margin(chain.front());
    const double length = distance.back() - margin(chain.back()) - first;
    const double number_of_parts = std::clamp(std::round(length / m_spacing), 1., max_number_of_parts);
    for (int part = first > 0 ? 0 : 1; part < number_of_parts; ++part) {
      const double place = first + part / number_of_parts * length;
      const auto next = std::lower_bound(distance.begin() + 1, distance.end() - 1, place);
      m_is_joint[chain[std::size_t(next - distance.begin())]] = 1;
    }
  }

  const Skeleton& m_skeleton;
  double m_spacing;
  std::vector<std::vector<Index>> m_children;
  std::vector<char> m_is_joint;
};

/// Numbers joints, and finds how strongly they move points of a place on the skeleton.
class Joint_weights
{
public:
  Joint_weights(const Skeleton& skeleton, Index root, double size, const std::vector<Index>& branch_of_node)
      : m_skeleton(skeleton), m_forest(skeleton, {root}), m_placement(skeleton, m_forest, size)
  {
    number_joints(branch_of_node);
    find_next_joints();
    find_zones();
  }

  const std::vector<Rig_joint>& joints() const { return m_joints; }

  /// \param node the node of `point`
  Rig::Influences operator()(Index node, const Vector3& point) const
  {
    Index target = no_index; // the target of the nearest edge; its parent is the source
    double least = 0;
    const auto look_at = [&](Index child) {
      const double distance =
          distance_to_segment(point, m_skeleton.points[m_forest.parent(child)], m_skeleton.points[child]);
      if (target == no_index || distance < least) {
        least = distance;
        target = child;
      }
    };
    if (!m_forest.is_root(node)) {
      look_at(node);
    }
    for (const Index child : m_placement.children(node)) {
      look_at(child);
    }
    return target == no_index ? Rig::Influences{{{m_owner[node], 1.}}} : influences_on(target, point);
  }

private:
  void number_joints(const std::vector<Index>& branch_of_node)
  {
    m_owner.assign(m_skeleton.number_of_nodes(), no_index);
    m_distance.assign(m_skeleton.number_of_nodes(), 0);
    for (const Index node : m_forest.order()) {
      const bool is_root = m_forest.is_root(node);
      const Index parent = m_forest.parent(node);
      m_owner[node] = m_owner[parent];
      m_distance[node] = is_root ? 0 : m_distance[parent] + m_skeleton.length({parent, node});
      if (m_placement.is_joint(node)) {
        Rig_joint joint{{}, node, branch_of_node[node], m_skeleton.points[node], m_skeleton.radii[node], false};
        joint.is_tip = !is_root && m_placement.is_leaf(node);
        if (!is_root) {
          joint.parent = m_owner[parent];
        }
        if (!joint.is_tip) {
          m_owner[node] = Index(m_joints.size());
        }
        m_joints.push_back(joint);
      }
    }
  }

  void find_next_joints()
  {
    m_next.assign(m_skeleton.number_of_nodes(), no_index);
    for (std::size_t j = 0; j < m_joints.size(); ++j) {
      m_next[m_joints[j].node] = Index(j);
    }
    for (auto node = m_forest.order().rbegin(); node != m_forest.order().rend(); ++node) {
      m_next[*node] = m_placement.is_joint(*node) ? m_next[*node] : m_next[m_placement.children(*node).front()];
    }
  }

  /// A zone around a joint ends halfway to the next joint, so that zones do not overlap.
  void find_zones()
  {
    m_zone.reserve(m_joints.size());
    for (const Rig_joint& joint : m_joints) {
      m_zone.push_back(joint.radius);
    }
    for (std::size_t j = 0; j < m_joints.size(); ++j) {
      if (const std::optional<std::size_t> parent = m_joints[j].parent) {
        const double half = (m_distance[m_joints[j].node] - m_distance[m_joints[*parent].node]) / 2;
        m_zone[j] = std::min(m_zone[j], half);
        m_zone[*parent] = std::min(m_zone[*parent], half);
      }
    }
  }

  /// How much a joint has of its full influence.
  /// \param distance behind the joint along the skeleton; negative before it
  double share(std::size_t joint, double distance) const
  {
    const double zone = m_zone[joint];
    if (!(std::abs(distance) < zone)) {
      return distance < 0 ? 0 : 1;
    }
    const double t = (1 + distance / zone) / 2;
    return t * t * (3 - 2 * t);
  }

  /// The influences at the place of the edge to `target` that is nearest to `point`.
  Rig::Influences influences_on(Index target, const Vector3& point) const
  {
    const Index source = m_forest.parent(target);
    const Vector3 along = m_skeleton.points[target] - m_skeleton.points[source];
    const double length = along.norm();
    const double behind_source =
        length > 0 ? std::clamp((point - m_skeleton.points[source]).dot(along) / length, 0., length) : 0;
    const double place = m_distance[source] + behind_source;
    const Index before = m_owner[source];
    const Index behind = m_next[target];
    const double behind_share = m_joints[behind].is_tip ? 0 : share(behind, place - m_distance[m_joints[behind].node]);
    const std::optional<std::size_t> parent = m_joints[before].parent;
    const double parent_share = parent ? 1 - share(before, place - m_distance[m_joints[before].node]) : 0;
    Rig::Influences result{{{before, 1 - behind_share - parent_share}}};
    if (behind_share > 0) {
      result[1] = {behind, behind_share};
    } else if (parent_share > 0) {
      result[1] = {Index(*parent), parent_share};
    }
    return result;
  }

  const Skeleton& m_skeleton;
  Rooted_forest m_forest;
  Joint_placement m_placement;
  std::vector<Rig_joint> m_joints;
  std::vector<Index> m_owner;     ///< of each node, the last joint at or before it that is not a tip
  std::vector<Index> m_next;      ///< of each node, the first joint at or behind it
  std::vector<double> m_distance; ///< of each node from its root along the skeleton
  std::vector<double> m_zone;     ///< how far from each joint the weights go over
};

/// Adds influences times `factor` to the sums of the joints.
void add_influences(const Rig::Influences& influences, double factor, std::vector<Rig_influence>& sums)
{
  for (const Rig_influence& influence : influences) {
    if (influence.weight > 0) {
      const auto place = std::find_if(sums.begin(), sums.end(),
                                      [&](const Rig_influence& other) { return other.joint == influence.joint; });
      if (place == sums.end()) {
        sums.push_back({influence.joint, factor * influence.weight});
      } else {
        place->weight += factor * influence.weight;
      }
    }
  }
}

/// The strongest of the sums, whose weights then have the sum 1.
Rig::Influences strongest(std::vector<Rig_influence>& sums)
{
  constexpr double negligible = 1e-3; // moves a vertex by less than one sees
  std::sort(sums.begin(), sums.end(), [](const Rig_influence& a, const Rig_influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  Rig::Influences result{};
  double sum = 0;
  for (std::size_t i = 0; i < std::min(sums.size(), result.size()); ++i) {
    if (i == 0 || sums[i].weight > negligible) {
      result[i] = sums[i];
      sum += sums[i].weight;
    }
  }
  for (Rig_influence& influence : result) {
    influence.weight /= sum;
  }
  return result;
}

/// How often influences have to be averaged to spread by `distance`. Averaging with the neighbors at the distance of an
/// edge, with half of the weight on the vertex itself, spreads by the square root of half an edge's square.
int number_of_averagings(const Assigned_surface& surface, double distance)
{
  constexpr int min_number = 2;
  constexpr int max_number = 64; // bounds the time on fine meshes
  double sum = 0;
  for (const std::array<Index, 3>& triangle : surface.triangles) {
    sum += (surface.points[triangle[1]] - surface.points[triangle[0]]).norm();
  }
  const double ratio = sum > 0 ? distance * double(surface.triangles.size()) / sum : 0; // in edges
  return int(std::clamp(std::ceil(2 * ratio * ratio), double(min_number), double(max_number)));
}

/// Averages influences over neighboring vertices until they have spread by `distance`.
void smooth(const Assigned_surface& surface, double distance, std::vector<Rig::Influences>& influences)
{
  const Compressed_rows<Index, std::size_t> neighbors(surface.points.size(), [&surface](const auto& use) {
    for (const std::array<Index, 3>& triangle : surface.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        use(triangle[i], triangle[(i + 1) % 3]);
        use(triangle[(i + 1) % 3], triangle[i]);
      }
    }
  });
  std::vector<Rig_influence> sums;
  for (int step = number_of_averagings(surface, distance); step > 0; --step) {
    const std::vector<Rig::Influences> old = influences;
    for (std::size_t v = 0; v < influences.size(); ++v) {
      const auto around = neighbors[v];
      if (!around.empty()) {
        sums.clear();
        add_influences(old[v], 0.5, sums);
        for (const Index neighbor : around) {
          add_influences(old[neighbor], 0.5 / double(around.size()), sums);
        }
        influences[v] = strongest(sums);
      }
    }
  }
}

/// `skeleton` in one piece, with the same nodes.
Skeleton join_components(const Skeleton& skeleton)
{
  Simplification_parameters parameters;
  parameters.joins_components = true;
  return simplify_skeleton(Skeleton(skeleton), {}, parameters, nullptr).skeleton;
}

/// The largest side of the box of `points`.
double size_of(const std::vector<Vector3>& points)
{
  Bounding_box box;
  for (const Vector3& point : points) {
    box.extend(point);
  }
  return (box.max() - box.min()).maxCoeff();
}

} // namespace

Rig make_rig(const Skeleton& parts, const Assigned_surface& surface, std::optional<Index> root)
{
  CGAL_precondition(parts.number_of_nodes() > 0 && parts.has_radii());
  constexpr double spread = 0.25; // in mean radii: seams vanish, and weights keep to their limbs
  const Skeleton skeleton = join_components(parts);
  const Joint_weights weights(skeleton, root.value_or(find_roots(skeleton, Root_rule::thickest).front()),
                              size_of(surface.points), measure_branches(parts).branch_of_node);
  Rig rig{weights.joints(), {}};
  rig.influences.reserve(surface.points.size());
  double sum_of_radii = 0;
  std::size_t number_of_vertices = 0;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const Index node = surface.node_of_vertex[v];
    if (node == no_index) {
      rig.influences.push_back({{{0, 1.}}}); // weights of vertices without a face have the sum 1, too
    } else {
      rig.influences.push_back(weights(node, surface.points[v]));
      sum_of_radii += skeleton.radii[node];
      ++number_of_vertices;
    }
  }
  smooth(surface, number_of_vertices > 0 ? spread * sum_of_radii / double(number_of_vertices) : 0, rig.influences);
  return rig;
}

} // namespace CSCD::internal
