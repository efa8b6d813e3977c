// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places joints, and finds which of them move a vertex.

#include "Measure/skeleton_tools.h"
#include <CSCD/Application/make_rig.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/principal_axes.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// What joints are placed on, and the node of each vertex.
struct Rig_axis
{
  Skeleton skeleton; ///< in one piece
  std::vector<Index> node_of_vertex;
  std::vector<Index> branch_of_node; ///< `no_index` along a spine
  std::vector<char> is_carried;      ///< of each node, whether it is in a part that gets no joints
  Index root = no_index;
};

/// Chooses the nodes of a rooted skeleton that get joints, numbers these, and finds how strongly they move points of a
/// place on the skeleton.
class Joint_weights
{
public:
  /// \param size of the body: the largest side of its box
  Joint_weights(const Rig_axis& axis, double size)
      : m_skeleton(axis.skeleton), m_forest(axis.skeleton, {axis.root}), m_spacing(relative_spacing * size),
        m_children(m_skeleton.number_of_nodes()), m_is_joint(m_skeleton.number_of_nodes(), 0),
        m_heir(m_skeleton.number_of_nodes(), no_index), m_owner(m_skeleton.number_of_nodes(), no_index),
        m_next(m_skeleton.number_of_nodes(), no_index), m_distance(m_skeleton.number_of_nodes(), 0)
  {
    place_joints(axis.is_carried);
    number_joints(axis.branch_of_node);
  }

  const std::vector<Rig_joint>& joints() const { return m_joints; }

  /// \param node the node of `point`
  Rig::Influences operator()(Index node, const Vector3& point) const
  {
    node = m_heir[node];
    std::vector<Index> targets = m_children[node]; // of the edges at the node; the parent of each is the source
    if (!m_forest.is_root(node)) {
      targets.insert(targets.begin(), node);
    }
    if (targets.empty()) {
      return {{{m_owner[node], 1.}}};
    }
    const auto distance = [&](Index target) {
      return distance_to_segment(point, m_skeleton.points[m_forest.parent(target)], m_skeleton.points[target]);
    };
    return influences_on(
        *std::min_element(targets.begin(), targets.end(), [&](Index a, Index b) { return distance(a) < distance(b); }),
        point);
  }

private:
  using Chain = std::vector<Index>;

  /// The distance of joints along a limb, relative to the size of the body, ...
  static constexpr double relative_spacing = 0.06;
  /// ... and the number of parts of a limb. Both are near those of artists on 57 animals, people and machines.
  static constexpr double max_number_of_parts = 6;
  /// Where the first joint of a limb is, in radii of the junction that the limb begins at.
  static constexpr double start_over_radius = 0.25;
  /// A node that is nearer to a joint's place, relative to the length of the limb, is at it.
  static constexpr double rounding = 1e-9;

  void place_joints(const std::vector<char>& is_carried)
  {
    for (auto node = m_forest.order().rbegin(); node != m_forest.order().rend(); ++node) {
      if (m_forest.is_root(*node) || is_carried[*node] == 0 || !m_children[*node].empty()) {
        m_heir[*node] = *node;
        if (!m_forest.is_root(*node)) {
          m_children[m_forest.parent(*node)].push_back(*node);
        }
      }
    }
    for (const Index node : m_forest.order()) {
      std::reverse(m_children[node].begin(), m_children[node].end());
      if (m_heir[node] == no_index) {
        m_heir[node] = m_heir[m_forest.parent(node)];
      } else if (m_forest.is_root(node) || m_children[node].size() != 1) { // chains begin or end there
        m_is_joint[node] = 1;
        for (const Index child : m_children[node]) {
          place_along(chain_from(node, child));
        }
      }
    }
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
      const double place = first + (part / number_of_parts - rounding) * length;
      const auto next = std::lower_bound(distance.begin() + 1, distance.end() - 1, place);
      m_is_joint[chain[std::size_t(next - distance.begin())]] = 1;
    }
  }

  /// A zone around a joint ends halfway to the next joint, so that zones do not overlap.
  void number_joints(const std::vector<Index>& branch_of_node)
  {
    for (const Index node : m_forest.order()) {
      const bool is_root = m_forest.is_root(node);
      const Index parent = m_forest.parent(node);
      m_owner[node] = m_owner[parent];
      m_distance[node] = is_root ? 0 : m_distance[parent] + m_skeleton.length({parent, node});
      if (m_is_joint[node] == 0) {
        continue;
      }
      m_next[node] = Index(m_joints.size());
      Rig_joint joint{{}, node, branch_of_node[node], m_skeleton.points[node], m_skeleton.radii[node], false};
      joint.is_tip = !is_root && m_children[node].empty();
      m_zone.push_back(joint.radius);
      if (!is_root) {
        const Index before = m_owner[parent];
        const double half = (m_distance[node] - m_distance[m_joints[before].node]) / 2;
        m_zone.back() = std::min(m_zone.back(), half);
        m_zone[before] = std::min(m_zone[before], half);
        joint.parent = before;
      }
      m_owner[node] = joint.is_tip ? m_owner[node] : m_next[node];
      m_joints.push_back(joint);
    }
    for (auto node = m_forest.order().rbegin(); node != m_forest.order().rend(); ++node) {
      if (m_heir[*node] == *node && m_is_joint[*node] == 0) {
        m_next[*node] = m_next[m_children[*node].front()];
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
    const double share_of_edge = nearest_parameter(point, m_skeleton.points[source], m_skeleton.points[target]);
    const double place = m_distance[source] + share_of_edge * m_skeleton.length({source, target});
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
  double m_spacing;
  std::vector<std::vector<Index>> m_children; ///< without the nodes of parts that get no joints
  std::vector<char> m_is_joint;
  std::vector<Index> m_heir; ///< the node itself or, in a part that gets no joints, the last one before that part
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

/// Integrals over a solid of 1, of the position, and of its square, about some origin.
struct Solid_moments
{
  double volume = 0;
  Vector3 first = Vector3::Zero();
  Moment_matrix second{};

  /// Adds the tetrahedron between the origin and a triangle.
  void add(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double its_volume = a.dot(b.cross(c)) / 6;
    const Vector3 sum = a + b + c;
    volume += its_volume;
    first += its_volume / 4 * sum;
    for (const Vector3& vector : {sum, a, b, c}) {
      second += Moment_matrix::product(its_volume / 20 * vector, vector);
    }
  }

  /// The covariance of the positions in the solid.
  Moment_matrix covariance() const { return (second - Moment_matrix::product(first / volume, first)) / volume; }

  /// The volume over the volume of the ellipsoid that has the same second moments about its center: at most 1.
  double share_of_ellipsoid() const
  {
    constexpr double ball = 4 * boost::math::double_constants::pi / 3; // volume at radius 1, ...
    constexpr double moment = 1. / 5;                                  // ... and mean square of a coordinate
    const Moment_matrix square = covariance() / moment;
    const double determinant = square.columns[0].dot(square.columns[1].cross(square.columns[2]));
    return std::abs(volume) / (ball * std::sqrt(determinant));
  }
};

/// The part that is the body of a fish, the other ones being its fins and eyes: it is compact, not a ball, and most of
/// the volume. No part of other shapes.
/// \param moments of each part
Index find_body_with_fins(const std::vector<Solid_moments>& moments)
{
  constexpr double min_share_of_volume = 0.65;    // fish have 0.66 to 0.98, robots with round bodies up to 0.67
  constexpr double min_share_of_ellipsoid = 0.89; // fish have 0.89 to 0.97, animals with limbs at most 0.85
  constexpr double max_roundness = 0.9;           // the least over the largest extent: fish have 0.34 to 0.86
  const auto volume = [](const Solid_moments& its) { return std::abs(its.volume); };
  const auto body = std::max_element(moments.begin(), moments.end(),
                                     [&](const auto& a, const auto& b) { return volume(a) < volume(b); });
  const double sum = std::accumulate(moments.begin(), moments.end(), 0.,
                                     [&](double before, const auto& its) { return before + volume(its); });
  const double share = volume(*body) / sum;
  if (!(share >= min_share_of_volume && share < 1 && body->share_of_ellipsoid() >= min_share_of_ellipsoid)) {
    return no_index;
  }
  const std::array<double, 3> square = principal_axes(body->covariance()).values; // ascending
  return std::sqrt(square[0] / square[2]) <= max_roundness ? Index(body - moments.begin()) : no_index;
}

/// The spine of a body with fins; nothing of other bodies.
///
/// Its skeleton may lie across, as a fish may be taller than long without its tail. So the spine is straight, through
/// the center of the body, along the principal axis of the body that all parts together are longest along, unless parts
/// stick out at both of its ends, as pairs of fins or arms do. It begins at the end nearer to the center.
std::optional<Rig_axis> find_spine(const Skeleton& parts, const Assigned_surface& surface, std::optional<Index> root)
{
  constexpr double margin = 0.05;       // of the spine at both ends, in lengths of the body
  constexpr double max_overhang = 0.15; // at the end where parts stick out less, in lengths of the body
  constexpr Index number_of_nodes = 7;  // for as many joints as a limb may have
  Index number_of_parts = 0;
  const std::vector<Index> part = Disjoint_sets(parts.number_of_nodes(), parts.edges).numbers(number_of_parts);
  const auto part_of = [&](Index vertex) {
    const Index node = surface.node_of_vertex[vertex];
    return node == no_index ? no_index : part[node];
  };
  std::vector<Solid_moments> moments(number_of_parts);
  const Vector3& origin = parts.points.front();
  for (const auto& [a, b, c] : surface.triangles) {
    if (const Index its_part = part_of(a); its_part != no_index) {
      moments[its_part].add(surface.points[a] - origin, surface.points[b] - origin, surface.points[c] - origin);
    }
  }
  const Index body = find_body_with_fins(moments);
  if (body == no_index) {
    return std::nullopt;
  }

  // The least and the largest coordinate along an axis, of the body or of all parts.
  const auto range = [&](const Vector3& axis, bool is_of_body) {
    std::pair<double, double> result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (Index v = 0; v < surface.points.size(); ++v) {
      if (!is_of_body || part_of(v) == body) {
        result.first = std::min(result.first, axis.dot(surface.points[v]));
        result.second = std::max(result.second, axis.dot(surface.points[v]));
      }
    }
    return result;
  };
  const std::array<Vector3, 3> axes = principal_axes(moments[body].covariance()).vectors;
  const auto extent = [&](const Vector3& axis) {
    const auto [low, high] = range(axis, false);
    const auto [low_of_body, high_of_body] = range(axis, true);
    const double overhang = std::min(low_of_body - low, high - high_of_body);
    return overhang > max_overhang * (high_of_body - low_of_body) ? 0 : high - low;
  };
  Vector3 axis = *std::max_element(axes.begin(), axes.end(),
                                   [&](const Vector3& a, const Vector3& b) { return extent(a) < extent(b); });
  const double volume = moments[body].volume;
  const Vector3 center = origin + moments[body].first / volume;
  if (const auto [low, high] = range(axis, true); high - axis.dot(center) < axis.dot(center) - low) {
    axis = -axis;
  }
  const auto [low, high] = range(axis, true);
  const double length = high - low;
  const double first = low + margin * length;
  const double step = (1 - 2 * margin) * length / (number_of_nodes - 1);
  const auto node_at = [&](const Vector3& point) {
    return Index(std::clamp(std::round((axis.dot(point) - first) / step), 0., double(number_of_nodes - 1)));
  };
  Rig_axis result{
      {}, surface.node_of_vertex, std::vector<Index>(number_of_nodes, no_index), std::vector<char>(number_of_nodes, 0)};
  // The radius of a cylinder as large and long.
  result.skeleton.radii.assign(number_of_nodes,
                               std::sqrt(std::abs(volume) / (boost::math::double_constants::pi * length)));
  for (Index node = 0; node < number_of_nodes; ++node) {
    result.skeleton.points.push_back(center + (first + node * step - axis.dot(center)) * axis);
    if (node > 0) {
      result.skeleton.edges.push_back({node - 1, node});
    }
  }
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    if (surface.node_of_vertex[v] != no_index) {
      result.node_of_vertex[v] = node_at(surface.points[v]);
    }
  }
  result.root = root ? node_at(parts.points[*root]) : 0;
  return result;
}

/// For each node, whether its part is small and thin, such as a strand of hair, a button or a belt. Such parts move
/// with the part that they are joined to.
std::vector<char> nodes_of_small_parts(const Skeleton& parts, double size)
{
  constexpr double max_radius = 0.02; // relative to the size, as are diagonals of boxes around parts:
  constexpr double max_diagonal = 0.3;
  Index number_of_parts = 0;
  const std::vector<Index> part = Disjoint_sets(parts.number_of_nodes(), parts.edges).numbers(number_of_parts);
  std::vector<Bounding_box> boxes(number_of_parts);
  std::vector<double> radii(number_of_parts, 0);
  for (Index node = 0; node < part.size(); ++node) {
    boxes[part[node]].extend(parts.points[node]);
    radii[part[node]] = std::max(radii[part[node]], parts.radii[node]);
  }
  std::vector<char> result;
  for (const Index its : part) {
    const bool is_small =
        radii[its] < max_radius * size && boxes[its].diagonal() + 2 * radii[its] < max_diagonal * size;
    result.push_back(is_small ? 1 : 0);
  }
  return result;
}

/// The skeleton itself, its components joined.
Rig_axis axis_of_limbs(const Skeleton& parts, const Assigned_surface& surface, double size, std::optional<Index> root)
{
  Rig_axis result{parts, surface.node_of_vertex, measure_branches(parts).branch_of_node,
                  nodes_of_small_parts(parts, size)};
  Simplification_parameters parameters;
  parameters.joins_components = true;
  simplify_skeleton(result.skeleton, parameters, nullptr);
  result.root = root.value_or(find_roots(result.skeleton, Root_rule::thickest).front());
  return result;
}

} // namespace

Rig make_rig(const Skeleton& parts, const Assigned_surface& surface, std::optional<Index> root)
{
  CGAL_precondition(parts.number_of_nodes() > 0 && parts.has_radii());
  constexpr double spread = 0.25; // in mean radii: seams vanish, and weights keep to their limbs
  const Bounding_box box(surface.points);
  const double size = (box.max() - box.min()).maxCoeff();
  std::optional<Rig_axis> axis = find_spine(parts, surface, root);
  if (!axis) {
    axis = axis_of_limbs(parts, surface, size, root);
  }
  const Skeleton& skeleton = axis->skeleton;
  const Joint_weights weights(*axis, size);
  Rig rig{weights.joints(), {}};
  rig.influences.reserve(surface.points.size());
  double sum_of_radii = 0;
  std::size_t number_of_vertices = 0;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const Index node = axis->node_of_vertex[v];
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
